// Mazes from files, folders, patterns, and those that the program brings.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// A maze under the name by which results call it: its path as given, or the built-in one's name.
struct NamedMaze {
  std::string name;
  Maze maze;
  std::string reading = {};  ///< how its file was read, as in ReadResult
};

/// Line and column of a problem that is not in a file's content: there is no such file, say.
inline constexpr int no_place = -1;

/// A file that is no maze, and why.
struct SkippedFile {
  std::string path;
  std::vector<Problem> problems;
};

/// What the user should know of a maze, as in ReadResult.
struct MazeNote {
  std::string path;
  std::string text;
};

struct MazeCollection {
  /// Sorted by name; a name that was given twice stands once.
  std::vector<NamedMaze> mazes;
  /// Unreadable files found in folders and by patterns.
  std::vector<SkippedFile> skipped;
  /// Unreadable files that were named directly, and paths that lead to nothing.
  std::vector<SkippedFile> errors;
  std::vector<MazeNote> notes;
};

/// `FILE:LINE:COLUMN: error: REASON`; `FILE: error: REASON` where it is the content as a whole, or a file that was not
/// read.
std::string describe(const std::string& path, const Problem& problem);

/// Reads each path: a file, a folder (with all that is in it, but nothing hidden), a pattern with `*` and `?`, or the
/// name of a built-in maze where no such file is; `-` is standard input.
MazeCollection load_mazes(std::span<const std::string> paths);

/// What the file at that path holds, a maze or a partial map; problems without a place where it cannot be read. The name
/// of a built-in maze where there is no such file.
ReadResult load_map(const std::string& path);

/// The maze of that name as results give it: a file's, or a built-in one where there is no such file. Nothing where the
/// name leads to none, or to a folder.
std::optional<Maze> maze_named(const std::string& name);

/// All built-in mazes.
MazeCollection load_builtin_mazes();

}  // namespace labmouse
