// A robot in figures: its turns, straights and search.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// All that follows from a robot, as a table for people. Turns back from diagonals are those onto them and are left
/// out.
std::string robot_table(const Robot& robot, const DriveModel& model);

/// The turns that are shown of a robot, as positions in the lists of its model: without those back from diagonals, and
/// of those that change their speed.
std::vector<std::size_t> shown_turns(const DriveModel& model);

/// The robot in one line, without its name.
std::string robot_line(const Robot& robot, const DriveModel& model);

/// The hash of its tables: 16 hexadecimal digits.
std::string hash_words(const DriveTables& tables);

}  // namespace labmouse
