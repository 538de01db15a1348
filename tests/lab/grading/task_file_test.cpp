#include "labmouse/lab/grading/task_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lab/mistake.hpp"

namespace labmouse {
namespace {

using test::Mistake;
using ::testing::ElementsAre;
using ::testing::SizeIs;
using namespace std::chrono_literals;

TEST(TaskFile, HasTasksOfAllKinds) {
  const TaskFileResult read = read_task_file(R"(
seed = "long and secret"
settings = { budget = 500 }
runs = 2
limits = { decision = 0.5 }
show_hidden = true

[[task]]
name = "finishes capstone-1"
points = 5
mazes = ["capstone-1"]
finish = true

[[task]]
name = "at most 1.3 of the bound on twenty hidden mazes"
points = 7.5
hidden = 20
kind = "prim"
side = 8
at_most = { ratio = 1.3, known_wall_hits = 0, search_steps = 400 }
per_maze = true
)");
  ASSERT_THAT(read.problems, SizeIs(0));
  const TaskFile& file = read.file;
  EXPECT_EQ(file.seed, "long and secret");
  EXPECT_EQ(file.world.entry->make(file.world.settings).world->traits().rules_in_steps->budget, 500);
  EXPECT_EQ(file.runs, 2);
  EXPECT_EQ(file.limits.over({}).decision, 500ms);
  EXPECT_TRUE(file.show_hidden);
  ASSERT_THAT(file.tasks, SizeIs(2));
  EXPECT_EQ(file.tasks[0].name, "finishes capstone-1");
  EXPECT_EQ(file.tasks[0].points, 5.0);
  EXPECT_THAT(file.tasks[0].mazes, ElementsAre("capstone-1"));
  EXPECT_TRUE(file.tasks[0].finish);
  EXPECT_FALSE(file.tasks[0].per_maze);
  EXPECT_EQ(file.tasks[0].line, 8);
  const Task& second = file.tasks[1];
  EXPECT_EQ(second.points, 7.5);
  EXPECT_EQ(second.hidden.count, 20);
  EXPECT_EQ(second.hidden.kind, "prim");
  EXPECT_EQ(second.hidden.side, 8);
  EXPECT_FALSE(second.finish);
  EXPECT_TRUE(second.per_maze);
  ASSERT_THAT(second.at_most, SizeIs(3));
  EXPECT_EQ(second.at_most[0].figure, "ratio");
  EXPECT_EQ(second.at_most[0].most, 1.3);
  EXPECT_EQ(second.at_most[1].figure, "known_wall_hits");
  EXPECT_EQ(second.at_most[2].most, 400.0);
}

TEST(TaskFile, MayNameAWorldThatHasOtherSettingsAndFigures) {
  const TaskFileResult read = read_task_file(
      "seed = 7\nworld = 'physical'\nsettings = { robot = 'classic', noise = 0.5 }\n"
      "[[task]]\nname = 'a'\npoints = 1\nmazes = ['m']\nat_most = { search_us = 1e8 }\n");
  ASSERT_THAT(read.problems, SizeIs(0));
  EXPECT_EQ(read.file.seed, "7");
  EXPECT_EQ(read.file.world.entry->name, "physical");
  EXPECT_EQ(read.file.world.settings.at("robot"), "classic");
  EXPECT_EQ(read.file.world.settings.at("noise"), "0.5");
}

/// A task that is right, with these lines behind it.
std::string task_with(const std::string& lines) { return "[[task]]\nname = 'a'\npoints = 5\n" + lines; }

class TaskFileMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(TaskFileMistakes, AreToldWhereTheyStand) {
  const TaskFileResult read = read_task_file(GetParam().text);
  EXPECT_THAT(read.file.tasks, SizeIs(0));
  test::expect_first(read.problems, GetParam());
}

const std::string required = "finish = true\n";
const std::string whole = "mazes = ['m']\n" + required;

INSTANTIATE_TEST_SUITE_P(
    All, TaskFileMistakes,
    testing::Values(Mistake{"", 1, 1, {"[[task]]"}}, Mistake{"[[task]\n", 1, 8, {}},
                    Mistake{"task = 3\n", 1, 1, {"[[task]]"}},
                    Mistake{"sead = 3\n" + task_with(whole), 1, 1, {"'sead'", "'seed'"}},
                    Mistake{"seed = ''\n" + task_with(whole), 1, 8, {"'seed'"}},
                    Mistake{"seed = 1.5\n" + task_with(whole), 1, 8, {"'seed'"}},
                    Mistake{"world = 'moon'\n" + task_with(whole), 1, 9, {"'moon'"}},
                    Mistake{"settings = 3\n" + task_with(whole), 1, 12, {"'settings'"}},
                    Mistake{"settings = { budgt = 3 }\n" + task_with(whole), 1, 14, {"'budgt'", "'budget'"}},
                    Mistake{"settings = { budget = 0 }\n" + task_with(whole), 1, 23, {"'budget'", "1"}},
                    Mistake{"settings = { budget = [] }\n" + task_with(whole), 1, 23, {"'budget'", "number"}},
                    Mistake{"runs = 0\n" + task_with(whole), 1, 8, {"'runs'"}},
                    Mistake{"limits = { decison = 1 }\n" + task_with(whole), 1, 12, {"'decision'"}},
                    Mistake{"show_hidden = 1\n" + task_with(whole), 1, 15, {"true or false"}},
                    Mistake{"[[task]]\npoints = 5\n" + whole, 1, 1, {"name"}},
                    Mistake{"[[task]]\nname = 'a'\n" + whole, 1, 1, {"points"}},
                    Mistake{"[[task]]\nname = 'a'\npoints = -1\n" + whole, 3, 10, {"'points'", "0"}},
                    Mistake{task_with(whole) + task_with(whole), 7, 8, {"'a'", "twice"}},
                    Mistake{task_with("mazes = ['m']\n"), 1, 1, {"finish", "at_most"}},
                    Mistake{task_with(required), 1, 1, {"mazes", "hidden"}},
                    Mistake{task_with("mazes = 'm'\n" + required), 4, 9, {"list"}},
                    Mistake{task_with("mazes = ['']\n" + required), 4, 9, {"empty"}},
                    Mistake{task_with("hidden = 0\n" + required), 4, 10, {"'hidden'"}},
                    Mistake{task_with("kind = 'prim'\n" + whole), 4, 8, {"'kind'", "hidden"}},
                    Mistake{task_with("hidden = 3\nkind = 'primm'\n" + required), 5, 8, {"'primm'"}},
                    Mistake{task_with("hidden = 3\nside = 3\n" + required), 5, 8, {}},
                    Mistake{task_with("mazes = ['m']\nat_most = 1.3\n"), 5, 11, {"table"}},
                    Mistake{task_with("mazes = ['m']\nat_most = { ration = 1.3 }\n"), 5, 13, {"'ration'", "'ratio'"}},
                    Mistake{task_with("mazes = ['m']\nat_most = { ratio = 'x' }\n"), 5, 21, {"'ratio'"}},
                    // A time by the clock would make grades differ from run to run.
                    Mistake{
                        task_with("mazes = ['m']\nat_most = { microseconds_per_decision = 3 }\n"), 5, 13, {"unknown"}},
                    Mistake{"world = 'physical'\n" + task_with("mazes = ['m']\nat_most = { known_wall_hits = 0 }\n"),
                            6,
                            13,
                            {"'known_wall_hits'"}}),
    [](const auto& test) { return "mistake_" + std::to_string(test.index); });

TEST(TaskFile, TellsAllMistakesAtOnce) {
  EXPECT_THAT(read_task_file("run = 1\n[[task]]\nnam = 'a'\npoints = 'x'\n").problems, SizeIs(6));
}

}  // namespace
}  // namespace labmouse
