// The records and pictures that a race leaves behind.
#pragma once

#include <string>

#include "labmouse/lab/drawing.hpp"
#include "labmouse/lab/record_file.hpp"
#include "labmouse/lab/tournament.hpp"

namespace labmouse {

/// Saves a contest below a folder: the record as FOLDER/MOUSE/MAZE-RUN.jsonl and, for the first run, a picture of the
/// speed run over the visits of the exploration as FOLDER/MOUSE/MAZE.svg. Returns what went wrong, or nothing.
std::string save_contest(const std::string& folder, const Race& race, const ContestResult& contest,
                         const RunRecord& record);

/// The record of a contest as a file.
RecordFile record_file_of(const Contestant& mouse, const NamedMaze& maze, const Rules& rules, std::uint64_t seed,
                          const RunRecord& record);

/// A title for its picture: the mouse, the maze, and the score or how else it ended.
std::string title_of(const RecordFile& file);

/// The layers of that picture: the exploration's visits as heat, the speed run as the route.
DrawingLayers layers_of(const Maze& maze, const RunRecord& record);

}  // namespace labmouse
