// A robot file from a log of one's own mouse.
#pragma once

#include <string_view>

#include "labmouse/lab/logs/count_fit.hpp"
#include "labmouse/lab/logs/log_file.hpp"
#include "labmouse/lab/robots/fitted_robot.hpp"

namespace labmouse {

/// With all that the log says, each number with its standard error, and all else from another robot, which must have
/// hardware; what was fitted how well stands at its head. The doubt is of what the log has columns for and does not
/// tell.
FittedRobot robot_by_log(const Log& log, std::string_view log_name, const Robot& base, const WholeWay& whole);

}  // namespace labmouse
