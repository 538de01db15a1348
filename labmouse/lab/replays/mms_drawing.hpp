// One run of a program written for mms as a picture and as drawings for terminals.
#pragma once

#include <string>

#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/replays/mms_walk.hpp"

namespace labmouse {

/// One self-contained SVG picture: the last drawing that the mouse left, over its way, and its score as the title.
std::string draw_mms_run(const std::string& mouse, const NamedMaze& maze, const MmsRun& run, const MmsWalk& walk);

/// The maze with what the mouse drew on it, for a terminal.
std::string mms_drawing_of(const Maze& maze, const MmsCanvas& canvas, const HalfPose& pose, const TextDrawer& draw);

/// The same after a line that moved the mouse, with the time, the place and the line below it.
std::string mms_frame(const Maze& maze, const MmsEvent& event, const MmsHost& host, const TextDrawer& draw);

}  // namespace labmouse
