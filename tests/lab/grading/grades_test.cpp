#include "labmouse/lab/grading/grades.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/system/files.hpp"
#include "tests/lab/reports/unpacking.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* corridor = "o---o---o---o\n| S       G |\no---o---o---o\n";

/// A course in a folder, with built-in mice as students.
class ACourse : public testing::Test {
 protected:
  ACourse() {
    save("near.txt", corridor);
    save("mazes/far.txt", corridor);
  }

  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
  void save(const std::string& name, const std::string& content) const {
    EXPECT_EQ(write_file(path(name), content), "");
  }

  GradingPlan plan(const std::string& tasks) const {
    TaskFileResult read = read_task_file(tasks);
    for (const Problem& problem : read.problems) ADD_FAILURE() << describe("tasks.toml", problem);
    if (!read.problems.empty()) return {};
    return plan_grading(std::move(read.file), path("tasks.toml"));
  }
  Grades grade(const std::string& tasks, const std::vector<std::string>& mice, int jobs = 0) const {
    const GradingPlan made = plan(tasks);
    EXPECT_THAT(made.errors, IsEmpty());
    std::string class_text;
    for (const std::string& mouse : mice)
      class_text += "[[mouse]]\nname = 'the " + mouse + "'\nmouse = '" + mouse + "'\n";
    save("class.toml", class_text);
    const ClassResult read = read_class(path("class.toml"), class_text, {});
    EXPECT_THAT(read.problems, IsEmpty());
    ClassOrder order;
    order.jobs = jobs;
    return grades_of(made, run_class(made, read.students, order));
  }
  /// The points of one student in one task with these lines.
  double points(const std::string& mouse, const std::string& lines) const {
    return grade("seed = 3\n[[task]]\nname = 'a'\npoints = 12\n" + lines, {mouse}).students[0].points;
  }

  test::AFolder folder_;
};

std::vector<std::string> names_of(const GradingPlan& plan) {
  std::vector<std::string> names;
  for (const GradedMaze& maze : plan.mazes) names.push_back(maze.maze.name);
  return names;
}

TEST_F(ACourse, NamesItsMazesAsItsFileDoes) {
  const GradingPlan made = plan(
      "[[task]]\nname = 'a'\npoints = 1\nfinish = true\nmazes = ['near.txt', 'mazes', 'capstone-1']\n"
      "[[task]]\nname = 'b'\npoints = 1\nfinish = true\nmazes = ['mazes/*.txt', 'near.txt']\n");
  EXPECT_THAT(made.errors, IsEmpty());
  EXPECT_THAT(names_of(made), ElementsAre("near.txt", "mazes/far.txt", "capstone-1"));
  EXPECT_THAT(made.mazes_of, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(1, 0)));
  EXPECT_THAT(made.files, testing::Contains(path("near.txt")));
}

constexpr const char* two_hidden_tasks =
    "[[task]]\nname = 'a'\npoints = 1\nfinish = true\nhidden = 2\n"
    "[[task]]\nname = 'b'\npoints = 1\nfinish = true\nhidden = 3\n"
    "[[task]]\nname = 'c'\npoints = 1\nfinish = true\nhidden = 1\nside = 8\nkind = 'prim'\n";

TEST_F(ACourse, SharesHiddenMazesBetweenTasks) {
  const GradingPlan made = plan(std::string("seed = 'secret'\n") + two_hidden_tasks);
  EXPECT_THAT(names_of(made), ElementsAre("hidden 1", "hidden 2", "hidden 3", "hidden 4"));
  EXPECT_THAT(made.mazes_of, ElementsAre(ElementsAre(0, 1), ElementsAre(0, 1, 2), ElementsAre(3)));
  EXPECT_EQ(made.mazes[2].maze.maze.size(), (Size{16, 16}));
  EXPECT_EQ(made.mazes[3].maze.maze.size(), (Size{8, 8}));
  EXPECT_NE(made.mazes[0].maze.maze, made.mazes[1].maze.maze);
  for (const GradedMaze& maze : made.mazes) EXPECT_TRUE(maze.hidden);
}

TEST_F(ACourse, HasOtherHiddenMazesWithAnotherSeed) {
  const auto first_with = [&](const std::string& seed) {
    return plan("seed = " + seed + "\n" + two_hidden_tasks).mazes.front().maze.maze;
  };
  EXPECT_EQ(first_with("'secret'"), first_with("'secret'"));
  EXPECT_NE(first_with("'secret'"), first_with("'secret.'"));
  EXPECT_EQ(first_with("12"), first_with("'12'"));
}

TEST_F(ACourse, NeedsASeedForHiddenMazes) {
  const GradingPlan made = plan(two_hidden_tasks);
  ASSERT_THAT(made.errors, SizeIs(1));
  EXPECT_THAT(made.errors[0], test::SaysAt(path("tasks.toml") + ":1:1", "seed", "--seed-file"));
}

TEST_F(ACourse, GivesAllPointsOrNone) {
  EXPECT_EQ(points("flood", "mazes = ['capstone-1', 'near.txt']\nfinish = true\n"), 12.0);
  EXPECT_EQ(points("wall-right", "mazes = ['capstone-1', 'near.txt']\nfinish = true\n"), 0.0);
}

