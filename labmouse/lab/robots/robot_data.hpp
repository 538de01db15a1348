// What follows from a robot as JSON: its turns, straights and search moves. robot_table.hpp has the same as text.
#pragma once

#include "labmouse/lab/text/json.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// The turns that robot_table() shows: name, `speeds` in mm/s with their times in ms, and lead_in, lead_out, length and
/// clearance in mm, which are null for a robot whose file gives the times of turns.
Json turns_data(const Robot& robot, const DriveModel& model);

/// Times in ms of straights of 1, 2, 4, 8 and 16 steps, cells or half diagonals, between two turns of the slowest
/// speed.
Json straights_data(const Robot& robot, const DriveModel& model);

/// Times in ms of the moves of a search; `known_N` is that of N known cells.
Json search_data(const SearchDrive& search);

/// All of these, the keys of the robot file with their values, the remarks, and the version of labmouse.
Json robot_data(const Robot& robot, const DriveModel& model);

}  // namespace labmouse
