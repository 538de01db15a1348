// Mice with a prior that was learned: from a file that their SPEC names, or from the mazes that they are taught with.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/mice/prior_file.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/studies/prior_lesson.hpp"
#include "labmouse/lab/studies/study.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/mouse/priors.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::ElementsAre;

/// In an empty folder, with a prior that finds every wall closed and one that finds every wall open.
class LearnedMice : public testing::Test {
 protected:
  LearnedMice() { std::filesystem::create_directories(folder_); }
  ~LearnedMice() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string file(const std::string& name, const std::string& content) const {
    EXPECT_EQ(write_file(path(name), content), "");
    return path(name);
  }
  std::string prior(const std::string& name, const WallPrior& prior) const {
    return file(name, write_prior(prior, {}));
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("labmouse-priors-" + std::to_string(getpid()) + "-" +
                                                testing::UnitTest::GetInstance()->current_test_info()->name());
};

Contestant mouse(const std::string& spec) {
  SpecResult result = read_specs(spec);
  EXPECT_EQ(result.error, "");
  return result.contestants.empty() ? Contestant() : result.contestants.front();
}

std::string error(const std::string& spec) { return read_specs(spec).error; }

/// All that the mouse does in some mazes.
std::vector<RunRecord> runs_of(const Contestant& contestant, Size size = {16, 16}) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Maze maze = wilson_generator.make({size, seed, 100});
    runs.push_back(run(maze, {}, *contestant.strategy(maze, brief(maze, {}, 1))));
  }
  return runs;
}

/// Smaller than those that the compiled-in prior is for.
constexpr Size small = {7, 7};

TEST_F(LearnedMice, ExpectWhatTheFileSays) {
  const std::string given = prior("given.prior", contest_prior), other = prior("trees.prior", loop_free_prior);
  EXPECT_EQ(runs_of(mouse("ariadne:prior=" + given)), runs_of(mouse("ariadne")));
  EXPECT_NE(runs_of(mouse("ariadne:prior=" + other)), runs_of(mouse("ariadne")));
  EXPECT_NE(runs_of(mouse("ariadne:prior=" + other)), runs_of(mouse("ariadne:prior=uniform")));
}

TEST_F(LearnedMice, ExpectItAtEverySize) {
  const std::string trees = prior("trees.prior", loop_free_prior);
  ASSERT_EQ(runs_of(mouse("ariadne"), small), runs_of(mouse("ariadne:prior=uniform"), small));
  EXPECT_NE(runs_of(mouse("ariadne:prior=" + trees), small), runs_of(mouse("ariadne"), small));
}

TEST_F(LearnedMice, AreNamedAfterTheirFile) {
  const std::string spec = "ariadne:prior=" + prior("my.prior", contest_prior) + ":travel=30";
  EXPECT_EQ(mouse(spec).name, spec);
  EXPECT_EQ(mouse("ariadne:prior=contest").name, "ariadne");
  EXPECT_EQ(mouse("ariadne:prior=uniform").name, "ariadne:prior=uniform");
}

TEST_F(LearnedMice, ReadTheirFileOnce) {
  const std::string path = prior("my.prior", loop_free_prior);
  const Contestant learned = mouse("ariadne:prior=" + path);
  const std::vector<RunRecord> before = runs_of(learned);
  std::filesystem::remove(path);
  EXPECT_EQ(runs_of(learned), before);
  const Setting travel = {"travel", std::string(learned.settings.choice("travel"))};
  const SpecResult variant = read_variant(learned, {&travel, 1});
  ASSERT_EQ(variant.error, "");
  EXPECT_EQ(runs_of(variant.contestants.front()), before);
}

TEST_F(LearnedMice, ForgetTheirFileForAChoice) {
  const std::string spec = "ariadne:prior=" + prior("my.prior", loop_free_prior);
  const std::vector<std::string> values = {"uniform", "contest"};
  const SpecResult variants = read_variants(spec, "prior", values);
  ASSERT_EQ(variants.error, "");
  EXPECT_EQ(runs_of(variants.contestants[0]), runs_of(mouse("ariadne:prior=uniform")));
  EXPECT_EQ(runs_of(variants.contestants[1]), runs_of(mouse("ariadne")));
}

