// Statistics of a maze: dead ends, junctions, loops, shortest routes and contest rules.
#pragma once

#include "labmouse/maze/contest_rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {

/// The result of inspect(). Dead ends, junctions and loops are counted among the reachable cells.
struct Inspection {
  CellSet reachable;
  /// Cells with exactly one open side; this includes the start, if it has three walls.
  int dead_ends = 0;
  /// Cells with three or four open sides.
  int junctions = 0;
  /// Independent loops (the cycle rank, passages - cells + 1): 0 means that there is one route between any two cells.
  int loops = 0;
  /// Length of a shortest route from the start to a goal in cells; nothing if there is none.
  std::optional<int> shortest_cells;
  /// The shortest runs in steps; nothing if there is none.
  std::optional<ShortestStrides> shortest_strides;
  bool left_follower_arrives = false;
  bool right_follower_arrives = false;
  /// Each official contest rule, kept or not.
  std::vector<RuleFinding> contest_rules;
};

/// The number of open sides of a cell.
/// @param maze the whole maze.
/// @param cell inside the maze.
/// @return 0 to 4.
int count_open_sides(const Maze& maze, Cell cell);

/// Inspects the maze: it searches it several times, which takes some milliseconds at most.
/// @param maze the whole maze.
/// @param longest_stride the most cells that one step may cover, at least 1.
Inspection inspect(const Maze& maze, int longest_stride = 3);

}  // namespace labmouse
