#include <fmt/format.h>

#include "labmouse/lab/records/record_file.hpp"
#include "labmouse/lab/records/record_maze.hpp"
#include "labmouse/lab/records/record_parts.hpp"
#include "labmouse/lab/records/record_reasons.hpp"
#include "labmouse/lab/text/json_fields.hpp"
#include "labmouse/lab/text/json_lines.hpp"

namespace labmouse {
namespace {

/// Reads the header's maze, whose drawing may be missing; returns what is wrong, or nothing.
std::string read_maze_field(const ReadJson& json, RecordFile& file) {
  JsonFields fields(json, "maze");
  if (fields.has("name")) file.maze_name = fields.text("name");
  if (fields.has("drawing"))
    file.maze = read_record_maze(fields);
  else if (fields.has("start") || fields.has("heading") || fields.has("goals"))
    fields.fail("has a start, a heading or goals, but no drawing");
  return fields.error();
}

std::string read_mouse_field(const ReadJson& json, RecordFile& file) {
  JsonFields fields(json, "mouse");
  if (fields.has("name")) file.mouse = fields.text("name");
  if (fields.has("spec")) file.spec = fields.text("spec");
  if (fields.has("interpreter")) file.interpreter = fields.text("interpreter");
  return fields.error();
}

/// Reads the header into the file; returns what is wrong, or nothing.
std::string read_header(const ReadJson& json, RecordFile& file) {
  JsonFields fields(json, "");
  if (fields.text("labmouse") == "mms record")
    fields.fail("is the header of an mms record, which can be drawn but not replayed");
  if (fields.text("labmouse") != "record") fields.fail("is not the header of a record");
  if (fields.whole("format", 0, 1'000'000) != 1)
    fields.fail("has a format other than 1, which this version cannot read");
  if (!fields.error().empty()) return fields.error();
  if (fields.has("version")) file.version = fields.text("version");
  if (fields.has("world")) file.world = fields.text("world");
  if (fields.has("seed") && !json["seed"].is_number_unsigned()) return "'seed' is not a number from 0 to 2^64 - 1";
  if (fields.has("seed")) file.seed = json["seed"].get<std::uint64_t>();
  std::string error;
  if (fields.has("rules")) error = read_record_rules(json["rules"], file.rules);
  if (error.empty() && fields.has("mouse")) error = read_mouse_field(json["mouse"], file);
  if (error.empty() && fields.has("maze")) error = read_maze_field(json["maze"], file);
  return error;
}

Action read_action(const ReadJson& json, JsonFields& fields) {
  constexpr int far = 1'000'000;  // invalid rotations and movements are recorded too, within this limit
  if (json.is_array() && json.size() == 2)
    return Action::step(fields.whole(json[0], "action", -far, far), fields.whole(json[1], "action", -far, far));
  if (json == "reset") return Action::reset();
  constexpr std::string_view forfeit = "forfeit: ";
  if (const std::string text = json.is_string() ? json.get<std::string>() : ""; text.starts_with(forfeit))
    if (const auto reason = forfeit_reason_of(text.substr(forfeit.size()))) return Action::forfeit(*reason);
  return fields.fail("has an action that is neither [rotation, movement] nor reset nor forfeit", Action());
}

Run read_run(JsonFields& fields) {
  const std::string name = fields.text("run");
  const std::string_view run = today_value(name);
  if (run != "search" && run != "speed") fields.fail("has a run that is neither search nor speed");
  return run == "speed" ? Run::speed : Run::search_run;
}

Sighting read_reading(JsonFields& fields) {
  const ReadJson& reading = fields.list("reading");
  if (reading.size() != 3) return fields.fail("has a reading that is not [left, ahead, right]", Sighting());
  const auto cells = [&](std::size_t direction) { return fields.whole(reading[direction], "reading", 0, max_side); };
  return {cells(0), cells(1), cells(2)};
}

/// Reads the given fields of a step, apart from its action and its number.
StepRecord read_given(JsonFields& fields, const GivenFields& given) {
  StepRecord step;
  if (given.run) step.run = read_run(fields);
  if (given.cell) step.pose.cell = fields.cell("cell");
  if (given.heading) step.pose.heading = fields.heading("heading");
  if (given.reading) step.sighting = read_reading(fields);
  if (given.blocked) step.blocked = fields.flag("blocked");
  return step;
}

GivenFields given_in(const JsonFields& fields) {
  return {fields.has("run"), fields.has("cell"), fields.has("heading"), fields.has("reading"), fields.has("blocked")};
}

std::string read_step(const ReadJson& json, RecordFile& file) {
  const auto due = static_cast<int>(file.run.steps.size()) + 1;
  if (due > longest_record) return fmt::format("the record has more than {} steps", longest_record);
  JsonFields fields(json, "");
  const GivenFields given = given_in(fields);
  StepRecord step = read_given(fields, given);
  step.step = fields.has("step") ? fields.whole("step", 1, longest_record) : due;
  step.action = fields.has("action") ? read_action(json["action"], fields) : (fields.fail("has no action"), Action());
  if (step.step != due) fields.fail(fmt::format("has step {} instead of step {}", step.step, due));
  file.run.steps.push_back(step);
  file.given.push_back(given);
  if (!fields.has("reasons") || !fields.error().empty()) return fields.error();
  const Size size = file.maze ? file.maze->size() : Size{max_side, max_side};
  return read_reasons(json["reasons"], size, file.run.reasons.emplace_back(StepReasons{step.step, {}}).reasons);
}

std::string read_end(const ReadJson& json, RecordFile& file) {
  JsonFields fields(json, "");
  if (fields.has("last_words")) file.run.last_words = fields.text("last_words").substr(0, longest_last_words);
  if (fields.has("counts"))
    if (auto error = read_record_counts(json["counts"], file.run.counts); !error.empty()) return error;
  const std::string name = fields.text("outcome");
  file.given_end = given_in(fields);
  if (file.given_end.cell) file.run.end.cell = fields.cell("cell");
  if (file.given_end.heading) file.run.end.heading = fields.heading("heading");
  const bool gave_up = !file.run.steps.empty() && file.run.steps.back().action.kind == Action::Kind::forfeit;
  if (gave_up != (name == name_of(Outcome::forfeit))) fields.fail("and the last step disagree about a forfeit");
  if (const auto outcome = outcome_of(name)) {
    file.run.outcome = *outcome;
    file.ended = true;
    return fields.error();
  }
  return fmt::format("'outcome' is '{}', which this version does not know", name);
}

/// Reads one line after the header; returns what is wrong, or nothing.
std::string read_line(const ReadJson& json, RecordFile& file) {
  if (file.ended) return "the line comes after the end of the record";
  const auto has = [&](const char* key) { return json.is_object() && json.contains(key); };
  if (has("outcome")) return read_end(json, file);
  if (has("labmouse") && !has("action")) return "the line is a second header; a file must hold only one record";
  return read_step(json, file);
}

}  // namespace

ReadRecordResult read_record(std::string_view text) {
  RecordFile file;
  file.maze_name = "maze";
  file.mouse = "robot";
  file.ended = false;
  std::vector<Problem> problems =
      read_json_lines(text, {[&](const ReadJson& line) { return read_header(line, file); },
                             [&](const ReadJson& line) { return read_line(line, file); }, [&] { return !file.ended; }});
  if (!problems.empty()) return {std::nullopt, std::move(problems)};
  return {std::move(file), {}};
}

}  // namespace labmouse
