// What the tests of the wandering mice share.
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <utility>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse::test {

/// A run with some parameters set.
inline RunRecord wander(const RosterEntry& mouse, const Maze& maze, std::uint64_t seed,
                        std::initializer_list<std::pair<std::string_view, std::string_view>> set = {},
                        int budget = 20'000) {
  Settings settings(mouse.parameters);
  for (const auto& [name, value] : set) settings.set(name, value);
  Rules rules;
  rules.budget = budget;
  return run(maze, rules, *mouse.make(brief(maze, rules, seed), settings));
}

inline Maze wandering_ground(std::uint64_t seed = 1) { return prim_generator.make({{8, 8}, seed, 200}); }

/// Cells stood in, and walls gone through, in the exploration.
struct Trodden {
  CellSet cells;
  WallSet walls;
};

inline void go(Pose pose, const Action& step, WallSet& walls) {
  const Heading direction = rotated(pose.heading, step.rotation);
  for (int cell = 0; cell < step.movement; ++cell)
    walls.insert(wall_at(neighbour(pose.cell, direction, cell), direction));
}

inline Trodden trodden(const RunRecord& record) {
  Trodden trodden;
  for (const StepRecord& step : record.steps) {
    if (step.run == Run::speed) break;
    trodden.cells.insert(step.pose.cell);
    if (step.action.kind == Action::Kind::step) go(step.pose, step.action, trodden.walls);
  }
  return trodden;
}

/// The mouse resets with the first decision at which a goal was entered and the share of cells was stood in.
inline void expect_reset_at_coverage(const Maze& maze, const RunRecord& record, double coverage) {
  CellSet stood_in;
  bool entered = false;
  for (std::size_t i = 0; i < record.steps.size() && record.steps[i].run == Run::exploration; ++i) {
    const StepRecord& step = record.steps[i];
    stood_in.insert(step.pose.cell);
    entered = entered || (i > 0 && maze.is_goal(step.pose.cell));
    const bool enough = entered && stood_in.count() >= coverage * maze.size().area();
    ASSERT_EQ(step.action.kind == Action::Kind::reset, enough) << "step " << step.step;
  }
}

/// The speed run goes only between cells stood in, or where the exploration went.
inline void expect_speed_run_over_near_walls(const RunRecord& record) {
  const Trodden explored = trodden(record);
  WallSet raced;
  for (const StepRecord& step : record.steps)
    if (step.run == Run::speed) go(step.pose, step.action, raced);
  ASSERT_FALSE(raced.empty());
  raced.for_each([&](Wall wall) {
    const bool between = explored.cells.contains(wall.cell) && explored.cells.contains(neighbour(wall.cell, wall.side));
    EXPECT_TRUE(between || explored.walls.contains(wall));
  });
}

}  // namespace labmouse::test
