// Every mouse in every maze of a folder of real ones: odd goals, unreachable areas, open goal rooms, 32x32.
#include <gtest/gtest.h>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/routes.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/mouse_name.hpp"

namespace labmouse {
namespace {

struct NamedMaze {
  std::string file;
  Maze maze;
  bool has_route = false;
};

const std::vector<NamedMaze>& real_mazes() {
  static const std::vector<NamedMaze> mazes = [] {
    std::vector<NamedMaze> read;
    for (const auto& file : test::maze_files())
      if (auto maze = test::maze_in_file(file)) {
        const bool has_route = shortest_in_cells(*maze).has_value();
        read.push_back({file.filename(), std::move(*maze), has_route});
      }
    return read;
  }();
  return mazes;
}

void expect_good_end(const RunRecord& record, bool has_route) {
  if (record.outcome == Outcome::finished) return;
  if (record.outcome != Outcome::forfeit) {
    EXPECT_EQ(record.steps.size(), 1000U);
    return;
  }
  EXPECT_FALSE(has_route);
  EXPECT_EQ(record.steps.back().action.reason, ForfeitReason::no_route);
}

class InRealMazes : public testing::TestWithParam<const BuiltinMouse*> {};

void expect_good_contest(const BuiltinMouse& entry, const Settings& settings, const NamedMaze& maze) {
  SCOPED_TRACE(maze.file);
  const auto mouse = entry.make(brief(maze.maze, {}, 1), settings);
  const RunRecord record = run(maze.maze, {}, *mouse);
  expect_good_end(record, maze.has_route);
  for (const StepRecord& step : record.steps) ASSERT_FALSE(step.blocked) << "step " << step.step;
}

TEST_P(InRealMazes, EndsInAGoalOrAtItsBudgetAndRunsIntoNoWall) {
  if (real_mazes().empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  for (std::size_t i = 0; i < real_mazes().size(); i += test::slowness)
    expect_good_contest(*GetParam(), Settings(GetParam()->parameters), real_mazes()[i]);
}

TEST_P(InRealMazes, DoesSoByEveryMethodThatItCanBeGiven) {
  if (real_mazes().empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  for (const Parameter& parameter : GetParam()->parameters) {
    const bool flag = parameter.type == ParameterType::flag;
    if (parameter.name == "ties" || (!flag && parameter.choices.empty())) continue;
    for (const std::string_view value : flag ? std::vector<std::string_view>{"yes", "no"} : choices_of(parameter)) {
      SCOPED_TRACE(std::string(parameter.name) + "=" + std::string(value));
      Settings settings(GetParam()->parameters);
      settings.set(parameter.name, value);
      // Every fifth maze: the methods are many.
      for (std::size_t i = 0; i < real_mazes().size(); i += 5 * test::slowness)
        expect_good_contest(*GetParam(), settings, real_mazes()[i]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltinMice, InRealMazes, testing::ValuesIn(builtin_mice().begin(), builtin_mice().end()),
                         test::mouse_name);

}  // namespace
}  // namespace labmouse
