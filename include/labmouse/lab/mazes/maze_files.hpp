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
  WallSet unseen = {};       ///< the unseen walls of a partial map, which are closed in the maze; else empty
};

/// Line and column of a problem that has no place in the file, for example a missing file.
inline constexpr int no_place = -1;

/// A file that is not a maze, and the reasons.
struct SkippedFile {
  std::string path;
  std::vector<Problem> problems;
  bool repairable = false;  ///< whether ReadResult::repaired has a maze: ReadChoice::repaired would read the file
};

/// A note on a maze, as in ReadResult.
struct MazeNote {
  std::string path;
  std::string text;
};

/// Mazes that were found, and the files that are none.
struct MazeCollection {
  /// Sorted by name, without duplicates.
  std::vector<NamedMaze> mazes;
  /// Unreadable files found in folders and by patterns.
  std::vector<SkippedFile> skipped;
  /// Unreadable files that were named directly, and paths that do not exist.
  std::vector<SkippedFile> errors;
  /// What the user should know of the mazes and of the files, in the order of reading.
  std::vector<MazeNote> notes;
};

/// Formats a problem as one line for the user.
/// @param path the file, as the user named it.
/// @param problem its place counts only if its line is above 0.
/// @return `FILE:LINE:COLUMN: error: REASON`, or `FILE: error: REASON` without a place; line breaks and control
///   characters are escaped, and there is no line feed at the end.
std::string describe(const std::string& path, const Problem& problem);

/// Reads mazes from files, folders and patterns, and built-in ones. Never fails as a whole.
/// @param paths each is a file, a folder (recursively, without hidden files and links to folders), a pattern with `*`,
///   `?` or `[...]`, or the name of a built-in maze if there is no such file; `-` is standard input.
/// @param choice how to read files; built-in mazes do not use it.
/// @return the mazes; in `skipped` and `errors` what is no maze, what is larger than 1 MiB, and paths that do not
///   exist.
MazeCollection load_mazes(std::span<const std::string> paths, const ReadChoice& choice = {});

/// Reads a maze or a partial map from a file, or a built-in maze if there is no such file.
/// @param path a file, `-` for standard input, or the name of a built-in maze.
/// @return as of read_maze(): a partial map is in `partial`, and a problem. If the file cannot be read or does not
///   exist, the one problem has the place `no_place`.
ReadResult load_map(const std::string& path);

/// The maze of a name in results: of a file, or built-in if there is no such file. Unseen walls of a partial map are
/// closed.
/// @param name as NamedMaze::name.
/// @return nothing if there is neither, if the file is no maze, or for a folder, a pipe or a device.
std::optional<Maze> maze_named(const std::string& name);

/// All built-in mazes.
/// @return the mazes, sorted by name; there are no skipped files, errors or notes.
MazeCollection load_builtin_mazes();

}  // namespace labmouse
