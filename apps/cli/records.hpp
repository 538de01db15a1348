// Records as the commands take them: from a file, and only if they could have happened.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "labmouse/lab/record_file.hpp"

namespace labmouse::cli {

/// Adds --maze, the maze to play a record in. Returns the option.
CLI::Option* add_record_maze(CLI::App& command, std::string& maze);

/// The record of a file, with the maze of that name or file, or its own where that is empty. Throws UsageError where
/// there is no record or no maze.
RecordFile load_record(const std::string& path, const std::string& maze);

/// Plays the record in its maze and takes over what comes out. False where it disagrees, which it tells on standard error.
bool re_enact(const std::string& path, RecordFile& file);

}  // namespace labmouse::cli
