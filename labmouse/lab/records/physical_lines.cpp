#include "labmouse/lab/records/physical_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "labmouse/lab/failure_rates/physical_settings.hpp"
#include "labmouse/lab/records/drive_record_fields.hpp"
#include "labmouse/lab/records/record_maze.hpp"
#include "labmouse/lab/records/record_parts.hpp"
#include "labmouse/lab/text/number_rows.hpp"

namespace labmouse {
namespace {

constexpr std::size_t most_lines = 2'000'000, most_actions = 1'000'000, most_ticks = 7'200'000;
/// Ticks of an external controller in one line of the record.
constexpr std::size_t ticks_a_line = 10'000;

constexpr std::array<std::string_view, 5> words = {"drive", "fast", "goal", "carry", "give up"};

/// In whole micrometres and microradians.
std::int64_t millionths(double number) { return std::llround(number * 1e6); }
std::int64_t thousandths(double number) { return std::llround(number * 1e3); }

Json body_json(const BodyPose& pose) {
  return {thousandths(pose.position.x), thousandths(pose.position.y), millionths(pose.angle)};
}

std::int64_t long_at(const ReadJson& list, std::size_t index, const char* key, JsonFields& fields) {
  if (index < list.size() && list[index].is_number_integer()) {
    const auto number = list[index].get<std::int64_t>();
    if (number >= -longest_time && number <= longest_time) return number;
  }
  fields.fail(fmt::format("has a '{}' without a whole number at its place {}", key, index + 1));
  return 0;
}

BodyPose body_at(const ReadJson& list, std::size_t index, const char* key, JsonFields& fields) {
  const auto at = [&](std::size_t i) { return static_cast<double>(long_at(list, index + i, key, fields)); };
  return {{at(0) / 1e3, at(1) / 1e3}, at(2) / 1e6};
}

Json decision_json(const Action& action) {
  if (action.kind == Action::Kind::reset) return "reset";
  if (action.kind == Action::Kind::forfeit) return name_of(action.reason);
  return {action.rotation, action.movement};
}

Action decision_of(const ReadJson& json, JsonFields& fields) {
  if (json.is_array() && json.size() == 2)
    return Action::step(fields.whole(json[0], "actions", -180, 180),
                        fields.whole(json[1], "actions", 0, max_drive_side));
  if (json == "reset") return Action::reset();
  if (const auto reason = forfeit_reason_of(json.is_string() ? json.get<std::string>() : ""))
    return Action::forfeit(*reason);
  fields.fail("has an action that is neither [rotation, cells] nor reset nor a reason to give up");
  return Action::reset();
}

void read_look(Size size, PhysicalNotes& notes, JsonFields& fields) {
  Look look;
  look.pose = pose_in(fields, "look", size);
  look.time = fields.long_whole("time", 0, longest_time);
  const ReadJson& evidence = fields.list("evidence");
  if (evidence.size() != 3) return fields.fail("has an 'evidence' that is not [left, ahead, right]");
  const auto at = [&](std::size_t i) {
    return static_cast<Evidence>(fields.whole(evidence[i], "evidence", -127, 127));
  };
  look.evidence = {at(0), at(1), at(2)};
  notes.looks.push_back(look);
}

void read_touch(PhysicalNotes& notes, JsonFields& fields) {
  WallTouch touch;
  touch.at = body_at(fields.list("touch"), 0, "touch", fields);
  touch.time = fields.long_whole("time", 0, longest_time);
  touch.crash = fields.flag("crash");
  notes.touches.push_back(touch);
}

/// A line of the tape, the output of an external controller: a row of two duties for each tick, and under `said` the
/// commands other than `drive`, each with the number of its row.
std::string tape_line(std::span<const ControllerTick> ticks) {
  std::vector<std::int32_t> numbers;
  Json said = Json::array();
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    numbers.insert(numbers.end(), {ticks[i].left, ticks[i].right});
    if (ticks[i].word != ControllerWord::drive) said.push_back({i, words[static_cast<std::size_t>(ticks[i].word)]});
  }
  return record_line({{"tape", rows_text(numbers, 2)}, {"said", std::move(said)}});
}

void read_actions(PhysicalNotes& notes, JsonFields& fields) {
  const ReadJson& list = fields.list("actions");
  if (list.size() > most_actions) return fields.fail(fmt::format("has more than {} actions", most_actions));
  for (const ReadJson& action : list) notes.actions.push_back(decision_of(action, fields));
}

void read_tape(PhysicalNotes& notes, JsonFields& fields) {
  std::vector<std::int32_t> numbers;
  if (!read_rows(fields.text("tape"), 2, 2 * (most_ticks - notes.tape.size()), numbers))
    return fields.fail(fmt::format("has a 'tape' that is none, or that makes more than {} ticks", most_ticks));
  const std::size_t first = notes.tape.size();
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    const auto [least, most] = std::minmax(numbers[i], numbers[i + 1]);
    if (least < -ControllerTick::full || most > ControllerTick::full)
      return fields.fail(fmt::format("has duties of more than {}", ControllerTick::full));
    notes.tape.push_back({static_cast<std::int16_t>(numbers[i]), static_cast<std::int16_t>(numbers[i + 1])});
  }
  for (const ReadJson& each : fields.list("said")) {
    const bool whole = each.is_array() && each.size() == 2 && each[0].is_number_unsigned();
    const auto word = whole ? std::find(words.begin(), words.end(), each[1]) : words.end();
    const std::size_t row = whole ? each[0].get<std::size_t>() : 0;
    if (word == words.end() || row >= numbers.size() / 2)
      return fields.fail("has a 'said' that is not a list of [row, word]");
    notes.tape[first + row].word = static_cast<ControllerWord>(word - words.begin());
  }
}

