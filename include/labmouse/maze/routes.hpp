// Shortest routes of a maze that is fully known.
//
// Method: plain breadth-first search. A faster one for what a mouse knows is in labmouse/mouse.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The cells that are connected to the start, including the start.
/// @param maze the whole maze.
CellSet reachable_cells(const Maze& maze);

/// Length of a shortest route from the start to a goal.
/// @param maze the whole maze.
/// @return in cells: 0 if the start is a goal; nothing if none can be reached.
std::optional<int> shortest_in_cells(const Maze& maze);

/// A shortest route, always the same one of several.
/// @param maze the whole maze.
/// @return its cells, including start and goal; empty if there is none.
std::vector<Cell> shortest_way(const Maze& maze);

/// Length and number of the shortest runs in steps.
struct ShortestStrides {
  int strides = 0;
  /// Different sequences of that many steps; saturates at the largest number that fits.
  std::uint64_t count = 0;
};

/// The shortest runs in steps. The last step must end in a goal; passing through does not count. If the start is a
/// goal, a run is one step that stays there.
/// @param maze the whole maze.
/// @param longest a step goes 1 to this many cells straight in any of the four headings; at least 1.
/// @return nothing if no goal can be reached.
std::optional<ShortestStrides> shortest_in_strides(const Maze& maze, int longest = 3);

/// Whether at least two routes lead to the goal without visiting a cell twice. All goal cells count as one, so
/// different paths inside a goal room are no second route.
/// @param maze the whole maze.
bool has_several_routes(const Maze& maze);

}  // namespace labmouse
