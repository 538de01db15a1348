#include "labmouse/lab/robots/robot_family.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"
#include "labmouse/lab/robots/robot_text.hpp"
#include "labmouse/lab/system/named_text.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

Json value_of(std::string_view text) {
  if (const std::optional<double> number = parse_number(text)) return *number;
  if (text == "true" || text == "false") return text == "true";
  return text;
}

}  // namespace

RobotFamily::RobotFamily(std::string_view text, std::string_view name) : name_(name), values_(robot_values(text)) {}

RobotResult RobotFamily::with(std::span<const RobotNumber> numbers) const {
  Json values = values_;
  for (const RobotNumber& number : numbers) values[std::string(number.key)] = number.value;
  return read_robot(robot_text(ReadJson(values)), name_);
}

std::string RobotFamily::text_with(std::string_view key, std::string_view value) const {
  Json values = values_;
  values[std::string(key)] = value_of(value);
  if (key == "diagonals" && value == "false")
    for (const RobotKey& each : robot_keys())
      if (each.of_diagonals) values.erase(std::string(each.name));
  return robot_text(ReadJson(values));
}

FoundFamily find_robot_family(const std::string& name) {
  const NamedText text = find_text("robot", builtin_robots(), name);
  if (!text.error.empty()) return {std::nullopt, text.error};
  return {RobotFamily(text.text, name_alone(name)), ""};
}

std::string why_no_key(std::string_view key) {
  if (find_robot_key(key) != nullptr) return "";
  const auto keys = robot_keys();
  const std::string ending = fmt::format(".{}", key);
  const auto near =
      std::find_if(keys.begin(), keys.end(), [&](const RobotKey& known) { return known.name.ends_with(ending); });
  return fmt::format("'{}' is no key of robot files; {}docs/reference/files.md lists them", shown(key),
                     near == keys.end() ? "" : fmt::format("did you mean '{}'? ", near->name));
}

std::string why_not_varied(std::string_view key) {
  if (std::string why = why_no_key(key); !why.empty()) return why;
  const RobotKey::Kind kind = find_robot_key(key)->kind;
  const bool number = kind == RobotKey::Kind::number || kind == RobotKey::Kind::number_or_false;
  return number ? "" : fmt::format("'{}' is no number that can be varied", shown(key));
}

}  // namespace labmouse
