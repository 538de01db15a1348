// Maps that robots make, compared with the true maze.
#pragma once

#include <string>

#include "command.hpp"
#include "labmouse/maze/map_comparison.hpp"

namespace labmouse::cli {

struct ComparedMap {
  NamedMaze truth;
  MapComparison found;
  std::string reading;  ///< how the file of the map was read, as in ReadResult

  /// Inner walls of the maze, and those that the map has wrong.
  int walls() const { return WallSet::all(truth.maze.size()).count(); }
  int wrong() const { return found.false_walls.count() + found.missed_walls.count(); }
  int right() const { return walls() - wrong() - found.unseen.count(); }
};

/// Reads a map from a file and compares it with a maze. Throws UsageError if one cannot be read or the sizes differ.
ComparedMap compare_map(const std::string& map, const std::string& truth, const Places& places);

}  // namespace labmouse::cli
