// Loads records for commands, and checks that they match their maze.
#pragma once

#include <memory>
#include <string>

#include "labmouse/lab/replays/replay.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// Adds --maze, the maze in which to replay a record. Returns the option.
Option* add_record_maze(Command& command, std::string& maze);

/// The text of a record's file. Throws UsageError.
std::string load_record_text(const std::string& path);

/// Replays the contest of a record in the maze of that name or file; in its own maze if the name is empty. Throws
/// UsageError where there is no record or no maze. Where the record does not match the maze, prints an error and
/// returns null.
std::unique_ptr<Replay> open_record(const std::string& path, const std::string& text, const std::string& maze = "");

}  // namespace labmouse::cli
