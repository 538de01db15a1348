#include "labmouse/lab/robots/robot_json.hpp"

#include "labmouse/lab/robots/robot_file.hpp"

namespace labmouse {
namespace {

double milliseconds(DriveTime time) { return time / 1e3; }

void add_turns(Json& json, const Robot& robot) {
  if (!robot.fixed) {
    json["clearance"] = robot.clearance;
    json["run_up"] = robot.run_up;
    json["curve.lateral_acceleration"] = robot.lateral_acceleration;
    json["curve.yaw_acceleration"] = robot.yaw_acceleration;
    return;
  }
  const FixedTimes& fixed = *robot.fixed;
  json["turns.speed"] = fixed.speed;
  json["turns.45"] = milliseconds(fixed.f45);
  json["turns.90"] = milliseconds(fixed.f90);
  json["turns.135"] = milliseconds(fixed.f135);
  json["turns.180"] = milliseconds(fixed.f180);
  json["turns.V90"] = milliseconds(fixed.v90);
  json["turns.S90"] = milliseconds(fixed.s90);
}

void add_search(Json& json, const Robot& robot) {
  if (robot.search.cell == 0) {
    json["search.speed"] = robot.search_speed;
    json["search.pivot_speed"] = robot.pivot_speed;
    json["search.pivot_acceleration"] = robot.pivot_acceleration;
    return;
  }
  json["search.cell"] = milliseconds(robot.search.cell);
  json["search.turn"] = milliseconds(robot.search.turn);
  json["search.back"] = milliseconds(robot.search.back);
  json["search.quarter"] = milliseconds(robot.search.quarter);
  json["search.half_cell"] = milliseconds(robot.search.half_cell);
}

/// The text of a robot file; nothing, with the reason in the fields, where the JSON cannot be one.
std::string toml_of(const ReadJson& parameters, JsonFields& fields) {
  std::string text;
  if (!parameters.is_object()) return fields.reject("'robot.parameters' is not an object"), "";
  for (const auto& [name, value] : parameters.items()) {
    const bool plain = name.find_first_not_of("abcdefghijklmnopqrstuvwxyzSV0123456789._") == std::string::npos;
    if (!plain || !value.is_number())
      return fields.reject("'robot.parameters' has a key or a value that no robot has"), "";
    // One that is whole must stay so.
    text += fmt::format("{} = {}\n", name,
                        value.is_number_integer() ? value.dump() : fmt::format("{}", value.get<double>()));
  }
  return text;
}

}  // namespace

Json robot_json(const Robot& robot) {
  Json parameters = {{"cell", robot.cell},
                     {"sight", robot.sight},
                     {"straight.speed", robot.speed},
                     {"straight.acceleration", robot.acceleration},
                     {"straight.braking", robot.braking},
                     {"diagonal.speed", robot.speed_diagonal},
                     {"diagonal.acceleration", robot.acceleration_diagonal},
                     {"diagonal.braking", robot.braking_diagonal}};
  add_turns(parameters, robot);
  add_search(parameters, robot);
  return {{"name", robot.name}, {"parameters", std::move(parameters)}};
}

DriveModel read_robot_json(JsonFields& outer, const ReadJson& json) {
  DriveModel none;
  none.error = "no robot";
  JsonFields fields(json, "robot");
  const std::string name = fields.text("name");
  if (!fields.has("parameters")) fields.reject("'robot.parameters' is missing");
  const std::string text = fields.error().empty() ? toml_of(json["parameters"], fields) : "";
  outer.reject(fields.error());
  if (!fields.error().empty()) return none;
  RobotResult result = read_robot(text, name);
  if (result.robot) return std::move(result.model);
  outer.reject("'robot': " + result.problems.front().reason);
  return none;
}

}  // namespace labmouse
