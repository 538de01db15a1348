#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/records/drive_record_fields.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/records/physical_lines.hpp"
#include "labmouse/lab/records/record_maze.hpp"
#include "labmouse/lab/records/record_parts.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_lines.hpp"

namespace labmouse {
namespace {

// Limits against hostile records that would take too much memory.
constexpr std::size_t most_runs = 1000, most_moves = 1'000'000, most_segments = 10'000;
constexpr int most_laps = 1000;

/// The record read so far, and the reader's state between lines.
class DriveRecordReading {
 public:
  std::string read_header(const ReadJson& json);
  std::string read_line(const ReadJson& json);
  bool may_break_off() const { return !file_.ended; }
  DriveRecordFile take() { return std::move(file_); }

 private:
  Size size() const { return file_.maze->size(); }
  std::size_t infrared_sensors() const {
    const auto& hardware = file_.model->robot.hardware;
    return hardware ? hardware->sensors.infrared.size() : 0;
  }
  std::vector<DriveRun>& runs() { return file_.record.runs; }

  void read_maze(const ReadJson& json, JsonFields& outer);
  std::string begin_run(const ReadJson& json);
  std::string end_run(const ReadJson& json);
  std::string read_move(const ReadJson& json);
  std::string read_segment(const ReadJson& json);
  std::string read_wall(const ReadJson& json);
  std::string read_end(const ReadJson& json);

