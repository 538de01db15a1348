#include "labmouse/lab/worlds/robot_variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/robots/robot_family.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"
#include "labmouse/lab/robots/robot_remarks.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// "--world seconds or --world physical": the worlds in which robots can be changed.
std::string worlds_of_robots() {
  std::string text;
  for (const WorldEntry* entry : all_worlds())
    if (has(*entry, "robot") && entry->why_one_robot.empty())
      text += fmt::format("{}--world {}", text.empty() ? "" : " or ", entry->name);
  return text;
}

/// Why the robot of this world cannot be changed; empty where it can.
std::string why_no_robots(const WorldEntry& world) {
  if (!has(world, "robot")) return fmt::format("the world {} has no robots; choose {}", world.name, worlds_of_robots());
  if (world.why_one_robot.empty()) return "";
  return fmt::format("the world {} {}; choose {}", world.name, world.why_one_robot, worlds_of_robots());
}

/// Whether contests of this world depend on the hardware: its conditions list all that they depend on.
bool depends_on_hardware(const World& world) {
  for (const Condition& condition : world.traits().conditions) {
    if (condition.key != "robot") continue;
    const ReadJson robot = read_json(text_of(condition.value));
    if (robot.is_object() && robot.contains("parameters")) return robot["parameters"].contains("body.front");
  }
  return false;
}

/// Why the key cannot be varied in this world; empty where it can.
std::string why_not(const Entry& entry, std::string_view key) {
  if (std::string why = why_no_robots(*find_world(entry.world->traits().name)); !why.empty()) return why;
  if (std::string why = why_no_key(key); !why.empty()) return why;
  if (find_robot_key(key)->with != RobotKey::With::body || depends_on_hardware(*entry.world)) return "";
  return fmt::format("'{}' changes nothing in the world {}, which does not simulate the hardware", key,
                     entry.world->traits().name);
}

/// The value in one spelling: 3000 for 3e3.
std::string plain(const std::string& value) {
  const std::optional<double> number = parse_number(value);
  return number ? fmt::format("{}", *number) : value;
}

/// A message without the word that begins it.
std::string without_error(const std::string& message) {
  constexpr std::string_view word = "error: ";
  return message.starts_with(word) ? message.substr(word.size()) : message;
}

std::vector<std::string> remarks_of(const RobotResult& robot) { return robot_remarks(*robot.robot, robot.model); }

/// Makes the robots of one entry.
class VariantMaker {
 public:
  VariantMaker(const Entry& entry, const RobotFamily& family, RobotVariants& made)
      : entry_(entry), family_(family), made_(made), usual_(remarks_of(family.with({}))) {}

  /// Adds the robot with this value; returns what is wrong, or nothing.
  std::string add(const std::string& value) {
    const std::string name = fmt::format("{} {}={}", made_.robot, made_.key, value);
    const std::string text = family_.text_with(made_.key, value);
    const RobotResult robot = read_robot(text, name);
    if (!robot.robot) return robot.problems.front().reason;
    WorldSettings settings = entry_.settings;
    settings["robot"] = fmt::format("{}\n{}", name, text);
    WorldResult world = find_world(entry_.world->traits().name)->make(settings);
    if (!world.error.empty()) return without_error(world.error);
    made_.worlds.push_back(std::move(world.world));
    made_.values.push_back(value);
    // The remarks on the robot itself are the user's already.
    for (const std::string& remark : remarks_of(robot))
      if (std::find(usual_.begin(), usual_.end(), remark) == usual_.end())
        made_.remarks.push_back(fmt::format("{}={}: {}", made_.key, value, remark));
    return "";
  }

 private:
  const Entry& entry_;
  const RobotFamily& family_;
  RobotVariants& made_;
  std::vector<std::string> usual_;
};

RobotVariants refused(const std::string& what, const std::string& why) {
  RobotVariants none;
  none.error = fmt::format("error: --robot-number {}: {}", shown(what), why);
  return none;
}

}  // namespace

RobotVariants robot_variants(const Entry& entry, std::string_view key, std::span<const std::string> values) {
  if (const std::string why = why_not(entry, key); !why.empty()) return refused(std::string(key), why);
  const RobotKey& found = *find_robot_key(key);
  RobotVariants made;
  const std::string given = text_of(find_world(entry.world->traits().name)->settings, entry.settings, "robot");
  made.robot = given.substr(0, given.find('\n'));
  made.key = key;
  made.meaning = fmt::format("{}{}{}", found.meaning, found.unit.empty() ? "" : ", in ", found.unit);
  const FoundFamily family = find_robot_family(given);
  if (!family.family) return refused(made.key, family.error);
  VariantMaker maker(entry, *family.family, made);
  for (const std::string& each : values) {
    const std::string value = plain(each);
    if (std::find(made.values.begin(), made.values.end(), value) != made.values.end()) continue;
    if (const std::string why = maker.add(value); !why.empty()) return refused(fmt::format("{}={}", key, value), why);
  }
  return made;
}

}  // namespace labmouse