TEST_F(ACourse, GivesASharePerMaze) {
  const Grades grades =
      grade("[[task]]\nname = 'a'\npoints = 12\nmazes = ['capstone-1', 'near.txt']\nfinish = true\nper_maze = true\n",
            {"wall-right"});
  EXPECT_EQ(grades.points, 12.0);
  EXPECT_EQ(grades.students[0].points, 6.0);
  EXPECT_EQ(grades.students[0].name, "the wall-right");
  EXPECT_EQ(grades.students[0].broken, "");
  const TaskGrade& task = grades.students[0].tasks[0];
  EXPECT_THAT(task.lost, test::Says("1 of 2", "capstone-1: out of steps"));
  EXPECT_EQ(task.contests[0].lost, "out of steps");
  EXPECT_EQ(task.contests[1].lost, "");
  EXPECT_TRUE(task.contests[1].score.has_value());
}

TEST_F(ACourse, ComparesTheMeanOfAFigure) {
  // The oracle attains the bound in both; flood does not in capstone-1, where alone it is judged per maze.
  const std::string mazes = "mazes = ['capstone-1', 'near.txt']\n";
  EXPECT_EQ(points("oracle", mazes + "at_most = { ratio = 1 }\n"), 12.0);
  const GradedContest contest =
      grade("[[task]]\nname = 'a'\npoints = 1\nmazes = ['capstone-1']\nfinish = true\n", {"flood"})
          .students[0]
          .tasks[0]
          .contests[0];
  const double ratio = *contest.score / *contest.best;
  ASSERT_GT(ratio, 1.02);
  const auto limit = [&](double number) { return "at_most = { ratio = " + std::to_string(number) + " }\n"; };
  const double mean = (ratio + 1.0) / 2.0;
  EXPECT_EQ(points("flood", mazes + limit(mean + 0.001)), 12.0);
  EXPECT_EQ(points("flood", mazes + limit(mean - 0.001)), 0.0);
  EXPECT_EQ(points("flood", mazes + limit(mean + 0.001) + "per_maze = true\n"), 6.0);
  EXPECT_EQ(points("flood", mazes + limit(ratio + 0.001) + "per_maze = true\n"), 12.0);
}

TEST_F(ACourse, CountsAFailedContestAtTheLimit) {
  // The best possible score of capstone-1 is 17.6, and a failed contest counts 100.
  const std::string maze = "mazes = ['capstone-1']\n";
  EXPECT_EQ(points("wall-right", maze + "at_most = { ratio = 5.7 }\n"), 12.0);
  EXPECT_EQ(points("wall-right", maze + "at_most = { ratio = 5.6 }\n"), 0.0);
  EXPECT_EQ(points("wall-right", maze + "at_most = { score = 100 }\n"), 12.0);
  EXPECT_EQ(points("wall-right", maze + "at_most = { score = 99.9 }\n"), 0.0);
  // It never had a speed run, whose steps could be at most so many.
  EXPECT_EQ(points("wall-right", maze + "at_most = { speed_steps = 100000 }\n"), 0.0);
  EXPECT_EQ(points("wall-right", maze + "at_most = { known_wall_hits = 0 }\n"), 12.0);
}

TEST_F(ACourse, GradesTheSameWithAnyNumberOfThreads) {
  const std::string tasks = std::string("seed = 'secret'\n") + two_hidden_tasks;
  const auto lost_with = [&](int jobs) {
    std::string text;
    for (const StudentGrade& student : grade(tasks, {"flood", "random", "wall-right"}, jobs).students)
      for (const TaskGrade& task : student.tasks)
        for (const GradedContest& contest : task.contests)
          text += contest.maze + contest.outcome + std::to_string(contest.score.value_or(0.0)) + contest.lost + "\n";
    return text;
  };
  EXPECT_EQ(lost_with(1), lost_with(3));
  EXPECT_THAT(lost_with(2), HasSubstr("hidden 4"));
}

TEST_F(ACourse, GivesNothingToAMouseOfAnotherWorld) {
  const Grades grades = grade("[[task]]\nname = 'a'\npoints = 1\nmazes = ['near.txt']\nfinish = true\n", {"festina"});
  EXPECT_EQ(grades.students[0].points, 0.0);
  EXPECT_THAT(grades.students[0].broken, HasSubstr("festina"));
  EXPECT_THAT(grades.students[0].tasks[0].contests, IsEmpty());
}

TEST(CourseTemplate, IsATaskFileThatLacksOnlyItsSeed) {
  const std::string path = LABMOUSE_SOURCE_DIR "/templates/course/tasks.toml";
  TaskFileResult read = read_task_file(read_file(path).content);
  for (const Problem& problem : read.problems) ADD_FAILURE() << describe(path, problem);
  EXPECT_EQ(read.file.seed, "");
  read.file.seed = "secret";
  const GradingPlan made = plan_grading(std::move(read.file), path);
  EXPECT_THAT(made.errors, IsEmpty());
  EXPECT_THAT(made.mazes_of, SizeIs(3));
}

TEST(PointsText, HasNoMoreDecimalsThanItNeeds) {
  EXPECT_EQ(points_text(5.0), "5");
  EXPECT_EQ(points_text(7.5), "7.5");
  EXPECT_EQ(points_text(1.0 / 3.0), "0.33");
  EXPECT_EQ(points_text(100.0), "100");
  EXPECT_EQ(points_text(0.0), "0");
}

}  // namespace
}  // namespace labmouse
