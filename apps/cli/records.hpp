// Records as the commands take them: from a file, and only if they could have happened.
#pragma once

#include <memory>
#include <string>

#include "labmouse/lab/replays/replay.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// Adds --maze, the maze to play a record in. Returns the option.
Option* add_record_maze(Command& command, std::string& maze);

/// The text of a record's file. Throws UsageError.
std::string load_record_text(const std::string& path);

/// The contest of a record of that text, played in the maze of that name or file, or in its own where that is empty.
/// Throws UsageError where there is no record or no maze. Where it could not have happened it tells so on standard
/// error, and returns null.
std::unique_ptr<Replay> open_record(const std::string& path, const std::string& text, const std::string& maze = "");

}  // namespace labmouse::cli
