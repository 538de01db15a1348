#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::SaysAt;
using ::testing::HasSubstr;
using ::testing::Not;

/// A contest of a flood in the loop that was given so many steps.
RecordFile short_of_steps(int budget) {
  Rules rules;
  rules.budget = budget;
  const NamedMaze maze = test::loop();
  const Contestant mouse = test::mice("flood").front();
  const auto strategy = mouse.strategy(maze.maze, brief(maze.maze, rules, 1));
  return record_file_of(mouse, maze, rules, 1, run(maze.maze, rules, *strategy));
}

TEST(ResultLine, SaysWhereAMouseStoodThatDidNotSolveIt) {
  RecordFile file = short_of_steps(2);
  EXPECT_THAT(result_line(file),
              SaysAt("flood in loop", "out of steps at (0,4) heading north", "2 search", "0 speed", "bound 4.167"));
  file.run.end = {{3, 1}, Heading::west};
  EXPECT_THAT(result_line(file), HasSubstr("out of steps at (3,1) heading west"));
  EXPECT_THAT(result_line(test::recorded("flood", test::without_route())),
              SaysAt("flood in without-route", "forfeit (no route) at (0,0) heading north", "1 search", "0 speed",
                     "; the goal"));
}

TEST(ResultLine, DoesNotForAFinishedContestOrACutRecord) {
  EXPECT_THAT(result_line(test::recorded("flood")), Not(HasSubstr("heading")));
  RecordFile cut = short_of_steps(2);
  cut.ended = false;
  EXPECT_THAT(result_line(cut), SaysAt("flood in loop", "breaks off after step 2;", "bound 4.167"));
}

TEST(Title, ShortensALongCommand) {
  RecordFile file = short_of_steps(2);
  EXPECT_EQ(title_of(file), "flood in loop: out of steps");
  file.mouse = "program:python3 /home/somebody/mice/robot.py";
  EXPECT_EQ(title_of(file), "... /home/somebody/mice/robot.py in loop: out of steps");
  EXPECT_THAT(picture_of(file), HasSubstr(": out of steps</text>"));
}

}  // namespace
}  // namespace labmouse
