// How the map that a mouse made differs from the maze.
#pragma once

#include <optional>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// Inner walls of a map by what is wrong with them.
struct MapComparison {
  WallSet false_walls;   ///< closed in the map, open in the maze
  WallSet missed_walls;  ///< open in the map, closed in the maze
  WallSet unseen;        ///< neither of the two: the map does not know them
};

/// Compares a map with the maze. Nothing where their sizes differ.
/// @param unseen Walls of the map that were not seen.
std::optional<MapComparison> compare_maps(const Maze& map, const WallSet& unseen, const Maze& maze);

}  // namespace labmouse