  DriveRecordFile file_;
  bool running_ = false;
  std::size_t moves_ = 0;
};

/// Nothing where the key holds null, else what `read` returns.
template <class Read>
auto optional_of(JsonFields& fields, const char* key, Read read) -> std::optional<decltype(read())> {
  if (fields.value(key).is_null()) return std::nullopt;
  return read();
}

DeadEndCount read_dead_ends(const ReadJson& json, JsonFields& outer) {
  constexpr int most = max_side * max_side;
  JsonFields fields(json, "dead_ends");
  DeadEndCount count;
  count.seen = fields.whole("seen", 0, most);
  count.all = fields.whole("all", 0, most);
  count.steps = fields.whole("steps", 0, static_cast<int>(most_moves));
  count.fewest_steps = fields.whole("fewest_steps", 0, most);
  outer.reject(fields.error());
  return count;
}

DriveRunScore read_score(const ReadJson& json, JsonFields& fields) {
  const auto time = [&](const char* key) { return fields.long_whole(key, -longest_time, longest_time); };
  DriveRunScore score;
  score.run = static_cast<std::size_t>(fields.whole("run", 1, static_cast<int>(most_runs)) - 1);
  for (const auto& [key, part] :
       {std::pair("gate_to_gate", &score.gate_to_gate), std::pair("rest_to_centre", &score.rest_to_centre)})
    if (!json.is_object() || !json.contains(key) || !json[key].is_null()) *part = time(key);
  score.maze_time = time("maze_time");
  score.bonus = time("bonus");
  if (fields.has("penalty")) score.penalty = time("penalty");
  if (fields.has("lap")) score.lap = fields.whole("lap", 1, most_laps);
  score.value = time("value");
  return score;
}

void DriveRecordReading::read_maze(const ReadJson& json, JsonFields& outer) {
  JsonFields fields(json, "maze");
  file_.maze_name = fields.text("name");
  file_.maze = read_record_maze(fields);
  if (file_.maze && (size().width > max_drive_side || size().height > max_drive_side))
    fields.fail(fmt::format("is larger than {}x{}, the limit of the world in seconds", max_drive_side, max_drive_side));
  outer.reject(fields.error());
}

std::string DriveRecordReading::read_header(const ReadJson& json) {
  JsonFields fields(json, "");
  if (fields.text("labmouse") != "drive record") fields.fail("is not the header of a record in seconds");
  if (fields.whole("format", 0, 1'000'000) != 1)
    fields.fail("has a format other than 1, which this version cannot read");
  const std::string world = fields.text("world");
  if (world != "seconds" && world != "physical") fields.fail("has a world other than seconds and physical");
  if (fields.has("added_world")) file_.added_world = fields.text("added_world");
  file_.version = fields.text("version");
  for (const char* key : {"maze", "mouse", "robot", "rules", "seed"})
    if (!fields.has(key)) fields.reject(fmt::format("'{}' is missing", key));
  if (!fields.error().empty()) return fields.error();
  if (!json["seed"].is_number_unsigned()) return "'seed' is not a number from 0 to 2^64 - 1";
  file_.seed = json["seed"].get<std::uint64_t>();
  JsonFields mouse(json["mouse"], "mouse");
  file_.mouse = mouse.text("name");
  if (mouse.has("spec")) file_.spec = mouse.text("spec");
  fields.reject(mouse.error());
  const auto hash = parse_whole<std::uint64_t>(fields.text("tables"), 16);
  if (!hash) fields.reject("'tables' is not a hexadecimal number");
  file_.tables_hash = hash.value_or(0);
  read_drive_rules_json(json["rules"], file_.rules, fields);
  if (fields.error().empty()) read_maze(json["maze"], fields);
  if (fields.error().empty()) file_.model = std::make_shared<DriveModel>(read_robot_json(fields, json["robot"]));
  if (fields.error().empty() && fields.text("model") != model_name(file_.model->robot))
    fields.fail(fmt::format("has a model that is not that of its robot, '{}'", model_name(file_.model->robot)));
  if (fields.error().empty() && world == "physical") {
    file_.physical.emplace();
    if (!fields.has("physical")) fields.reject("'physical' is missing");
    if (fields.error().empty()) read_conditions(json["physical"], *file_.physical, fields);
    const std::string why = fields.error().empty() ? why_not_physical(*file_.model) : "";
    if (!why.empty()) fields.reject("'robot' cannot drive in the physical world: " + why);
    if (fields.error().empty()) fields.reject(why_not_driven(file_.physical->conditions, file_.rules.time_limit));
  }
  file_.ended = false;
  return fields.error();
}

std::string DriveRecordReading::begin_run(const ReadJson& json) {
  if (running_) return "the line begins a run before the previous one has ended";
  if (runs().size() >= most_runs) return fmt::format("the record has more than {} runs", most_runs);
  JsonFields fields(json, "");
  DriveRun run;
  const std::string kind(today_value(fields.text("run")));
  bool known = false;
  for (const auto each : {DriveRun::Kind::search, DriveRun::Kind::home, DriveRun::Kind::speed, DriveRun::Kind::laps})
    if (kind == name_of(each)) run.kind = each, known = true;
  if (!known) fields.fail("has a run that is not one of search, home, speed, laps");
  run.begin = run.end = fields.long_whole("begin", 0, longest_time);
  const auto time_of = [&](const char* key) {
    return optional_of(fields, key, [&] { return fields.whole(key, 0, no_time - 1); }).value_or(no_time);
  };
  run.known = time_of("known");
  run.possible = time_of("possible");
  run.open = walls_in(json, "open", size(), fields);
  run.closed = walls_in(json, "closed", size(), fields);
  run.touched = file_.physical && fields.has("touched") && fields.flag("touched");
  if (file_.physical && fields.has("pace")) run.pace = fields.number("pace", least_pace, 1.0);
  if (run.has_route()) run.route.time = 0;
  runs().push_back(std::move(run));
  running_ = true;
  return fields.error();
}

std::string DriveRecordReading::end_run(const ReadJson& json) {
  if (!running_) return "the line ends a run that was not begun";
  JsonFields fields(json, "");
  DriveRun& run = runs().back();
  run.end = fields.long_whole("end", 0, longest_time);
  const auto moment = [&](const char* key) {
    return optional_of(fields, key, [&] { return fields.long_whole(key, 0, longest_time); });
  };
  run.gate_out = moment("gate_out");
  run.gate_in = moment("gate_in");
  run.centre = moment("centre");
  if (run.kind == DriveRun::Kind::laps)
    for (const ReadJson& lap : fields.list("laps")) run.laps.push_back(fields.long_whole(lap, "laps", 0, longest_time));
  if (run.kind == DriveRun::Kind::search && fields.has("dead_ends"))
    run.dead_ends = read_dead_ends(json["dead_ends"], fields);
  if (file_.physical) file_.physical->notes.ends.push_back(read_run_end(fields));
  running_ = false;
  return fields.error();
}

std::string DriveRecordReading::read_move(const ReadJson& json) {
  if (!running_ || runs().back().has_route()) return "the line has a move outside a search or a way home";
  if (++moves_ > most_moves) return fmt::format("the record has more than {} moves", most_moves);
  JsonFields fields(json, "");
  SearchMove move;
  const ReadJson& action = fields.list("move");
  if (action.size() != 2) return "the line has a move that is not [rotation, cells]";
  move.action =
      Action::step(fields.whole(action[0], "move", -180, 180), fields.whole(action[1], "move", 0, max_drive_side));
  move.from = pose_in(fields, "from", size());
  move.to = pose_in(fields, "to", size());
  move.begin = fields.long_whole("begin", 0, longest_time);
  move.end = fields.long_whole("until", 0, longest_time);
  move.replanned = fields.flag("replanned");
  runs().back().moves.push_back(move);
  return fields.error();
}

std::string DriveRecordReading::read_segment(const ReadJson& json) {
  if (!running_ || !runs().back().has_route()) return "the line has a segment outside a speed run or a run of laps";
  DriveRoute& route = runs().back().route;
  if (route.segments.size() >= most_segments) return fmt::format("the run has more than {} segments", most_segments);
  JsonFields fields(json, "");
  DriveSegment segment;
  segment.from = node_in(fields, "from", size());
  segment.to = node_in(fields, "to", size());
  segment.begin = fields.whole("begin", 0, no_time - 1);
  segment.end = fields.whole("until", 0, no_time - 1);
  read_piece(json, fields, file_.model->tables, segment);
  route.segments.push_back(segment);
  route.time = segment.end;
  return fields.error();
}

std::string DriveRecordReading::read_wall(const ReadJson& json) {
  if (running_) return "the line has a wall inside a run; walls come after all runs";
  // A log-odds map can turn a wall over again and again.
  constexpr std::size_t turns_of_a_wall = 100;
  if (file_.record.walls.size() >= turns_of_a_wall * static_cast<std::size_t>(size().area()))
    return "the record has more changes of walls than any map of the maze makes";
  JsonFields fields(json, "");
  const Pose side = pose_in(fields, "wall", size());
  WallSeen seen;
  seen.wall = wall_at(side.cell, side.heading);
  if (side.heading != seen.wall.side || on_border(seen.wall, size()))
    fields.fail("has a wall that is not an inner wall named as the north or east side of a cell");
  seen.open = fields.flag("open");
  seen.time = fields.long_whole("time", 0, longest_time);
  file_.record.walls.push_back(seen);
  return fields.error();
}

std::string DriveRecordReading::read_end(const ReadJson& json) {
  if (running_) return "the line ends the record before the last run has ended";
  JsonFields fields(json, "");
  DriveRecord& record = file_.record;
  const std::string name(today_value(fields.text("outcome")));
  bool known = false;
  for (const auto each : {DriveOutcome::finished, DriveOutcome::out_of_time, DriveOutcome::forfeit})
    if (name == name_of(each)) record.outcome = each, known = true;
  if (!known) return fmt::format("'outcome' is '{}', which this version does not know", name);
  if (record.outcome == DriveOutcome::forfeit) {
    const auto reason = forfeit_reason_of(fields.text("reason"));
    if (!reason) fields.fail("has a reason that this version does not know");
    record.reason = reason.value_or(ForfeitReason::none);
  }
  record.decisions = fields.whole("decisions", 0, 1'000'000'000);
  record.replanned = fields.whole("replanned", 0, 1'000'000'000);
  if (!fields.has("score")) fields.reject("'score' is missing");
  if (!fields.error().empty()) return fields.error();
  if (!json["score"].is_null()) {
    JsonFields score(json["score"], "score");
    file_.recorded_score = read_score(json["score"], score);
    fields.reject(score.error());
  }
  if (file_.physical) {
    if (!fields.has("physical")) return "'physical' is missing";
    read_counts(json["physical"], file_.physical->notes, fields);
  }
  file_.ended = true;
  return fields.error();
}

std::string DriveRecordReading::read_line(const ReadJson& json) {
  if (file_.ended) return "the line comes after the end of the record";
  if (!json.is_object()) return "the line is not an object";
  if (json.contains("labmouse")) return "the line is a second header; a file must hold only one record";
  if (json.contains("run")) return begin_run(json);
  if (json.contains("move")) return read_move(json);
  if (json.contains("piece")) return read_segment(json);
  if (json.contains("wall")) return read_wall(json);
  if (json.contains("outcome")) return read_end(json);
  if (json.contains("end")) return end_run(json);
  if (file_.physical) {
    JsonFields fields(json, "");
    if (read_decision_line(json, file_.physical->notes, fields)) return fields.error();
    if (read_physical_line(json, size(), infrared_sensors(), file_.physical->notes, fields)) return fields.error();
  }
  return "the line does not belong to a record in seconds: it has no run, move, piece, end, wall or outcome";
}

}  // namespace

ReadDriveRecordResult read_drive_record(std::string_view text) {
  DriveRecordReading reading;
  std::vector<Problem> problems = read_json_lines(
      text, {[&](const ReadJson& line) { return reading.read_header(line); },
             [&](const ReadJson& line) { return reading.read_line(line); }, [&] { return reading.may_break_off(); }});
  if (!problems.empty()) return {std::nullopt, std::move(problems)};
  return {reading.take(), {}};
}

}  // namespace labmouse
