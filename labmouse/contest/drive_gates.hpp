// When a run passes the gates: where its path leaves the start cell, and where it enters a goal.
#pragma once

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Sets the gates and the centre of a run by its route. A run that begins in a goal passes all of them as it begins.
void set_gates(DriveRun& run, const Maze& maze, const DriveModel& model);

/// Notes the gates and the centre that a search passes in a step from that place, over one edge or to rest. A goal is
/// entered at the end of a step, and its middle is passed, or stopped in, by the next, unless that is a small turn; to
/// stop there takes the time of half a cell.
void note_gates(DriveRun& search, const Maze& maze, MazeTime half_cell, const SearchPlace& from, const Action& step,
                MazeTime begin, MazeTime end);
/// Notes when the mouse would stand in the middle of a goal, where a search ends at its edge.
void note_stop(DriveRun& search, const Maze& maze, MazeTime half_cell, const SearchPlace& place, MazeTime time);

}  // namespace labmouse
