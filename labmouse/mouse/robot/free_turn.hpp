// Turns of free shape: the fastest path that a search finds between the nodes of a turn.
#pragma once

#include <vector>

#include "labmouse/mouse/robot/fitted_turn.hpp"

namespace labmouse {

/// Looks for a faster path of a turn. The curve may begin and end with a bend to the other side, so that the turn
/// itself is wider; where the robot has grip, the turn may begin and end more gently than its yaw acceleration allows,
/// so that it brakes into the turn. Every path keeps the robot's limits and its clearance. What is compared is the time
/// of the turn with a straight on both sides, on which the robot speeds up and brakes.
/// @param plain the turn as it is driven on the path of a trapezoid: the search begins there.
/// @param top the largest speed in mm/s at which it may begin and end.
/// @param robot whose turn it is.
/// @return the best path that was found, in parts; the plain one in parts if none is better.
FittedTurn freed(const FittedTurn& plain, double top, const Robot& robot);

/// The time that freed() compares.
/// @param turn a turn that fits, on a path in parts.
/// @return seconds
double cost_of(const FittedTurn& turn, const Robot& robot);
/// The same of a turn that takes so many seconds from one speed to another (mm/s).
double cost_of(const TurnShape& shape, double from, double to, double seconds, const Robot& robot);

/// Gives several paths of one turn the same leads, the shortest ones: the curves of the others begin and end with a
/// straight. So every path can follow every straight before the turn.
void share_leads(std::vector<FittedTurn>& paths);

}  // namespace labmouse