TEST_F(LearnedMice, AreNoneWhereTheFileIsBad) {
  const std::string bad = file("bad.prior", "// labmouse prior 1\n1,2,x,\n");
  EXPECT_THAT(error("ariadne:prior=" + bad), Says(bad + ":2:5: ", "0 to 255", "'x'"));
  EXPECT_THAT(error("ariadne:prior=" + path("no.prior")), Says(path("no.prior") + ": ", "no such", "':' and ','"));
  EXPECT_THAT(error("ariadne:prior=" + folder_.string()), Says(folder_.string() + ": ", "is a folder", "':' and ','"));
  EXPECT_THAT(error("ariadne:prior=contst"), Says("contst: ", "no such", "'contest'"));
  EXPECT_THAT(error("ariadne:prior="), Says("''", "'prior'", "'ariadne'", "contest/uniform"));
  EXPECT_THAT(error("ariadne:prior=\x1b[31m"), Says("'[31m'", "unprintable"));
}

std::vector<NamedMaze> mazes(int count) {
  std::vector<NamedMaze> mazes;
  for (int i = 0; i < count; ++i) {
    const auto seed = static_cast<std::uint64_t>(i + 1);
    mazes.push_back({"prim-" + std::to_string(i), prim_generator.make({{9, 9}, seed, 200})});
  }
  return mazes;
}

std::vector<const Maze*> pointers_to(const std::vector<NamedMaze>& mazes) {
  std::vector<const Maze*> pointers;
  for (const NamedMaze& maze : mazes) pointers.push_back(&maze.maze);
  return pointers;
}

TEST_F(LearnedMice, CanBeTaughtWhereTheirPriorIsTheDefault) {
  EXPECT_TRUE(mouse("ariadne").taught);
  EXPECT_TRUE(mouse("ariadne:travel=30").taught);
  EXPECT_FALSE(mouse("ariadne:prior=uniform").taught);
  EXPECT_FALSE(mouse("ariadne:prior=" + prior("my.prior", contest_prior)).taught);
  EXPECT_FALSE(mouse("flood").taught);
  EXPECT_FALSE(mouse("oracle").taught);
}

TEST_F(LearnedMice, RaceAsIfTheyHadAFileOfTheMazesThatTheyAreTaughtWith) {
  const std::vector<NamedMaze> training = mazes(5);
  const std::string learned = file("five.prior", file_of(hold_lesson(training, *first_world())));
  const Contestant taught = mouse("ariadne:travel=30").taught(pointers_to(training), Rules(), nullptr);
  EXPECT_EQ(taught.name, "ariadne:travel=30");
  const Contestant from_file = mouse("ariadne:travel=30:prior=" + learned);
  EXPECT_EQ(runs_of(taught), runs_of(from_file));
  EXPECT_EQ(runs_of(taught, small), runs_of(from_file, small));
  EXPECT_NE(runs_of(taught), runs_of(mouse("ariadne:travel=30")));
}

TEST_F(LearnedMice, AreTaughtAnewForEachFoldOfAStudy) {
  StudyOrder order;
  order.race = test::in_steps();
  order.folds = 3;
  const Study study = hold_study({mouse("ariadne"), mouse("flood")}, mazes(6), order);
  EXPECT_THAT(study.learners, ElementsAre("ariadne"));
  EXPECT_THAT(table_of(study, false), Says("Taught", "4 mazes", ": ariadne.\n"));
  // Each contest goes as by a mouse with a file of the mazes of the other folds.
  for (int fold = 0; fold < 3; ++fold) {
    std::vector<NamedMaze> training, held_out;
    for (std::size_t i = 0; i < study.race.mazes.size(); ++i)
      (study.fold_of[i] == fold ? held_out : training).push_back(study.race.mazes[i]);
    const std::string learned = file("fold.prior", file_of(hold_lesson(training, *first_world())));
    const Race race = hold_race({mouse("ariadne:prior=" + learned)}, held_out, test::in_steps());
    std::vector<std::optional<double>> expected, scores;
    for (const ContestResult& contest : race.results) expected.push_back(contest.score);
    for (std::size_t i = 0; i < study.race.mazes.size(); ++i)
      if (study.fold_of[i] == fold) scores.push_back(study.race.results[i].score);
    EXPECT_EQ(scores, expected);
  }
}

}  // namespace
}  // namespace labmouse
