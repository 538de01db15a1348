// A robot as the text of a file, with a remark on each number.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// What is said of some keys.
using KeyRemarks = std::map<std::string, std::string, std::less<>>;

/// A file of all numbers of a robot, each with its remark or the other one.
std::string remarked_robot(const Robot& robot, RobotParts parts, const KeyRemarks& remarks,
                           const std::string& otherwise);

}  // namespace labmouse
