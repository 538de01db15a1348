// Loads mazes from files, folders and patterns, and built-in ones.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// A maze and its name in results: its path as given, or the name of the built-in maze.
struct NamedMaze {
  std::string name;
  Maze maze;
  std::string reading = {};  ///< how its file was read, as in ReadResult
  WallSet unseen = {};       ///< those of a partial map, which are closed in the maze
};

/// Line and column of a problem that has no place in the file, for example a missing file.
inline constexpr int no_place = -1;

/// A file that is not a maze, and the reasons.
struct SkippedFile {
  std::string path;
  std::vector<Problem> problems;
  bool repairable = false;  ///< as ReadResult::repaired
};

/// A note on a maze, as in ReadResult.
struct MazeNote {
  std::string path;
  std::string text;
};

struct MazeCollection {
  /// Sorted by name, without duplicates.
  std::vector<NamedMaze> mazes;
  /// Unreadable files found in folders and by patterns.
  std::vector<SkippedFile> skipped;
  /// Unreadable files that were named directly, and paths that do not exist.
  std::vector<SkippedFile> errors;
  std::vector<MazeNote> notes;
};

/// `FILE:LINE:COLUMN: error: REASON`; `FILE: error: REASON` if the problem has no place.
std::string describe(const std::string& path, const Problem& problem);

/// Reads mazes.
/// @param paths Each is a file, a folder (recursively, without hidden files), a pattern with `*`, `?` or `[...]`, or
///   the name of a built-in maze if there is no such file; `-` is standard input.
/// @param choice How to read files.
MazeCollection load_mazes(std::span<const std::string> paths, const ReadChoice& choice = {});

/// Reads a maze or a partial map from a file, or a built-in maze if there is no such file. Problems have no place if
/// the file cannot be read.
ReadResult load_map(const std::string& path);

/// The maze of a name in results: of a file, or built-in if there is no such file. Empty if there is neither, or for a
/// folder.
std::optional<Maze> maze_named(const std::string& name);

/// All built-in mazes.
MazeCollection load_builtin_mazes();

}  // namespace labmouse
