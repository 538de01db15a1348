// Options of a controller.
#pragma once

namespace labmouse {

/// Which walls correct the estimated pose.
struct CorrectionChoice {
  bool sides = true;  ///< walls beside the mouse: lateral and heading error
  bool edges = true;  ///< edges of walls and posts that infrared sensors pass: longitudinal error
  bool front = true;  ///< walls that a ToF sensor sees ahead: longitudinal error

  friend bool operator==(const CorrectionChoice&, const CorrectionChoice&) = default;
};

/// Options of a controller.
struct ControllerChoice {
  CorrectionChoice corrections;
  double search_speed = 0.0;  ///< mm/s; 0: the robot's own
  double pace = 1.0;          ///< above 0; scales all speeds: at 0.5 everything takes twice its time
};

}  // namespace labmouse
