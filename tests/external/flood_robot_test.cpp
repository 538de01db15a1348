// The bridge and the simulator against each other: `flood`, written once more as a capstone robot, does step by step
// what the built-in mouse does.
#include <gtest/gtest.h>

#include <map>

#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/steps/steps_world.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/external/capstone_fixture.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

const std::string robot = "capstone:" LABMOUSE_SOURCE_DIR "/tests/external/robots/flood.py";

/// Whether a maze is as a robot takes it to be that is told no more than a size: square, from the corner northwards to
/// the four cells in the centre; and the goal can be reached, without which the robot cannot end as the mouse does.
bool as_in_the_project(const Maze& maze) {
  const auto [width, height] = maze.size();
  if (width != height || width % 2 != 0 || maze.start() != Cell{0, 0} || maze.start_heading() != Heading::north)
    return false;
  CellSet centre;
  for (const int x : {width / 2 - 1, width / 2})
    for (const int y : {width / 2 - 1, width / 2}) centre.insert({x, y});
  return maze.goals() == centre && bound_of(maze, {}).optimum.has_value();
}

/// Races both in those mazes and compares all that happened.
void expect_equal_records(const std::vector<NamedMaze>& mazes, const std::string& python) {
  ExternalOptions options;
  options.python = python;
  options.limits = test::patient();
  SpecResult mice = read_specs("flood," + robot, options);
  ASSERT_EQ(mice.error, "");
  std::map<std::size_t, std::map<std::size_t, RunRecord>> records;  // by maze and mouse
  RaceHooks hooks;
  hooks.finished = [&](const Race&, const ContestResult& contest, const ContestOutput& held) {
    records[contest.maze][contest.mouse] = held.run.value();
  };
  RaceOrder order;
  order.world = steps_world();
  const Race race = hold_race(std::move(mice.contestants), mazes, order, hooks);
  ASSERT_EQ(records.size(), mazes.size());
  for (const auto& [maze, of] : records) {
    SCOPED_TRACE(race.mazes[maze].name);
    EXPECT_EQ(of.at(0).steps.size(), of.at(1).steps.size());
    EXPECT_TRUE(of.at(0) == of.at(1)) << of.at(0).last_words;
    EXPECT_EQ(of.at(0).outcome, Outcome::finished);
  }
}

TEST(TheRobotFlood, DoesWhatTheMouseDoesInTheBuiltinMazes) {
  if (test::python3().empty()) GTEST_SKIP() << "no python3 that runs is in PATH";
  std::vector<NamedMaze> mazes;
  std::vector<std::string> others;
  for (NamedMaze& maze : load_builtin_mazes().mazes)
    if (as_in_the_project(maze.maze))
      mazes.push_back(std::move(maze));
    else
      others.push_back(maze.name);
  // The goal of the one is in a corner, and the other is of odd size.
  EXPECT_EQ(others, (std::vector<std::string>{"parallel-8", "spiral-9"}));
  std::size_t place = 0;
  std::erase_if(mazes, [&](const NamedMaze&) { return place++ % static_cast<std::size_t>(test::slowness) != 0; });
  expect_equal_records(mazes, test::python3());
}

TEST(TheRobotFlood, DoesSoUnderPython2) {
  if (test::python2().empty()) GTEST_SKIP() << "no python2 that runs is in PATH";
  const std::vector<std::string> names = {"capstone-1", "contest-05", "contest-28-01", "onion-12"};
  expect_equal_records(load_mazes(names).mazes, test::python2());
}

TEST(TheRobotFlood, DoesWhatTheMouseDoesInRealMazes) {
  if (test::maze_files().empty())
    GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  if (test::python3().empty()) GTEST_SKIP() << "no python3 that runs is in PATH";
  std::vector<NamedMaze> mazes;
  const auto files = test::maze_files();
  for (std::size_t i = 0; i < files.size(); i += 4 * test::slowness)
    if (auto maze = test::maze_in_file(files[i]); maze && as_in_the_project(*maze))
      mazes.push_back({files[i].string(), std::move(*maze)});
  expect_equal_records(mazes, test::python3());
}

}  // namespace
}  // namespace labmouse
