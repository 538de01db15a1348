// Records as the page takes them: read, and played again in their maze.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/records/record_file.hpp"

namespace labmouse {

/// A whole record that agrees with its maze, or why there is none.
struct PlayedRecord {
  std::optional<RecordFile> file;
  PageFailure failure;
};

/// Reads a record's text under the name of its file. One without a maze takes that maze.
PlayedRecord read_played(const std::string& name, std::string_view text, std::optional<NamedMaze> maze = std::nullopt);

/// Plays a record that has a maze.
PlayedRecord played(const std::string& name, RecordFile file);

/// What is said of a record that does not agree with its maze.
PageReply disagreed(const std::string& name, std::string disagreement);

}  // namespace labmouse