void read_trace(std::size_t sensors, PhysicalNotes& notes, JsonFields& fields) {
  const ReadJson& list = fields.list("trace");
  const bool believes = list.size() == 7 + sensors;
  if (!believes && list.size() != 4 + sensors)
    return fields.fail(
        fmt::format("has a 'trace' that is not a time, one or two poses and a reading of each of the robot's {} "
                    "infrared sensors",
                    sensors));
  TracePoint point;
  point.time = long_at(list, 0, "trace", fields);
  point.truth = body_at(list, 1, "trace", fields);
  if (believes) point.estimate = body_at(list, 4, "trace", fields);
  for (std::size_t i = list.size() - sensors; i < list.size(); ++i)
    point.infrared.push_back(static_cast<std::int16_t>(fields.whole(list[i], "trace", 0, 32767)));
  notes.trace.push_back(std::move(point));
}

}  // namespace

Json pose_json(const Pose& pose) { return {pose.cell.x, pose.cell.y, name_of(pose.heading)}; }

Json conditions_json(const PhysicalPart& part) {
  const PhysicalConditions& conditions = part.conditions;
  Json causes = Json::object();
  for (std::size_t i = 0; i < error_causes; ++i)
    causes[std::string(name_of(static_cast<ErrorCause>(i)))] = conditions.errors.causes[i];
  const CorrectionChoice& corrections = conditions.controller.corrections;
  Json json = {
      {"edition", part.edition},
      {"noise", conditions.errors.noise},
      {"causes", std::move(causes)},
      {"variation", conditions.errors.variation},
      {"handling", conditions.handling},
      {"search_speed", conditions.controller.search_speed},
      {"map", name_of(conditions.map)},
      {"corrections", {{"sides", corrections.sides}, {"edges", corrections.edges}, {"front", corrections.front}}},
      {"trace_every", conditions.trace_every}};
  if (conditions.controller.pace != 1.0) json["pace"] = conditions.controller.pace;
  if (part.notes.foreign_parts) json["foreign_parts"] = true;
  if (part.notes.by_failure_model) json["failure_rates"] = {{"name", part.failure_rates}, {"hash", part.rates_hash}};
  return json;
}

std::string decision_lines(const PhysicalNotes& notes) {
  std::string text;
  for (std::span<const ControllerTick> rest = notes.tape; !rest.empty();) {
    const std::size_t count = std::min(rest.size(), ticks_a_line);
    text += tape_line(rest.first(count));
    rest = rest.subspan(count);
  }
  if (!text.empty()) return text;
  Json list = Json::array();
  for (const Action& action : notes.actions) list.push_back(decision_json(action));
  return record_line({{"actions", std::move(list)}});
}

std::string physical_lines(const PhysicalNotes& notes) {
  std::string text;
  for (const Look& look : notes.looks)
    text += record_line({{"look", pose_json(look.pose)},
                         {"evidence", {look.evidence.left, look.evidence.ahead, look.evidence.right}},
                         {"time", look.time}});
  for (const WallTouch& touch : notes.touches)
    text += record_line({{"touch", body_json(touch.at)}, {"crash", touch.crash}, {"time", touch.time}});
  for (const TracePoint& point : notes.trace) {
    Json list = {point.time};
    for (Json& number : body_json(point.truth)) list.push_back(std::move(number));
    if (point.estimate)
      for (Json& number : body_json(*point.estimate)) list.push_back(std::move(number));
    for (const std::int16_t level : point.infrared) list.push_back(level);
    text += record_line({{"trace", std::move(list)}});
  }
  return text;
}

