// What the tests of the wandering mice share.
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <utility>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse::test {

/// A run with some parameters set.
inline RunRecord wander(const BuiltinMouse& mouse, const Maze& maze, std::uint64_t seed,
                        std::initializer_list<std::pair<std::string_view, std::string_view>> set = {},
                        int budget = 20'000) {
  Settings settings(mouse.parameters);
  for (const auto& [name, value] : set) settings.set(name, value);
  Rules rules;
  rules.budget = budget;
  return run(maze, rules, *mouse.make(brief(maze, rules, seed), settings));
}

inline Maze wandering_ground(std::uint64_t seed = 1) { return prim_generator.make({{8, 8}, seed, 200}); }

inline constexpr Sighting dead_end{0, 0, 0};

/// Hands each step of the search run to check(step), its reset among them.
template <class Check>
void in_search_run(const RunRecord& record, Check check) {
  for (const StepRecord& step : record.steps)
    if (step.run == Run::search_run) check(step);
}

/// A mouse that marks where it stands outside of dead ends resets with the first decision at which a goal and the share
/// of cells is marked.
inline void expect_reset_at_coverage(const Maze& maze, const RunRecord& record, double coverage) {
  CellSet marked;
  bool goal = false;
  in_search_run(record, [&](const StepRecord& step) {
    if (step.sighting != dead_end) {
      marked.insert(step.pose.cell);
      goal |= maze.is_goal(step.pose.cell);
    }
    const bool enough = goal && marked.count() >= coverage * maze.size().area();
    ASSERT_EQ(step.action.kind == Action::Kind::reset, enough) << "step " << step.step;
  });
}

/// The speed run goes only through walls that the search run went through, but for the one that the reset prevented.
/// The cells that it goes: none where the map has no way (WalkedPassages::slip).
inline int expect_speed_run_where_it_walked(const RunRecord& record) {
  WallSet walked;
  Pose last;
  in_search_run(record, [&](const StepRecord& step) {
    last = step.pose;
    if (step.action.movement > 0)
      walked.insert(wall_at(step.pose.cell, rotated(step.pose.heading, step.action.rotation)));
  });
  int raced = 0, elsewhere = 0;
  for (const StepRecord& step : record.steps) {
    if (step.run != Run::speed || step.action.kind != Action::Kind::step) continue;
    const Heading direction = rotated(step.pose.heading, step.action.rotation);
    for (int cell = 0; cell < step.action.movement; ++cell) {
      const Cell from = neighbour(step.pose.cell, direction, cell);
      ++raced;
      if (walked.contains(wall_at(from, direction))) continue;
      ++elsewhere;
      EXPECT_TRUE(from == last.cell || neighbour(from, direction) == last.cell);
    }
  }
  EXPECT_LE(elsewhere, 1);
  return raced;
}

/// The same in twenty mazes, of which nearly all have a way.
inline void expect_speed_runs_where_it_walked(const BuiltinMouse& mouse) {
  int with_way = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    with_way += expect_speed_run_where_it_walked(wander(mouse, wandering_ground(seed), seed)) > 0;
  EXPECT_GE(with_way, 17);
}

}  // namespace labmouse::test
