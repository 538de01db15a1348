// Mazes as the page gives and takes them: `MazeData` in apps/web/page/src/core/types.ts.
#pragma once

#include <optional>
#include <string>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// A cell as [x, y].
Json cell_json(Cell cell);

Json maze_data(const std::string& name, const Maze& maze);

/// A maze, or what is wrong with its data: exactly one of the two is there.
struct MazeDataResult {
  std::optional<NamedMaze> maze;
  std::string error;
};

/// Reads what the page gives as a maze, and trusts none of it. `path` is where it stands in the request.
MazeDataResult read_maze_data(const ReadJson& json, const std::string& path);

}  // namespace labmouse
