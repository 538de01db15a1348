#include "labmouse/lab/standings/race_json.hpp"

#include <algorithm>

#include "labmouse/lab/races/value_json.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/json_stream.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Sets the field, where the value says anything.
void set(Json& json, std::string_view key, const Value& value) {
  if (!std::holds_alternative<std::monostate>(value)) json[std::string(key)] = json_of(value);
}

Json mazes_json(const Race& race) {
  Json mazes = Json::array();
  for (std::size_t maze = 0; maze < race.mazes.size(); ++maze) {
    Json& json = mazes.emplace_back(Json::object());
    for (const MazeField& field : race.world().traits().fields->maze) set(json, field.key, field.of(race, maze));
  }
  return mazes;
}

void write_results(const Race& race, std::size_t mouse, JsonStream& out) {
  out.begin_list("results");
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != mouse || !contest.done) continue;
    Json json = Json::object();
    for (const ContestField& field : race.world().traits().fields->contest)
      set(json, field.key, field.of(race, contest));
    out.value(json);
  }
  out.end();
}

/// Where a mouse comes from, as far as its name does not say it.
void set_origin(const Contestant& mouse, Json& json) {
  if (!mouse.spec.empty()) json["spec"] = mouse.spec;
  if (!mouse.note.empty()) json["note"] = mouse.note;
  if (mouse.interpreter)
    json["interpreter"] = {{"path", mouse.interpreter->path}, {"version", mouse.interpreter->version}};
  if (mouse.sandboxed) json["sandboxed"] = *mouse.sandboxed;
  if (mouse.keeps_folder) json["keeps_folder"] = true;
}

/// The columns of the leaderboard that JSON has as text: without those that readers can compute from other fields, and
/// without rare ones, which can be times that differ from race to race.
std::vector<const Column*> own_columns(const Race& race) {
  std::vector<const Column*> own;
  for (const Column& column : race.world().traits().fields->columns)
    if (!column.rare && column.text != columns::finished && column.text != columns::mean_all) own.push_back(&column);
  return own;
}

/// What a program that does not know this world needs to show its race.
void describe_world(const Race& race, Json& json) {
  const World& world = race.world();
  const ScorePlace place = world.traits().score_place;
  json["unit"] = world.traits().unit;
  json["score"] = {{"key", place.key}, {"inner", place.inner}, {"unit", place.unit}};
  json["bound"] = bound_place_json(world);
  json["failure_score"] = world.traits().failure_score ? Json(*world.traits().failure_score) : Json(nullptr);
  json["limit_score"] = world.traits().limit_score;
  json["columns"] = Json::array();
  for (const Column* column : own_columns(race))
    json["columns"].push_back(columns::heading(column->first, second_line_of(*column, world)));
}

Json cells_json(const Race& race, const Standing& standing) {
  Json cells = Json::array();
  for (const Column* column : own_columns(race)) cells.push_back(column->text(race, standing));
  return cells;
}

void write_mice(const Race& race, JsonStream& out) {
  out.begin_list("mice");
  for (const Standing& standing : standings_of(race)) {
    Json json = Json::object();
    for (const MouseField& field : race.world().traits().fields->mouse) set(json, field.key, field.of(race, standing));
    set_origin(race.mice[standing.mouse], json);
    json["cells"] = cells_json(race, standing);
    out.begin_object();
    out.fields(json);
    write_results(race, standing.mouse, out);
    out.end();
  }
  out.end();
}

void set_conditions(const Race& race, Json& json) {
  for (const Condition& condition : race.world().traits().conditions) set(json, condition.key, condition.value);
}

Json lines_of(std::string_view text) {
  Json lines = Json::array();
  for (std::size_t end = 0; !text.empty(); text.remove_prefix(end + 1)) {
    end = text.find('\n');
    lines.push_back(text.substr(0, end));
  }
  return lines;
}

void write_group(const Race& race, JsonStream& out) {
  Json json = {{"world", race.world().traits().name}, {"formula", race.world().traits().formula}};
  describe_world(race, json);
  set_conditions(race, json);
  json["stopped"] = race.stopped;
  json["notes"] = lines_of(notes_of(race));
  json["mazes"] = mazes_json(race);
  out.begin_object();
  out.fields(json);
  write_mice(race, out);
  out.end();
}

Json skipped_json(const std::vector<SkippedFile>& skipped) {
  Json files = Json::array();
  for (const SkippedFile& file : skipped) {
    Json reasons = Json::array();
    for (const Problem& problem : file.problems) reasons.push_back(describe(file.path, problem));
    files.push_back({{"path", file.path}, {"reasons", std::move(reasons)}});
  }
  return files;
}

}  // namespace

Json bound_place_json(const World& world) {
  return {{"key", world.traits().fields->bound}, {"unit", world.traits().score_place.unit}};
}

void write_json(std::span<const Race> races, const std::vector<SkippedFile>& skipped, const TextSink& sink) {
  Json json;
  json["labmouse"] = version();
  json["compiler"] = compiler();
  json["processor"] = processor();
  json["seed"] = races.front().order.seed;
  json["stopped"] = std::any_of(races.begin(), races.end(), [](const Race& race) { return race.stopped; });
  JsonStream out(sink);
  out.begin_object();
  out.fields(json);
  out.begin_list("groups");
  for (const Race& race : races) write_group(race, out);
  out.end();
  out.value(skipped_json(skipped), "skipped");
  out.end();
  out.finish();
}

std::string json_of(std::span<const Race> races, const std::vector<SkippedFile>& skipped) {
  std::string text;
  write_json(races, skipped, [&text](std::string_view part) { text += part; });
  return text;
}

std::string json_of(const Race& race, const std::vector<SkippedFile>& skipped) { return json_of({&race, 1}, skipped); }

std::string text_of(const Json& json) {
  std::string text;
  JsonStream out([&text](std::string_view part) { text += part; });
  out.value(json);
  out.finish();
  return text;
}

Json race_json(std::span<const Race> races, const std::vector<SkippedFile>& skipped) {
  return Json::parse(json_of(races, skipped));
}

void write_csv(const Race& race, const TextSink& sink) {
  const auto fields = race.world().traits().fields->csv;
  std::string line;
  for (const ContestField& field : fields) line += (line.empty() ? "" : ",") + std::string(field.key);
  sink(line + "\n");
  for (const ContestResult& contest : race.results) {
    if (!contest.done) continue;
    line.clear();
    for (std::size_t i = 0; i < fields.size(); ++i)
      line += (i > 0 ? "," : "") + csv_field(text_of(fields[i].of(race, contest)));
    sink(line += "\n");
  }
}

std::string csv_of(const Race& race) {
  std::string text;
  write_csv(race, [&text](std::string_view part) { text += part; });
  return text;
}

}  // namespace labmouse
