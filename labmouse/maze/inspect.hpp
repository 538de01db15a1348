// Inspection: what a maze is like, in numbers.
#pragma once

#include "labmouse/maze/contest_rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {

/// What an inspection found. Dead ends, junctions and loops are those of the reachable cells.
struct Inspection {
  CellSet reachable;
  /// Cells with exactly one open side; a start in its corner is one.
  int dead_ends = 0;
  /// Cells with three or four open sides.
  int junctions = 0;
  /// Independent loops (the cycle rank, passages - cells + 1): 0 means that there is one way between any two cells.
  int loops = 0;
  /// Cells of a shortest way from the start to a goal; nothing where there is none.
  std::optional<int> shortest_cells;
  /// The shortest runs in strides; nothing where there is none.
  std::optional<ShortestStrides> shortest_strides;
  bool left_follower_arrives = false;
  bool right_follower_arrives = false;
  /// Each official contest rule, kept or not.
  std::vector<RuleFinding> contest_rules;
};

/// Inspects the maze; `longest_stride` (at least 1) is the number of cells that one stride may cover.
Inspection inspect(const Maze& maze, int longest_stride = 3);

}  // namespace labmouse
