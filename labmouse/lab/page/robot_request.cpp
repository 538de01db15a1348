#include "labmouse/lab/page/robot_request.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/hardware_keys.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"
#include "labmouse/lab/robots/robot_text.hpp"

namespace labmouse {
namespace {

std::string built_in_text(PageRequest& request) {
  const std::string name = request.text("built_in");
  for (const BuiltinRobot& robot : builtin_robots())
    if (robot.name == name) return std::string(robot.text);
  request.reject(fmt::format("the page has no robot '{}'", name));
  return "";
}

/// Whether it is a list of sensors, with numbers by name.
bool is_list(const std::string& name, const ReadJson& value) {
  const auto is_key = [&](const std::string& key) {
    const auto has = [&](const auto& keys) {
      return std::any_of(keys.begin(), keys.end(), [&](const auto& one) { return one.key.name == key; });
    };
    return name == infrared_list ? has(infrared_keys()) : has(ranger_keys());
  };
  const auto is_sensor = [&](const ReadJson& sensor) {
    if (!sensor.is_object()) return false;
    for (const auto& [key, number] : sensor.items())
      if (!is_key(key) || !number.is_number()) return false;
    return true;
  };
  return (name == infrared_list || name == ranger_list) && value.is_array() &&
         std::all_of(value.begin(), value.end(), is_sensor);
}

std::string text_of_values(PageRequest& request) {
  const ReadJson& values = request.json()["values"];
  if (!values.is_object()) return request.reject("'values' is not an object"), "";
  for (const auto& [name, value] : values.items()) {
    if (is_list(name, value)) continue;
    const auto is_it = [&, &key_name = name](const RobotKey& key) { return key.name == key_name; };
    if (std::none_of(robot_keys().begin(), robot_keys().end(), is_it))
      return request.reject(fmt::format("no robot has '{}'", name)), "";
    if (!(value.is_number() || value.is_boolean() || value.is_string()))
      return request.reject(fmt::format("'{}' is no number, truth or text", name)), "";
  }
  return robot_text(values);
}

}  // namespace

std::string robot_text_of(PageRequest& request, std::string_view bytes) {
  if (request.has("built_in")) return built_in_text(request);
  if (request.has("values")) return text_of_values(request);
  return std::string(bytes);
}

}  // namespace labmouse
