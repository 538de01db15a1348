// The times of a robot's search, from its search speed.
#pragma once

#include <vector>

#include "labmouse/mouse/robot/fitted_turn.hpp"

namespace labmouse {

struct SearchModel {
  SearchDrive drive;
  std::string error;  ///< why it cannot search at that speed, in mm/s
};

/// The times of a search, as the robot gives them or as follows. Cells and the small turn are driven at the search
/// speed. A turn back stops within half a cell, pivots, and starts within half a cell; both last as long as the longer
/// one. A turn with a speed of its own begins and ends at the search speed, and changes on its leads. Over known cells
/// it accelerates to the speed allowed there, and brakes to that of the search, both equally hard.
SearchModel search_model(const Robot& robot, const TurnShape& small_turn, double small_turn_speed);

/// The path of S90 that a search drives, and the speed up to which it does: that of speed runs, or of a trapezoid where
/// the shape of turns is free. Without search.turn_speed, which has a path of its own.
/// @param turns and `shapes`: all turns of the robot, in the order of its tables.
FittedTurn search_turn(const Robot& robot, const std::vector<DrivenTurn>& turns, const std::vector<TurnShape>& shapes);

}  // namespace labmouse
