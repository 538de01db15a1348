#include "labmouse/lab/robots/robot_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/lab/robots/hardware_keys.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"

namespace labmouse {
namespace {

/// Turns with keys of their own.
constexpr std::array named_turns = {Turn::f45, Turn::f90, Turn::f135, Turn::f180, Turn::v90, Turn::s90};

double milliseconds(DriveTime time) { return time / 1e3; }

void add_turns(Json& json, const Robot& robot) {
  if (!robot.fixed) {
    json["clearance"] = robot.clearance;
    json["run_up"] = robot.run_up;
    json["curve.lateral_acceleration"] = robot.lateral_acceleration;
    json["curve.yaw_acceleration"] = robot.yaw_acceleration;
    if (robot.yaw_speed > 0.0) json["curve.yaw_speed"] = robot.yaw_speed;
    if (robot.yaw_jerk > 0.0) json["curve.yaw_jerk"] = robot.yaw_jerk;
    if (robot.profile != TurnProfile{}) json["curve.profile"] = name_of(robot.profile);
    if (robot.grip > 0.0) json["curve.grip"] = robot.grip;
    // Defaults of records are left out, so that older records stay unchanged.
    if (robot.speeds != recorded_speeds) json["curve.speeds"] = robot.speeds;
    if (robot.stop != Stop::beyond) json["stop"] = "goal";
    for (const Turn turn : named_turns)
      if (const double given = robot.layout(turn).given; given > 0.0)
        json[fmt::format("layout.{}", name_of(turn))] = given;
    return;
  }
  const FixedTimes& fixed = *robot.fixed;
  json["turns.speed"] = fixed.speed;
  const std::array times = {fixed.f45, fixed.f90, fixed.f135, fixed.f180, fixed.v90, fixed.s90};
  for (std::size_t i = 0; i < times.size(); ++i)
    if (robot.drives(named_turns[i])) json[fmt::format("turns.{}", name_of(named_turns[i]))] = milliseconds(times[i]);
}

/// Adds the diagonals and turns that the robot does not drive.
void add_omissions(Json& json, const Robot& robot) {
  if (!robot.diagonals) json["diagonals"] = false;
  for (const Turn turn : named_turns)
    if (!robot.layout(turn).driven) json[fmt::format("{}.{}", robot.fixed ? "turns" : "layout", name_of(turn))] = false;
}

void add_search(Json& json, const Robot& robot) {
  if (robot.known_speed > 0.0) json["search.known_speed"] = robot.known_speed;
  if (robot.known_acceleration > 0.0) json["search.known_acceleration"] = robot.known_acceleration;
  if (robot.search.cell == 0) {
    json["search.speed"] = robot.search_speed;
    if (robot.search_turn_speed > 0.0) json["search.turn_speed"] = robot.search_turn_speed;
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

bool is_plain(const std::string& name, const ReadJson& value) {
  const RobotKey* const key = find_robot_key(name);
  const bool choice =
      key != nullptr && value.is_string() &&
      std::find(key->choices.begin(), key->choices.end(), value.get<std::string>()) != key->choices.end();
  return name.find_first_not_of("abcdefghijklmnopqrstuvwxyzSV0123456789._") == std::string::npos &&
         (value.is_number() || value.is_boolean() || choice);
}

/// The text of a robot file; empty, with the error in `fields`, where the JSON has other keys or values.
std::string toml_of(const ReadJson& parameters, JsonFields& fields) {
  if (!parameters.is_object()) return fields.reject("'robot.parameters' is not an object"), "";
  std::string text, lists;
  const auto line_of = [](const std::string& name, const ReadJson& value) {
    // Whole numbers must stay whole.
    return fmt::format("{} = {}\n", name,
                       value.is_number_float() ? fmt::format("{}", value.get<double>()) : value.dump());
  };
  const auto fail = [&] { return fields.reject("'robot.parameters' has a key or a value that no robot has"), ""; };
  for (const auto& [name, value] : parameters.items()) {
    if ((name == infrared_list || name == ranger_list) && value.is_array()) {
      for (const ReadJson& sensor : value) {
        lists += fmt::format("[[{}]]\n", name);
        if (!sensor.is_object()) return fail();
        for (const auto& [key, number] : sensor.items()) {
          if (!is_plain(key, number)) return fail();
          lists += line_of(key, number);
        }
      }
      continue;
    }
    if (!is_plain(name, value)) return fail();
    text += line_of(name, value);
  }
  return text + lists;
}

template <class Sensor>
Json list_json(std::vector<Sensor> sensors, std::span<const SensorKey<Sensor>> keys) {
  Json list = Json::array();
  for (Sensor& sensor : sensors) {
    Json entry = Json::object();
    for (const SensorKey<Sensor>& key : keys) {
      const double number = key.number(sensor);
      const bool whole = key.key.kind == RobotKey::Kind::whole;
      entry[std::string(key.key.name)] = whole ? Json(static_cast<int>(number)) : Json(number);
    }
    list.push_back(std::move(entry));
  }
  return list;
}

void add_hardware(Json& json, const Robot& robot) {
  if (!robot.hardware) return;
  const Sensors& sensors = robot.hardware->sensors;
  HardwareTerms terms = terms_of(*robot.hardware);
  HardwareNumbers unset;
  for (const HardwareKey& key : hardware_keys()) {
    const double number = key.number(terms.numbers);
    if (terms.has(key.key) && !(key.added_later && number == key.number(unset)))
      json[std::string(key.key.name)] = number * key.unit;
  }
  if (!terms.lists) return;
  json[std::string(infrared_list)] = list_json(sensors.infrared, infrared_keys());
  json[std::string(ranger_list)] = list_json(sensors.rangers, ranger_keys());
}

}  // namespace

Json robot_json(const Robot& robot, RobotParts parts) {
  Json parameters = {{"cell", robot.cell},
                     {"sight", robot.sight},
                     {"straight.speed", robot.speed},
                     {"straight.acceleration", robot.acceleration},
                     {"straight.braking", robot.braking}};
  if (robot.diagonals) {
    parameters["diagonal.speed"] = robot.speed_diagonal;
    parameters["diagonal.acceleration"] = robot.acceleration_diagonal;
    parameters["diagonal.braking"] = robot.braking_diagonal;
  }
  add_turns(parameters, robot);
  add_omissions(parameters, robot);
  add_search(parameters, robot);
  if (parts == RobotParts::with_body) add_hardware(parameters, robot);
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
  RobotResult result = read_robot(text, name, RobotText::recorded);
  if (result.robot) return std::move(result.model);
  outer.reject("'robot': " + result.problems.front().reason);
  return none;
}

}  // namespace labmouse
