
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/records/drive_notation.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/records/physical_lines.hpp"
#include "labmouse/lab/records/record_maze.hpp"
#include "labmouse/lab/records/settings_json.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

Json driver_json(const DriveRecordFile& file) {
  Json mouse = {{"name", file.mouse}, {"parameters", settings_json(file.settings)}};
  if (!file.spec.empty()) mouse["spec"] = file.spec;
  return mouse;
}

Json header_json(const DriveRecordFile& file) {
  const bool physical = file.physical.has_value();
  Json json = {{"labmouse", "drive record"},
               {"format", 1},
               {"version", version()},
               {"world", physical ? "physical" : "seconds"},
               {"maze", record_maze_json(file.maze_name, *file.maze)},
               {"mouse", driver_json(file)},
               {"seed", file.seed},
               {"robot", robot_json(file.model->robot, physical ? RobotParts::with_body : RobotParts::limits)},
               {"model", model_name(file.model->robot)},
               {"tables", hash_text(file.model->tables.hash)},
               {"rules", rules_json(file.rules)}};
  if (physical) json["physical"] = conditions_json(*file.physical);
  if (!file.added_world.empty()) json["added_world"] = file.added_world;
  return json;
}

Json cells_json(const CellSet& cells, int height) {
  Json rows = Json::array();
  for (int y = 0; y < height; ++y) rows.push_back(fmt::format("{:x}", cells.row(y)));
  return rows;
}

Json walls_json(const WallSet& walls, Size size) {
  return {{"north", cells_json(walls.north(), size.height)}, {"east", cells_json(walls.east(), size.height)}};
}

Json run_json(const DriveRun& run, Size size) {
  Json json = {{"run", name_of(run.kind)},           {"begin", run.begin},
               {"known", time_json(run.known)},      {"possible", time_json(run.possible)},
               {"open", walls_json(run.open, size)}, {"closed", walls_json(run.closed, size)}};
  if (run.touched) json["touched"] = true;
  if (run.pace != 1.0) json["pace"] = run.pace;
  return json;
}

Json run_end_json(const DriveRun& run) {
  Json json = {{"end", run.end},
               {"gate_out", or_null(run.gate_out)},
               {"gate_in", or_null(run.gate_in)},
               {"centre", or_null(run.centre)}};
  if (run.kind == DriveRun::Kind::laps) json["laps"] = run.laps;
  if (run.dead_ends) json["dead_ends"] = dead_ends_json(*run.dead_ends);
  return json;
}

Json move_json(const SearchMove& move) {
  return {{"move", {move.action.rotation, move.action.movement}},
          {"from", pose_json(move.from)},
          {"to", pose_json(move.to)},
          {"begin", move.begin},
          {"until", move.end},
          {"replanned", move.replanned}};
}

Json segment_json(const DriveSegment& segment, const DriveTables& tables) {
  Json json = {{"piece", notation_of(segment, tables)}};
  if (segment.kind == DriveSegment::Kind::turn) {
    const DrivenTurn& turn = tables.turns[segment.turn];
    json["speed"] = turn.speed;
    if (turn.end_speed != turn.speed) json["end_speed"] = turn.end_speed;
  }
  json["from"] = node_json(segment.from);
  json["to"] = node_json(segment.to);
  json["begin"] = segment.begin;
  json["until"] = segment.end;
  return json;
}

Json end_json(const DriveRecordFile& file) {
  const DriveRecord& record = file.record;
  Json json = {{"outcome", name_of(record.outcome)}};
  if (record.outcome == DriveOutcome::forfeit) json["reason"] = name_of(record.reason);
  json["decisions"] = record.decisions;
  json["replanned"] = record.replanned;
  json["score"] = score_json(score(record, file.rules));
  if (file.physical) json["physical"] = counts_json(file.physical->notes);
  return json;
}

}  // namespace

std::string world_of(const DriveRecordFile& file) {
  if (!file.added_world.empty()) return file.added_world;
  if (!file.physical) return "seconds";
  return file.physical->notes.by_failure_model ? "failures" : "physical";
}

std::string write_drive_record(const DriveRecordFile& file) {
  std::string text = record_line(header_json(file));
  if (file.physical) text += decision_lines(file.physical->notes);
  for (std::size_t i = 0; i < file.record.runs.size(); ++i) {
    const DriveRun& run = file.record.runs[i];
    text += record_line(run_json(run, file.maze->size()));
    for (const SearchMove& move : run.moves) text += record_line(move_json(move));
    for (const DriveSegment& segment : run.route.segments)
      text += record_line(segment_json(segment, file.model->tables));
    Json end = run_end_json(run);
    if (file.physical && i < file.physical->notes.ends.size()) end["how"] = name_of(file.physical->notes.ends[i]);
    text += record_line(end);
  }
  for (const WallSeen& seen : file.record.walls)
    text += record_line({{"wall", {seen.wall.cell.x, seen.wall.cell.y, name_of(seen.wall.side)}},
                         {"open", seen.open},
                         {"time", seen.time}});
  if (file.physical) text += physical_lines(file.physical->notes);
  return text + record_line(end_json(file));
}

}  // namespace labmouse
