#include "labmouse/lab/standings/race_names.hpp"

#include <algorithm>
#include <variant>

#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Whether a race in the same world has another value of that condition.
bool differs(std::span<const Race> races, const World& world, const Condition& condition) {
  return std::any_of(races.begin(), races.end(), [&](const Race& race) {
    if (race.world().traits().name != world.traits().name) return false;
    const std::vector<Condition> others = race.world().traits().conditions;
    return std::any_of(others.begin(), others.end(), [&](const Condition& other) {
      return other.key == condition.key && text_of(other.value) != text_of(condition.value);
    });
  });
}

/// The value, or its name: robots and rules are objects with one. Printable.
std::string short_text(const Value& value) {
  const std::string text = text_of(value);
  if (std::holds_alternative<JsonText>(value))
    if (const ReadJson object = read_json(text); object.is_object() && object.contains("name"))
      return shown(object["name"].get<std::string>());
  return shown(text);
}

}  // namespace

std::string robot_name(const World& world) {
  for (const Condition& condition : world.traits().conditions)
    if (condition.key == "robot") return short_text(condition.value);
  return "";
}

std::vector<std::string> race_names(std::span<const Race> races) {
  std::vector<std::string> names;
  for (const Race& race : races) {
    const World& world = race.world();
    std::string name(world.traits().name);
    for (const Condition& condition : world.traits().conditions) {
      // The tables follow from the robot.
      if (condition.key == "tables" || !differs(races, world, condition)) continue;
      name += ", ";
      if (condition.key != "robot") name += condition.key + " ";
      name += short_text(condition.value);
    }
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace labmouse
