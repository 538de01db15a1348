// A robot file from published or measured turns.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/robots/turn_fit.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// The text of a file, or why there is none: exactly one of the two is there.
struct FittedRobot {
  std::string text;
  std::string error;
  std::string doubt;  ///< what speaks against the text, if anything does: it is refused, or fits badly
};

/// The side of the cells that turns lie in, as far as S90 with its straights says; or 0.
double cell_of(const std::vector<KnownTurn>& turns);

/// With all that the turns say, and all else from another robot; each line says which. Turns with speeds give limits
/// and paths, if the other robot has limits; turns with times alone a table of times, if the other one has such a
/// table.
FittedRobot fitted_robot(const std::vector<KnownTurn>& turns, const Robot& base, double cell);

}  // namespace labmouse
