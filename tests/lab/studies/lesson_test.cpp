#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/mice/prior_file.hpp"
#include "labmouse/lab/studies/prior_lesson.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "labmouse/maze/symmetry.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::HasSubstr;

Lesson lesson_of(std::vector<NamedMaze> mazes) { return hold_lesson(std::move(mazes), *first_world()); }

NamedMaze mirrored_loop() { return {"mirrored", transformed(test::loop().maze, {true, 1})}; }

TEST(ALesson, GivesEqualBytesForEqualMazesInAnyOrder) {
  const std::string file = file_of(lesson_of({test::loop(), test::hook(), test::corridor()}));
  EXPECT_EQ(file_of(lesson_of({test::corridor(), test::loop(), test::hook()})), file);
  EXPECT_NE(file_of(lesson_of({test::corridor(), test::hook()})), file);
}

TEST(ALesson, IsThePriorOfItsMazes) {
  const Maze loop = test::loop().maze, hook = test::hook().maze;
  const std::vector<const Maze*> mazes = {&hook, &loop};
  const std::string file = file_of(lesson_of({test::loop(), test::hook()}));
  EXPECT_EQ(read_prior(file).prior, learn_prior(mazes, Rules()));
  EXPECT_THAT(file, HasSubstr(" from 2 mazes.\n// Sizes: 1 of 2x2, 1 of 5x5.\n"));
}

TEST(ALesson, CountsTheSameWallsOnceAndLeavesOutWhatHasNoRoute) {
  const Lesson lesson = lesson_of({mirrored_loop(), test::loop(), test::without_route()});
  EXPECT_EQ(file_of(lesson), file_of(lesson_of({test::loop()})));
  EXPECT_EQ(lesson.error, "");
  EXPECT_THAT(summary_of(lesson),
              Says("1 duplicate", ":\n  mirrored = loop\n", "1 maze left out", ":\n  without-route\n"));
}

TEST(ALesson, SaysWhatItCounted) {
  const Lesson lesson = lesson_of({test::loop(), test::hook()});
  const PriorFit fit = fit_of(lesson.counts);
  EXPECT_GT(fit.walls, 50);
  EXPECT_LT(fit.log_loss, fit.entropy);
  EXPECT_THAT(summary_of(lesson), testing::MatchesRegex("2 mazes, " + std::to_string(fit.walls) +
                                                        " walls[^\n]* 0[.][0-9]+[^\n]* 0[.][0-9]+[^\n]*\n"));
}

TEST(ALesson, NamesNoMaze) {
  EXPECT_THAT(file_of(lesson_of({{"/secret/folder/loop.txt", test::loop().maze}})), Not(HasSubstr("loop")));
}

TEST(ALesson, TakesAMazeWithARoute) {
  EXPECT_THAT(lesson_of({}).error, Says("route", "0 given"));
  EXPECT_THAT(lesson_of({test::without_route()}).error, Says("route", "1 given"));
}

TEST(ALesson, MayBeStopped) {
  std::atomic<bool> stop{false};
  std::vector<std::size_t> told;
  const LessonHooks hooks = {[&](std::size_t all) {
                               told.push_back(all);
                               stop = told.size() == 2;
                             },
                             &stop};
  const Lesson lesson = hold_lesson({test::loop(), test::hook(), test::corridor()}, *first_world(), hooks);
  EXPECT_THAT(told, testing::ElementsAre(3U, 3U));
  EXPECT_EQ(lesson.done, 2U);
  EXPECT_THAT(summary_of(lesson), Says("Stopped", "2 of 3 mazes", "no prior"));
}

}  // namespace
}  // namespace labmouse
