#include "labmouse/lab/store/contest_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/races/value_json.hpp"
#include "labmouse/lab/store/contest_key.hpp"
#include "labmouse/lab/store/figures.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

/// The fields of a contest's JSON that have no column of their own and are not timings.
std::string fields_text(const Race& race, const ContestResult& result) {
  Json json = Json::object();
  for (const ContestField& field : race.world().traits().fields->contest) {
    if (field.key == "maze" || field.key == "seed" || field.key == "outcome" || field.by_clock) continue;
    const Value value = field.of(race, result);
    if (!std::holds_alternative<std::monostate>(value)) json[std::string(field.key)] = json_of(value);
  }
  return one_line(json);
}

}  // namespace

std::string about_text(const Contestant& mouse) {
  Json json = Json::object();
  if (mouse.reference) json["reference"] = true;
  if (mouse.uses_chance) json["uses_chance"] = true;
  if (mouse.runs > 0) json["runs"] = mouse.runs;
  if (!mouse.note.empty()) json["note"] = mouse.note;
  if (mouse.interpreter)
    json["interpreter"] = {{"path", mouse.interpreter->path}, {"version", mouse.interpreter->version}};
  if (mouse.sandboxed) json["sandboxed"] = *mouse.sandboxed;
  if (mouse.keeps_folder) json["keeps_folder"] = true;
  if (!mouse.why_no_sandbox.empty()) json["why_no_sandbox"] = mouse.why_no_sandbox;
  return one_line(json);
}

void read_about(std::string_view about, Contestant& mouse) {
  const ReadJson json = read_json(about);
  const auto flag = [&](const char* key) {
    return json.contains(key) && json[key].is_boolean() && json[key].get<bool>();
  };
  const auto text = [](const ReadJson& object, const char* key) {
    return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
  };
  if (!json.is_object()) return;
  mouse.reference = flag("reference");
  mouse.uses_chance = flag("uses_chance");
  if (json.contains("runs") && json["runs"].is_number_integer()) mouse.runs = json["runs"].get<int>();
  mouse.note = text(json, "note");
  if (json.contains("interpreter") && json["interpreter"].is_object())
    mouse.interpreter = {text(json["interpreter"], "path"), text(json["interpreter"], "version")};
  if (json.contains("sandboxed")) mouse.sandboxed = flag("sandboxed");
  mouse.keeps_folder = flag("keeps_folder");
  mouse.why_no_sandbox = text(json, "why_no_sandbox");
}

std::string parameters_text(const World& world, const Contestant& mouse) {
  Json json = Json::object();
  const Settings settings = world.settings(mouse);
  for (const Setting& setting : settings.all()) json[setting.name] = setting.value;
  return one_line(json);
}

RaceRows rows_of(const Race& race) {
  const World& world = race.world();
  RaceRows rows;
  rows.world_key = key_of(world);
  rows.world = world.traits().name;
  rows.conditions = conditions_text(world);
  rows.unit = world.traits().unit;
  rows.race_seed = fmt::format("{}", race.order.seed);
  for (const Contestant& mouse : race.mice)
    rows.mice.push_back(
        {key_of(world, mouse), mouse.name, spec_of(mouse), parameters_text(world, mouse), about_text(mouse)});
  for (std::size_t i = 0; i < race.mazes.size(); ++i)
    rows.mazes.push_back(
        {key_of(race.mazes[i].maze), race.mazes[i].name, race.mazes[i].maze.size(), race.facts[i].bound});
  return rows;
}

ContestRow row_of(std::shared_ptr<const RaceRows> rows, const Race& race, const ContestResult& result) {
  ContestRow row;
  row.race = std::move(rows);
  row.mouse = result.mouse;
  row.maze = result.maze;
  row.fields = fields_text(race, result);
  row.result = result;
  const StoredFigures& stored = race.world().traits().fields->figures;
  std::vector<Value> timings, figures = stored.values_of(*result.figures);
  row.result.figures.reset();
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (stored.all[i].by_clock) timings.push_back(std::exchange(figures[i], Value(0.0)));
  row.figures = figures_text(figures);
  if (!timings.empty()) row.timings = figures_text(timings);
  row.time = static_cast<std::int64_t>(std::time(nullptr));
  return row;
}

bool fill_in(const Statement& row, const World& world, ContestResult& result) {
  const StoredFigures& stored = world.traits().fields->figures;
  auto values = read_figures(row.text("figures"));
  const auto race_seed = parse_whole<std::uint64_t>(row.text("race_seed"));
  if (!values || !race_seed) return false;
  const auto timings = row.is_null("timings") ? std::nullopt : read_figures(row.text("timings"));
  for (std::size_t i = 0, timing = 0; timings && i < std::min(values->size(), stored.all.size()); ++i)
    if (stored.all[i].by_clock && timing < timings->size()) (*values)[i] = (*timings)[timing++];
  auto figures = stored.figures_of(*values);
  if (!figures) return false;
  result.run = static_cast<int>(row.whole("run"));
  result.told = seed_of_program(*race_seed, result.run);
  result.outcome = today_value(row.text("outcome"));
  result.outcome_order = static_cast<int>(row.whole("outcome_order"));
  result.never_started = row.text("never_started");
  result.score = row.real("score");
  result.counted = row.real("counted");
  result.ratio = row.real("ratio");
  result.figures = std::move(figures);
  result.done = true;
  return true;
}

}  // namespace labmouse
