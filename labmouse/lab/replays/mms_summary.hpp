// One run of a program written for mms, for a terminal.
#pragma once

#include <string>

#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"

namespace labmouse {

/// Without a drawing: the statistics, the score beside the best possible one, what was wrong with its lines, how it
/// ended, and the last lines of its standard error.
std::string report_of(const std::string& mouse, const NamedMaze& maze, const MmsRun& run);

/// The last line of it: the score beside the best possible one.
std::string mms_score_line(const std::string& mouse, const NamedMaze& maze, const MmsRun& run);

}  // namespace labmouse
