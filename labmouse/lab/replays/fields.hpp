// JSON that several answers to the page have in common.
#pragma once

#include <string_view>
#include <vector>

#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// What the world of a contest is like, for those who show it: `Traits` in apps/web/page/src/core/types.ts.
struct PlayTraits {
  bool in_steps = true;  ///< whether its clock counts steps
  std::string_view unit = {};
  int digits = 3;
  std::string_view bound;
  std::vector<std::string_view> runs;
  bool draws = false;
  bool pictured = true;
};
Json traits_json(const PlayTraits& traits);

/// The cells in which the steps of a shortest run end, the start first; empty where there is no way.
Json route_json(const Maze& maze, const Rules& rules);

/// Steps to the goal from each cell, -1 where there is no way; a step goes so many cells at most.
Json distances_json(const Maze& maze, int stride);

}  // namespace labmouse
