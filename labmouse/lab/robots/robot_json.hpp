// A robot in the header of a record.
#pragma once

#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// The parts of a robot to write: its limits alone, or its hardware, too.
enum class RobotParts : unsigned char { limits, with_body };

/// Its name and its parameters, with the keys of robot files such as "straight.speed".
Json robot_json(const Robot& robot, RobotParts parts = RobotParts::limits);

/// "fixed" where the robot has published times and one speed at the ends of all segments (FixedTimes); else "classes",
/// where speeds follow from limits.
inline const char* model_name(const Robot& robot) { return robot.fixed ? "fixed" : "classes"; }

/// Reads a robot and makes its model. On failure `fields` holds the error, and so does the model.
DriveModel read_robot_json(JsonFields& fields, const ReadJson& json);

}  // namespace labmouse
