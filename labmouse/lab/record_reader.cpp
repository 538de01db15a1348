#include <fmt/format.h>

#include "labmouse/lab/record_fields.hpp"
#include "labmouse/lab/record_file.hpp"
#include "labmouse/lab/record_reasons.hpp"
#include "labmouse/mouse/motion.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::json;
using Fields = RecordFields;

// Limits on what a hostile file can make us hold.
constexpr int longest_record = 1'000'000;  // steps
constexpr std::size_t most_counts = 64;
constexpr std::size_t longest_count_name = 64;
constexpr std::int64_t largest_count = std::int64_t{1} << 53U;  // what every JSON reader keeps exactly

/// Reads the maze of a header; on failure the fields hold the error.
std::optional<Maze> read_record_maze(Fields& fields) {
  std::string drawing;
  for (const Json& row : fields.list("drawing")) {
    if (!row.is_string()) return fields.fail("has a drawing with a line that is no text"), std::nullopt;
    drawing += row.get<std::string>() + "\n";
  }
  const ReadResult read = drawing_format.read(drawing);
  if (!read.maze) {
    const Problem& first = read.problems.front();
    return fields.fail(fmt::format("has a bad drawing, row {}, column {}: {}", first.line, first.column, first.reason)), std::nullopt;
  }
  const Cell start = fields.cell("start");
  const Heading heading = fields.heading("heading");
  CellSet goals;
  for (const Json& goal : fields.list("goals")) goals.insert(fields.cell(goal, "goals"));
  CellSet outside = goals;
  outside -= CellSet::all(read.maze->size());
  if (goals.empty() || !outside.empty() || !read.maze->size().contains(start))
    fields.fail("has a start or goals outside of the maze, or no goal");
  if (!fields.error().empty()) return std::nullopt;
  return read.maze->with_goals(goals).with_start(start, heading);
}

/// Reads the header into the file; returns what is wrong, or nothing.
std::string read_header(const Json& json, RecordFile& file) {
  Fields fields(json, "");
  if (fields.text("labmouse") != "record") fields.fail("is not the header of a record");
  if (fields.whole("format", 0, 1'000'000) != 1) fields.fail("has a format other than 1, which this version does not know");
  if (!fields.error().empty()) return fields.error();
  if (fields.has("version")) file.version = fields.text("version");
  if (fields.has("seed") && !json["seed"].is_number_unsigned()) return "'seed' is not a number from 0 to 2^64 - 1";
  if (fields.has("seed")) file.seed = json["seed"].get<std::uint64_t>();
  if (fields.has("rules")) {
    Fields rules(json["rules"], "rules");
    file.rules.budget = rules.whole("budget", 1, longest_record);
    file.rules.exploration_factor = rules.whole("exploration_factor", 1, longest_record);
    file.rules.stride = rules.whole("stride", 1, Motion::max_longest);
    if (!rules.error().empty()) return rules.error();
  }
  if (!fields.has("maze")) return "'maze' is missing";
  if (!fields.has("mouse")) return "'mouse' is missing";
  Fields mouse(json["mouse"], "mouse"), maze(json["maze"], "maze");
  file.mouse = mouse.text("name");
  file.maze_name = maze.text("name");
  file.maze = read_record_maze(maze);
  return !mouse.error().empty() ? mouse.error() : maze.error();
}

Action read_action(const Json& json, Fields& fields) {
  constexpr int far = 1'000'000;  // wrong rotations and movements are part of a record, within reason
  if (json.is_array() && json.size() == 2)
    return Action::step(fields.whole(json[0], "action", -far, far), fields.whole(json[1], "action", -far, far));
  if (json == "reset") return Action::reset();
  for (const ForfeitReason reason : all_forfeit_reasons)
    if (json == "forfeit: " + std::string(name_of(reason))) return Action::forfeit(reason);
  return fields.fail("has an action that is neither [rotation, movement] nor reset nor forfeit"), Action();
}

Run read_run(Fields& fields) {
  const std::string run = fields.text("run");
  if (run != "exploration" && run != "speed") fields.fail("has a run that is neither exploration nor speed");
  return run == "speed" ? Run::speed : Run::exploration;
}

