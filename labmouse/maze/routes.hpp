// Routes from the start of a maze to its goals, by someone who sees all of it.
//
// Method: plain breadth-first search, written to be read. A mouse has a faster one for what it knows (labmouse/mouse).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The cells that one can walk to from the start, the start among them.
CellSet reachable_cells(const Maze& maze);

/// Cells walked on a shortest way from the start to a goal: 0 on a goal; nothing where no goal can be reached.
std::optional<int> shortest_in_cells(const Maze& maze);

/// The cells of such a way, start and goal included; empty where there is none. Of several ways always the same one.
std::vector<Cell> shortest_way(const Maze& maze);

/// What a shortest run costs in strides, and how many such runs there are.
struct ShortestStrides {
  int strides = 0;
  /// Different sequences of strides of that length; stops counting at the largest number that fits.
  std::uint64_t count = 0;
};

/// The shortest runs in strides: one stride goes 1 to `longest` (at least 1) cells straight in any of the four
/// headings, and the last one must end in a goal; passing through does not count. Where the start is a goal, a run is
/// one step that stays there. Nothing where no goal can be reached.
std::optional<ShortestStrides> shortest_in_strides(const Maze& maze, int longest = 3);

/// Whether there are at least two routes to the goal that visit no cell twice. All goal cells count as one place, so
/// walking differently inside a goal room makes no second route.
bool has_several_routes(const Maze& maze);

}  // namespace labmouse
