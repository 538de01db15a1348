// A robot as a table: its turns, straights and search.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// The model of a robot as a table for people. Turns from a diagonal to an axis are left out, because they mirror those
/// onto diagonals.
std::string robot_table(const Robot& robot, const DriveModel& model);

/// The turns that the table shows, as positions in the lists of the model. Left out are turns from a diagonal to an
/// axis, and turns with different speeds at their ends.
std::vector<std::size_t> shown_turns(const DriveModel& model);

/// The robot in one line, without its name.
std::string robot_line(const Robot& robot, const DriveModel& model);

/// The hash of the tables, as 16 hexadecimal digits.
std::string hash_words(const DriveTables& tables);

}  // namespace labmouse
