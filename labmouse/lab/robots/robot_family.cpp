#include "labmouse/lab/robots/robot_family.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/robots/robot_keys.hpp"
#include "labmouse/lab/robots/robot_text.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {

RobotFamily::RobotFamily(std::string_view text, std::string_view name) : name_(name), values_(robot_values(text)) {}

RobotResult RobotFamily::with(std::span<const RobotNumber> numbers) const {
  Json values = values_;
  for (const RobotNumber& number : numbers) values[std::string(number.key)] = number.value;
  return read_robot(robot_text(ReadJson(values)), name_);
}

std::string why_not_varied(std::string_view key) {
  const auto keys = robot_keys();
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const RobotKey& known) { return known.name == key; });
  if (found == keys.end()) {
    const std::string ending = fmt::format(".{}", key);
    const auto near =
        std::find_if(keys.begin(), keys.end(), [&](const RobotKey& known) { return known.name.ends_with(ending); });
    return fmt::format("'{}' is no key of robot files; {}docs/reference/files.md lists them", shown(key),
                       near == keys.end() ? "" : fmt::format("did you mean '{}'? ", near->name));
  }
  const bool number = found->kind == RobotKey::Kind::number || found->kind == RobotKey::Kind::number_or_false;
  return number ? "" : fmt::format("'{}' is no number that can be varied", shown(key));
}

}  // namespace labmouse
