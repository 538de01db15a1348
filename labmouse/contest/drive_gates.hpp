// Computes when a run passes the gates: it leaves the start cell, and enters a goal. The gate of a lap is the exit of
// the start cell.
#pragma once

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Sets the gates and the centre of a run by its route, or the gates of a run of laps. A run that begins in a goal
/// passes all of them as it begins.
void set_gates(DriveRun& run, const Maze& maze, const DriveModel& model);

/// Records the gates and the centre that a search passes in a step from that place, over one edge or to rest. A goal is
/// entered at the end of a step. The next step passes its middle or stops there, unless it is a quarter turn; to stop
/// there takes the time of half a cell.
void note_gates(DriveRun& search, const Maze& maze, MazeTime half_cell, const SearchPlace& from, const Action& step,
                MazeTime begin, MazeTime end);
/// If a search ends at the edge of a goal, records when the mouse would stand in its middle.
void note_stop(DriveRun& search, const Maze& maze, MazeTime half_cell, const SearchPlace& place, MazeTime time);

}  // namespace labmouse
