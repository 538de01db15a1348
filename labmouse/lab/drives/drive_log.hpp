// Writes a drive of the physical world as a log: the data a real robot could write, and the true positions.
#pragma once

#include <span>
#include <string>

#include "labmouse/body/field.hpp"
#include "labmouse/contest/known_drive.hpp"

namespace labmouse {

/// CSV with a line for each tick, described in docs/how-to/robot-from-a-log.md: raw integers of the sensors and the PWM
/// duties that the program then set. The last columns are the truth: path length, distances in mm to the walls that the
/// sensors see, and pose. A wall distance is empty where the robot is more than 1 degree off the wall's direction or
/// its normal, or where the sensor does not see only that wall.
std::string log_text(std::span<const LoggedTick> ticks, const Field& field, const Hardware& hardware);

}  // namespace labmouse
