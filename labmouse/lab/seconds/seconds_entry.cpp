#include "labmouse/lab/seconds/seconds_entry.hpp"

#include <fmt/format.h>

#include <array>

#include "labmouse/lab/records/drive_record_fields.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/seconds/drive_results.hpp"
#include "labmouse/lab/seconds/seconds_world.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

constexpr std::array settings = {
    WorldSetting{"robot", "ROBOT", "Built-in robot, or a file whose name contains a slash or ends in .toml",
                 WorldSetting::Kind::text, "classic"},
    WorldSetting{"rules", "RULES", "Built-in rules in seconds, or a file whose name contains a slash or ends in .toml",
                 WorldSetting::Kind::text, "all-japan"}};

WorldResult make(const WorldSettings& chosen) {
  FoundRobot robot = find_robot(value_of(seconds_entry, chosen, "robot"));
  if (!robot.errors.empty()) return {nullptr, fmt::format("{}", fmt::join(robot.errors, "\n"))};
  FoundRules rules = find_rules(value_of(seconds_entry, chosen, "rules"));
  if (!rules.errors.empty()) return {nullptr, fmt::format("{}", fmt::join(rules.errors, "\n"))};
  return {seconds_world(rules.rules, std::make_shared<DriveModel>(std::move(robot.model))), "",
          std::move(robot.remarks)};
}

std::shared_ptr<const World> restore(const ReadJson& conditions) {
  if (!conditions.is_object() || !conditions.contains("rules") || !conditions.contains("robot")) return nullptr;
  JsonFields fields(conditions, "");
  DriveRules rules;
  read_drive_rules_json(conditions["rules"], rules, fields);
  DriveModel model = read_robot_json(fields, conditions["robot"]);
  if (!fields.error().empty() || !model.error.empty()) return nullptr;
  return seconds_world(rules, std::make_shared<DriveModel>(std::move(model)));
}

}  // namespace

const WorldEntry seconds_entry = {
    "seconds",         "a robot that drives curves and diagonals, by the rules of real contests",
    settings,          make,
    pack_drive_record, false,
    restore,           "drive"};

}  // namespace labmouse
