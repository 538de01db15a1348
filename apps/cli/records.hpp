// Records as the commands take them: from a file, and only if they could have happened.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mms/mms_replay.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/records/mms_record_file.hpp"
#include "labmouse/lab/records/record_file.hpp"
#include "options.hpp"

namespace labmouse::cli {

/// Adds --maze, the maze to play a record in. Returns the option.
Option* add_record_maze(Command& command, std::string& maze);

/// The text of a record's file. Throws UsageError.
std::string load_record_text(const std::string& path);

/// The record of a contest in seconds in a file of that text. Throws UsageError where there is none, and tells where it
/// could not have happened: then nothing.
std::optional<DriveRecordFile> load_drive_record(const std::string& path, const std::string& text);

/// A record of a program for mms, and what comes out where it is played again.
struct MmsRecord {
  MmsRecordFile file;
  MmsReplay replay;

  NamedMaze maze() const { return {file.maze_name, *file.maze}; }
};
/// The one in a file of that text; as load_drive_record.
std::optional<MmsRecord> load_mms_record(const std::string& path, const std::string& text);

/// The maze with what the mouse of mms drew on it, for the terminal.
std::string mms_drawing_of(const Maze& maze, const MmsCanvas& canvas, const HalfPose& pose);

/// Throws UsageError where one of the options was given, which records of that kind do not take.
void refuse_options(const Command& command, const std::vector<std::string>& options, std::string_view kind);

/// The record of a file's text, with the maze of that name or file, or its own where that is empty. Throws UsageError
/// where there is no record or no maze.
RecordFile load_record(const std::string& path, const std::string& text, const std::string& maze);

/// Plays the record in its maze and takes over what comes out. False where it disagrees, which it tells on standard
/// error.
bool re_enact(const std::string& path, RecordFile& file);

}  // namespace labmouse::cli