Json counts_json(const PhysicalNotes& notes) {
  return {{"carried", notes.carried},
          {"wrong_walls", notes.wrong_walls},
          {"contradictions", notes.contradictions},
          {"severity", notes.severity}};
}

std::string why_not_driven(const PhysicalConditions& conditions, MazeTime time_limit) {
  constexpr MazeTime second = 1'000'000, millisecond = 1000;
  // A replay keeps the points of the trace twice as numbers and twice as text: some 150 MB.
  constexpr MazeTime most_points = 500'000;
  const MazeTime points = conditions.trace_every > 0 ? time_limit / (conditions.trace_every * millisecond) : 0;
  if (points <= most_points) return "";
  return fmt::format(
      "a point of the trace each {} ms makes up to {} of them in {} s, and a record has at most {}; trace it each {} "
      "ms",
      conditions.trace_every, points, time_limit / second, most_points,
      (time_limit / millisecond + most_points - 1) / most_points);
}

void read_conditions(const ReadJson& json, PhysicalPart& part, JsonFields& outer) {
  JsonFields fields(json, "physical");
  part.edition = fields.whole("edition", 1, 1'000'000);
  read_settings(physical_rows, fields, part.conditions);
  part.conditions.handling = fields.long_whole("handling", 0, longest_time);
  part.conditions.trace_every = fields.whole("trace_every", 0, 1'000'000);
  part.notes.foreign_parts = fields.has("foreign_parts") && fields.flag("foreign_parts");
  part.notes.by_failure_model = fields.has("failure_rates");
  if (part.notes.by_failure_model) {
    JsonFields failure_rates(fields.value("failure_rates"), "failure_rates");
    part.failure_rates = failure_rates.text("name");
    part.rates_hash = failure_rates.text("hash");
    fields.reject(failure_rates.error());
  }
  // Earlier versions had fewer causes, and called them groups.
  const char* const causes_key = fields.has("causes") ? "causes" : "groups";
  if (!fields.has(causes_key) || !fields.has("corrections"))
    fields.reject("'physical' lacks its causes or corrections");
  if (fields.error().empty()) {
    JsonFields causes(json[causes_key], causes_key), corrections(json["corrections"], "corrections");
    for (std::size_t i = 0; i < error_causes; ++i)
      if (const std::string name(name_of(static_cast<ErrorCause>(i))); causes.has(name.c_str()))
        part.conditions.errors.causes[i] = causes.number(name.c_str(), 0.0, noise_row.setting.high);
    part.conditions.controller.corrections = {corrections.flag("sides"), corrections.flag("edges"),
                                              corrections.flag("front")};
    fields.reject(causes.error());
    fields.reject(corrections.error());
  }
  outer.reject(fields.error());
}

bool read_decision_line(const ReadJson& json, PhysicalNotes& notes, JsonFields& fields) {
  if (json.contains("tape"))
    read_tape(notes, fields);
  else if (json.contains("actions"))
    read_actions(notes, fields);
  else
    return false;
  return true;
}

RunEnd read_run_end(JsonFields& fields) {
  const std::string how = fields.text("how");
  for (const RunEnd end : all_run_ends)
    if (today_value(how) == name_of(end)) return end;
  fields.fail("has an end of a run that this version does not know");
  return RunEnd::done;
}

bool read_physical_line(const ReadJson& json, Size size, std::size_t sensors, PhysicalNotes& notes,
                        JsonFields& fields) {
  if (notes.looks.size() + notes.touches.size() + notes.trace.size() > most_lines)
    fields.fail(fmt::format("is one of more than {} lines", most_lines));
  else if (json.contains("look"))
    read_look(size, notes, fields);
  else if (json.contains("touch"))
    read_touch(notes, fields);
  else if (json.contains("trace"))
    read_trace(sensors, notes, fields);
  else
    return false;
  return true;
}

void read_counts(const ReadJson& json, PhysicalNotes& notes, JsonFields& outer) {
  JsonFields fields(json, "physical");
  notes.carried = fields.whole("carried", 0, 1'000'000);
  notes.wrong_walls = fields.whole("wrong_walls", 0, 1'000'000);
  notes.contradictions = fields.whole("contradictions", 0, 1'000'000'000);
  notes.severity = fields.number("severity", 0.0, 1e9);
  outer.reject(fields.error());
}

}  // namespace labmouse
