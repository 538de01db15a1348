// What several answers have in common.
#pragma once

#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The cells in which the steps of a shortest run end, the start first; empty where there is no way.
Json route_json(const Maze& maze, const Rules& rules);

/// Steps to the goal from each cell, -1 where there is no way; a step goes so many cells at most.
Json distances_json(const Maze& maze, int stride);

}  // namespace labmouse
