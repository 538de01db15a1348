#include "labmouse/lab/physical/physical_entry.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <string_view>

#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/physical/physical_world.hpp"
#include "labmouse/lab/records/drive_record_fields.hpp"
#include "labmouse/lab/records/physical_lines.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/seconds/drive_results.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr std::array map_kinds = {name_of(MapKind::first), name_of(MapKind::belief)};

constexpr std::array settings = {
    WorldSetting{"robot", "ROBOT", "Built-in robot, or a file whose name contains a slash or ends in .toml",
                 WorldSetting::Kind::text, "kerise"},
    WorldSetting{"rules", "RULES", "Built-in rules in seconds, or a file whose name contains a slash or ends in .toml",
                 WorldSetting::Kind::text, "all-japan"},
    WorldSetting{"noise", "FACTOR", "Factor of all noise: 1 as it was measured, 0 none", WorldSetting::Kind::text, "1"},
    WorldSetting{"spread", "FACTOR", "How far contests are apart: factor of what each draws of the mouse itself",
                 WorldSetting::Kind::text, "4.25"},  // field_spread
    WorldSetting{"search-speed", "SPEED", "Speed of a search in mm/s; 0: the robot's own", WorldSetting::Kind::text,
                 "0"},
    WorldSetting{"map", "KIND",
                 "What mice do with a reading against their map: nothing, the first one stays (first), or weigh it "
                 "(belief)",
                 WorldSetting::Kind::text, "first", 0, 0, map_kinds}};

/// The number of a setting, or nothing, with what is wrong in the error.
std::optional<double> number_in(const WorldSettings& chosen, std::string_view name, double high, std::string& error) {
  const std::string text = value_of(physical_entry, chosen, name);
  // Not from_chars, which the page's library lacks for numbers like these.
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const bool whole =
      !text.empty() && std::string_view("0123456789.").find(text[0]) != std::string_view::npos && *end == '\0';
  if (whole && number >= 0.0 && number <= high) return number;
  if (error.empty()) error = fmt::format("--{}: '{}' is not a number from 0 to {:g}", name, shown(text), high);
  return std::nullopt;
}

WorldResult make(const WorldSettings& chosen) {
  FoundRobot robot = find_robot(value_of(physical_entry, chosen, "robot"));
  if (!robot.errors.empty()) return {nullptr, fmt::format("{}", fmt::join(robot.errors, "\n"))};
  FoundRules rules = find_rules(value_of(physical_entry, chosen, "rules"));
  if (!rules.errors.empty()) return {nullptr, fmt::format("{}", fmt::join(rules.errors, "\n"))};
  if (const std::string why = why_not_physical(robot.model); !why.empty())
    return {nullptr,
            fmt::format("--robot: {} cannot drive in the physical world: {}", shown(robot.model.robot.name), why)};
  std::string error;
  PhysicalConditions conditions;
  conditions.noise.all = number_in(chosen, "noise", 100.0, error).value_or(0.0);
  conditions.noise.spread = number_in(chosen, "spread", 10.0, error).value_or(0.0);
  conditions.pilot.search_speed = number_in(chosen, "search-speed", 20'000.0, error).value_or(0.0);
  const std::string map = value_of(physical_entry, chosen, "map");
  if (const std::optional<MapKind> kind = map_kind_of(map))
    conditions.map = *kind;
  else if (error.empty())
    error = fmt::format("--map: '{}' is neither first nor belief", shown(map));
  if (!error.empty()) return {nullptr, error};
  return {physical_world(rules.rules, std::make_shared<DriveModel>(std::move(robot.model)), conditions), "",
          std::move(robot.remarks)};
}

std::shared_ptr<const World> restore(const ReadJson& json) {
  if (!json.is_object() || !json.contains("rules") || !json.contains("robot")) return nullptr;
  JsonFields fields(json, "");
  DriveRules rules;
  read_drive_rules_json(json["rules"], rules, fields);
  DriveModel model = read_robot_json(fields, json["robot"]);
  PhysicalConditions conditions;
  conditions.noise.all = fields.number("noise", 0.0, 100.0);
  conditions.noise.spread = fields.number("spread", 0.0, 10.0);
  conditions.pilot.search_speed = fields.number("search_speed", 0.0, 20'000.0);
  if (json.contains("map")) conditions.map = map_kind_in(fields);
  if (!fields.error().empty() || !model.error.empty() || !why_not_physical(model).empty()) return nullptr;
  return physical_world(rules, std::make_shared<DriveModel>(std::move(model)), conditions);
}

}  // namespace

const WorldEntry physical_entry = {
    "physical", "the same robot as it is: it slips, misreads and crashes", settings, make, pack_drive_record, false,
    restore};

}  // namespace labmouse
