// A robot in the header of a record.
#pragma once

#include <nlohmann/json.hpp>

#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// Its name and its parameters, under the keys of robot files: "straight.speed".
nlohmann::ordered_json robot_json(const Robot& robot);

/// "fixed" where all nodes have one speed, or "classes".
inline const char* model_name(const Robot& robot) { return robot.fixed ? "fixed" : "classes"; }

/// Reads them, and makes the model; the fields hold what is wrong, and the model has an error then.
DriveModel read_robot_json(RecordFields& fields, const nlohmann::json& json);

}  // namespace labmouse
