// A robot in the header of a record.
#pragma once

#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// What of a robot counts: its limits alone, or what it is built of, too.
enum class RobotParts : unsigned char { limits, with_body };

/// Its name and its parameters, under the keys of robot files: "straight.speed".
Json robot_json(const Robot& robot, RobotParts parts = RobotParts::limits);

/// "fixed" where all nodes have one speed, or "classes".
inline const char* model_name(const Robot& robot) { return robot.fixed ? "fixed" : "classes"; }

/// Reads them, and makes the model; the fields hold what is wrong, and the model has an error then.
DriveModel read_robot_json(JsonFields& fields, const ReadJson& json);

}  // namespace labmouse
