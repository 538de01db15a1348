// From the turns of a robot to the limits behind them.
#pragma once

#include <span>
#include <vector>

#include "labmouse/lab/robots/turn_table.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace labmouse {

/// The limits that explain some turns best.
struct TurnFit {
  CurveLimits limits;  ///< those of yaw speed and yaw jerk are 0 where the turns are explained without them
  /// Whether some turn reaches each of them, in the order of CurveLimits: otherwise nothing is known of it but that it
  /// is no lower.
  bool reaches_lateral = false, reaches_acceleration = false, reaches_speed = false, reaches_jerk = false;
  int numbers = 0;             ///< that were fitted; 0 where no limits explain the turns
  int figures = 0;             ///< that they were fitted to; of fewer than the numbers many limits would do
  std::vector<double> errors;  ///< by turn: the largest relative error of its size and time; 0 of one without a speed
};

/// Fits the turns that have a speed. The limits are the fewest that explain all figures to half a thousandth, or else
/// the best. Method: Levenberg and Marquardt's, from a grid of starts, for each set of limits.
TurnFit fit_turns(std::span<const KnownTurn> turns, double cell);

}  // namespace labmouse
