// One run of a program written for mms as a picture.
#pragma once

#include <string>

#include "labmouse/guests/mms/run.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mms/mms_walk.hpp"

namespace labmouse {

/// One self-contained SVG picture: the last drawing that the mouse left, over its way, and its score as the title.
std::string draw_mms_run(const std::string& mouse, const NamedMaze& maze, const MmsRun& run, const MmsWalk& walk);

}  // namespace labmouse
