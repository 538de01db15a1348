#include "labmouse/lab/drive/drive_entries.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/drive/drive_results.hpp"
#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/failure_rates/builtin_failure_rates.hpp"
#include "labmouse/lab/failure_rates/physical_settings.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/records/drive_record_fields.hpp"
#include "labmouse/lab/replays/replay.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr WorldSetting robot_setting(std::string_view usual) {
  return {.name = "robot",
          .placeholder = "ROBOT",
          .meaning =
              "Built-in robot, or a file whose name contains a slash or ends in .toml; several, separated by commas, "
              "give a race each",
          .default_value = usual,
          .listed = true};
}
constexpr WorldSetting rules_setting = {
    .name = "rules",
    .placeholder = "RULES",
    .meaning = "Built-in rules in seconds, or a file whose name contains a slash or ends in .toml",
    .default_value = "all-japan",
    .half_size_default = "all-japan-half"};
constexpr std::array seconds_settings = {robot_setting("classic"), rules_setting};
constexpr std::array common_settings = {robot_setting("kerise"), rules_setting};
constexpr auto physical_settings = joined(common_settings, settings_of<physical_rows>);

std::vector<std::string> rates_brought() {
  std::vector<std::string> names;
  for (const BuiltinRates& brought : builtin_failure_rates()) names.emplace_back(brought.name);
  return names;
}

constexpr WorldSetting rates_setting = {
    .name = "failure-rates",
    .placeholder = "RATES",
    .meaning =
        "Failure rates: built-in, or a file whose name contains a slash or ends in .json, which "
        "`labmouse failure-rates --save` writes",
    .default_value = "kerise",
    .brought = rates_brought};
constexpr auto failures_settings =
    joined(common_settings, settings_of<failures_rows>, std::array<WorldSetting, 1>{rates_setting});

/// What the worlds are made of, or what is wrong with it.
struct Parts {
  DriveRules rules;
  std::shared_ptr<const DriveModel> model;
  PhysicalConditions conditions;
  std::vector<std::string> remarks;
  std::string error;
};

/// Robot and rules.
Parts parts_of(const WorldEntry& entry, const WorldSettings& chosen) {
  Parts parts;
  FoundRobot robot = find_robot(text_of(entry.settings, chosen, "robot"));
  FoundRules rules = find_rules(text_of(entry.settings, chosen, "rules"));
  const std::vector<std::string>& errors = robot.errors.empty() ? rules.errors : robot.errors;
  parts.error = fmt::format("{}", fmt::join(errors, "\n"));
  if (!parts.error.empty()) return parts;
  parts.rules = rules.rules;
  parts.model = std::make_shared<DriveModel>(std::move(robot.model));
  parts.remarks = std::move(robot.remarks);
  return parts;
}

WorldResult make_seconds(const WorldSettings& chosen) {
  Parts parts = parts_of(seconds_entry, chosen);
  if (!parts.error.empty()) return {nullptr, parts.error};
  return {seconds_world(parts.rules, parts.model), "", std::move(parts.remarks)};
}

/// Robot, rules and the conditions of a world with errors.
template <class Rows>
Parts parts_with_errors(const WorldEntry& entry, const Rows& rows, const WorldSettings& chosen) {
  Parts parts = parts_of(entry, chosen);
  if (!parts.error.empty()) return parts;
  if (const std::string why = why_not_physical(*parts.model); !why.empty())
    parts.error =
        fmt::format("error: --robot: {} cannot drive in the physical world: {}", shown(parts.model->robot.name), why);
  else
    parts.error = choose(rows, chosen, parts.conditions);
  return parts;
}

WorldResult make_physical(const WorldSettings& chosen) {
  Parts parts = parts_with_errors(physical_entry, physical_rows, chosen);
  if (!parts.error.empty()) return {nullptr, parts.error};
  return {physical_world(parts.rules, parts.model, parts.conditions), "", std::move(parts.remarks)};
}

std::shared_ptr<const World> failures_world_of(const DriveRules& rules, std::shared_ptr<const DriveModel> model,
                                               PhysicalConditions conditions, const FailureFile& failure_rates) {
  conditions.errors.noise = failure_rates.noise;
  conditions.controller.search_speed = 0.0;
  return failure_world(rules, std::move(model), conditions, failure_rates);
}

WorldResult make_failures(const WorldSettings& chosen) {
  Parts parts = parts_with_errors(failures_entry, failures_rows, chosen);
  if (!parts.error.empty()) return {nullptr, parts.error};
  const FoundRates failure_rates = find_rates(text_of(failures_settings, chosen, "failure-rates"));
  if (!failure_rates.file) return {nullptr, failure_rates.error};
  if (const std::string why = why_not_failures(*parts.model, parts.conditions.errors.variation, *failure_rates.file);
      !why.empty())
    return {nullptr, why};
  return {failures_world_of(parts.rules, parts.model, parts.conditions, *failure_rates.file), "",
          std::move(parts.remarks)};
}

