// How a mouse drives the moves of a search.
#pragma once

#include "labmouse/controller/ramps.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace labmouse {

struct SearchManner {
  double speed = 0.0;                                  ///< mm/s, straight on
  double turn_speed = 0.0;                             ///< mm/s, in the curve of a quarter turn
  TurnShape turn;                                      ///< of a quarter turn inside of a cell
  double acceleration = 0.0;                           ///< mm/s², from and to rest
  double known_speed = 0.0, known_acceleration = 0.0;  ///< over known cells; speed 0: as over others
  RampLimits pivot;                                    ///< rad/s and rad/s²
};

/// The manner of a robot. A speed above 0, in mm/s, replaces the robot's own.
SearchManner search_manner(const DriveModel& model, double speed = 0.0);

}  // namespace labmouse