std::string read_step(const Json& json, RecordFile& file) {
  Fields fields(json, "");
  StepRecord step;
  step.run = read_run(fields);
  step.step = fields.whole("step", 1, longest_record);
  step.pose = {fields.cell("cell"), fields.heading("heading")};
  const Json& reading = fields.list("reading");
  if (reading.size() != 3) fields.fail("has a reading that is not [left, ahead, right]");
  if (!fields.error().empty()) return fields.error();
  step.sighting = {fields.whole(reading[0], "reading", 0, max_side), fields.whole(reading[1], "reading", 0, max_side),
                   fields.whole(reading[2], "reading", 0, max_side)};
  step.action = fields.has("action") ? read_action(json["action"], fields) : (fields.fail("has no action"), Action());
  step.blocked = fields.flag("blocked");
  if (step.step != static_cast<int>(file.run.steps.size()) + 1)
    fields.fail(fmt::format("has step {} where step {} is due", step.step, file.run.steps.size() + 1));
  file.run.steps.push_back(step);
  if (!fields.has("reasons") || !fields.error().empty()) return fields.error();
  return read_reasons(json["reasons"], file.maze->size(), file.run.reasons.emplace_back(StepReasons{step.step, {}}).reasons);
}

bool is_count(const Json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>() <= static_cast<std::uint64_t>(largest_count);
  return value.is_number_integer() && value.get<std::int64_t>() >= -largest_count;
}

/// Reads what the mouse counted; returns what is wrong, or nothing.
std::string read_counts(const Json& json, std::vector<Count>& counts) {
  if (!json.is_object()) return "'counts' is not an object";
  if (json.size() > most_counts) return fmt::format("'counts' has more than {} names", most_counts);
  for (const auto& [name, value] : json.items()) {
    if (name.empty() || name.size() > longest_count_name)
      return fmt::format("'counts' has a name that is not 1 to {} bytes long", longest_count_name);
    if (!is_count(value)) return "'counts' has a value that is not a whole number from -2^53 to 2^53";
    counts.push_back({name, value.get<std::int64_t>()});
  }
  return "";
}

std::string read_end(const Json& json, RecordFile& file) {
  Fields fields(json, "");
  if (fields.has("counts"))
    if (auto error = read_counts(json["counts"], file.run.counts); !error.empty()) return error;
  const std::string name = fields.text("outcome");
  file.run.end = {fields.cell("cell"), fields.heading("heading")};
  const bool gave_up = !file.run.steps.empty() && file.run.steps.back().action.kind == Action::Kind::forfeit;
  if (gave_up != (name == name_of(Outcome::forfeit))) fields.fail("and the last step disagree on a forfeit");
  for (const Outcome outcome : {Outcome::solved, Outcome::out_of_steps, Outcome::never_reset,
                                Outcome::speed_run_unfinished, Outcome::forfeit})
    if (name_of(outcome) == name) {
      file.run.outcome = outcome;
      file.ended = true;
      return fields.error();
    }
  return fmt::format("'outcome' is '{}', which this version does not know", name);
}

/// Reads one line after the header; returns what is wrong, or nothing.
std::string read_line(const Json& json, RecordFile& file) {
  if (file.ended) return "the line stands behind the end of the record";
  return json.is_object() && json.contains("outcome") ? read_end(json, file) : read_step(json, file);
}

}  // namespace

ReadRecordResult read_record(std::string_view text) {
  RecordFile file;
  file.ended = false;
  const auto failed = [](int line, std::string reason) {
    return ReadRecordResult{std::nullopt, {{line, line > 0 ? 1 : 0, std::move(reason)}}};
  };
  int number = 0;
  while (!text.empty()) {
    const auto end = text.find('\n');
    const auto line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded()) return failed(number, "the line is not JSON");
    if (auto error = file.maze ? read_line(json, file) : read_header(json, file); !error.empty())
      return failed(number, std::move(error));
  }
  if (!file.maze) return failed(0, "the record is empty");
  return {std::move(file), {}};
}

}  // namespace labmouse
