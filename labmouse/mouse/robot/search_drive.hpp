// How a robot searches, from its search speed.
#pragma once

#include "labmouse/mouse/robot/robot.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace labmouse {

struct SearchModel {
  SearchDrive drive;
  std::string error;  ///< why it cannot search at that speed, in mm/s
};

/// What the robot gives, or else: cells and the small turn at its search speed; a turn back that stops within half a
/// cell, pivots and starts within half a cell. Where braking and starting differ, both last as long as the longer. A
/// turn that has a speed of its own begins and ends at the search speed, and changes to its own on its leads. Over
/// known cells it speeds up to the speed that it may have there, and brakes to that of the search, both as hard.
SearchModel search_model(const Robot& robot, const TurnShape& small_turn, double small_turn_speed);

}  // namespace labmouse
