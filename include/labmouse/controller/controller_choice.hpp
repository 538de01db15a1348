// Options of a controller.
#pragma once

namespace labmouse {

/// Which corrections are on.
struct CorrectionChoice {
  bool sides = true;
  bool edges = true;
  bool front = true;

  friend bool operator==(const CorrectionChoice&, const CorrectionChoice&) = default;
};

/// Options of a controller.
struct ControllerChoice {
  CorrectionChoice corrections;
  double search_speed = 0.0;  ///< mm/s; 0: the robot's own
  double pace = 1.0;          ///< scales all speeds: at 0.5 everything takes twice its time
};

}  // namespace labmouse