/// Robot and rules from the JSON of a world's conditions; nothing if they are invalid.
std::optional<Parts> restored_parts(const ReadJson& json) {
  if (!json.is_object() || !json.contains("rules") || !json.contains("robot")) return std::nullopt;
  JsonFields fields(json, "");
  Parts parts;
  read_drive_rules_json(json["rules"], parts.rules, fields);
  DriveModel model = read_robot_json(fields, json["robot"]);
  if (!fields.error().empty() || !model.error.empty()) return std::nullopt;
  parts.model = std::make_shared<DriveModel>(std::move(model));
  return parts;
}

/// Robot, rules and conditions from the JSON of a world with errors; nothing if they are invalid.
std::optional<Parts> restored_with_errors(const ReadJson& json) {
  std::optional<Parts> parts = restored_parts(json);
  if (!parts || !why_not_physical(*parts->model).empty()) return std::nullopt;
  JsonFields fields(json, "");
  read_settings(physical_rows, fields, parts->conditions);
  return fields.error().empty() ? parts : std::nullopt;
}

std::shared_ptr<const World> restore_seconds(const ReadJson& json) {
  const std::optional<Parts> parts = restored_parts(json);
  return parts ? seconds_world(parts->rules, parts->model) : nullptr;
}

std::shared_ptr<const World> restore_physical(const ReadJson& json) {
  const std::optional<Parts> parts = restored_with_errors(json);
  return parts ? physical_world(parts->rules, parts->model, parts->conditions) : nullptr;
}

/// Restores the failure model; null if the program has no built-in failure rates of that name and hash.
std::shared_ptr<const World> restore_failures(const ReadJson& json) {
  const std::optional<Parts> parts = restored_with_errors(json);
  if (!parts || !json.contains("failure_rates") || !json["failure_rates"].is_string()) return nullptr;
  if (!json.contains("failure_rates_hash") || !json["failure_rates_hash"].is_string()) return nullptr;
  const auto failure_rates =
      builtin_rates_of(json["failure_rates"].get<std::string>(), json["failure_rates_hash"].get<std::string>());
  if (!failure_rates || !why_not_failures(*parts->model, parts->conditions.errors.variation, *failure_rates).empty())
    return nullptr;
  return failures_world_of(parts->rules, parts->model, parts->conditions, *failure_rates);
}

}  // namespace

/// The largest variation at which failure rates were measured for every pace.
double most_variation_of(const FailureFile& failure_rates) {
  double most = failure_rates.tallies.back().variation;
  for (std::size_t i = 0; i + 1 < failure_rates.tallies.size(); ++i)
    if (failure_rates.tallies[i].pace != failure_rates.tallies[i + 1].pace)
      most = std::min(most, failure_rates.tallies[i].variation);
  return most;
}

std::string why_not_failures(const DriveModel& model, double variation, const FailureFile& failure_rates) {
  if (failure_rates.tables != hash_text(model.tables.hash))
    return fmt::format(
        "error: --failure-rates: {} were counted of the robot {}, which is not that of --robot, {}; count those of "
        "yours with "
        "`labmouse failure-rates --robot {} --save FILE`",
        shown(failure_rates.name), shown(failure_rates.robot), shown(model.robot.name), shown(model.robot.name));
  if (failure_rates.search_speed != 0.0)
    return fmt::format(
        "error: --failure-rates: {} were counted at a speed of its own, {:g} mm/s; count them with --search-speed 0",
        shown(failure_rates.name), failure_rates.search_speed);
  if (failure_rates.edition != physical_edition)
    return fmt::format(
        "error: --failure-rates: {} were counted in edition {} of the physical world, which is edition {} now; count "
        "them again with `labmouse failure-rates --save FILE`",
        shown(failure_rates.name), failure_rates.edition, physical_edition);
  if (const double most = most_variation_of(failure_rates); variation > most)
    return fmt::format("error: --variation: {:g} is more than {:g}, the most under which {} were counted", variation,
                       most, shown(failure_rates.name));
  return "";
}

const WorldEntry seconds_entry = {.name = "seconds",
                                  .summary = "a robot that drives curves and diagonals, by the rules of real contests",
                                  .settings = seconds_settings,
                                  .make = make_seconds,
                                  .records = &drive_records,
                                  .restore = restore_seconds};

const WorldEntry physical_entry = {
    .name = "physical",
    .summary = "the same robot with its errors: it slips, detects walls wrongly and crashes",
    .settings = physical_settings,
    .make = make_physical,
    .records = &drive_records,
    .restore = restore_physical,
    .usual_runs = 3};

const WorldEntry failures_entry = {
    .name = "failures",
    .former_name = "fallible",
    .summary = "the world in seconds with random failures at the rates of the physical world: fast",
    .settings = failures_settings,
    .make = make_failures,
    .records = &drive_records,
    .restore = restore_failures,
    .why_one_robot = "has failure rates, which were counted of one robot"};

}  // namespace labmouse
