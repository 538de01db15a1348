#include "labmouse/lab/replays/play_seconds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "labmouse/contest/drive_gates.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/lap_route.hpp"
#include "labmouse/lab/bounds/drive_bound.hpp"
#include "labmouse/lab/pictures/trace_path.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/replays/bodies.hpp"
#include "labmouse/lab/replays/crash.hpp"
#include "labmouse/lab/replays/drive_frames.hpp"
#include "labmouse/lab/replays/fields.hpp"
#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

Json seconds_json(const std::optional<MazeTime>& time) {
  return time ? Json(static_cast<double>(*time) / 1e6) : Json(nullptr);
}

Json seconds_json(DriveTime time) { return time < no_time ? Json(time / 1e6) : Json(nullptr); }

std::string outcome_words(const DriveRecord& record) {
  std::string words(name_of(record.outcome));
  if (record.outcome == DriveOutcome::forfeit) words += fmt::format(": {}", name_of(record.reason));
  return words;
}

/// All laps that the rules allow, without errors.
DriveRun best_laps(const DriveRecordFile& contest) {
  DriveRun run;
  run.kind = DriveRun::Kind::laps;
  run.route = lap_route(*contest.maze, *contest.model, contest.rules.most_runs);
  run.end = run.route.time;
  set_gates(run, *contest.maze, *contest.model);
  return run;
}

/// The fastest run that the maze allows, made at once; where laps count, the fastest laps.
DriveRun best_run(const DriveRecordFile& contest) {
  const Maze& maze = *contest.maze;
  if (contest.rules.counts == Counted::lap) return best_laps(contest);
  FastestRoutes routes(maze.size(), route_tables_of(*contest.model));
  routes.fill(maze.open_walls(), maze.goals());
  DriveRun run;
  run.kind = DriveRun::Kind::speed;
  routes.route_from({maze.start(), maze.start_heading()}, run.route);
  if (run.route.time == no_time) return run;
  run.end = run.route.time;
  set_gates(run, maze, *contest.model);
  return run;
}

/// The points of a path as lists: one for each quantity, with a number for each point.
class PathLists {
 public:
  void add(const std::vector<DrivePathPoint>& points) {
    for (const DrivePathPoint& point : points) {
      t_.push_back(std::llround(point.time));
      x_.push_back(rounded(point.x, 1e4));
      y_.push_back(rounded(point.y, 1e4));
      heading_.push_back(rounded(point.heading, 1e3));
      v_.push_back(std::llround(point.speed));
      a_.push_back(std::llround(point.acceleration));
    }
  }
  std::size_t size() const { return t_.size(); }
  Json json() const { return {{"t", t_}, {"x", x_}, {"y", y_}, {"heading", heading_}, {"v", v_}, {"a", a_}}; }

 private:
  static double rounded(double value, double parts) { return std::round(value * parts) / parts; }

  std::vector<std::int64_t> t_, v_, a_;
  std::vector<double> x_, y_, heading_;
};

Json score_json(const DriveScore& scores, std::size_t run) {
  for (std::size_t i = 0; i < scores.runs.size(); ++i) {
    const DriveRunScore& score = scores.runs[i];
    if (score.run != run) continue;
    return {{"gate_to_gate", or_null(score.gate_to_gate)},
            {"rest_to_centre", or_null(score.rest_to_centre)},
            {"maze_time", score.maze_time},
            {"bonus", score.bonus},
            {"value", score.value},
            {"best", scores.best == i}};
  }
  return nullptr;
}

Json run_json(const DriveRun& run) {
  Json json = {{"kind", name_of(run.kind)},
               {"begin", run.begin},
               {"end", run.end},
               {"gate_out", or_null(run.gate_out)},
               {"gate_in", or_null(run.gate_in)},
               {"centre", or_null(run.centre)},
               {"known", time_json(run.known)},
               {"possible", time_json(run.possible)}};
  if (run.kind == DriveRun::Kind::laps) json["laps"] = run.laps;
  if (run.dead_ends) json["dead_ends"] = dead_ends_json(*run.dead_ends);
  return json;
}

Json robot_json(const Robot& robot, const DriveTables& tables) {
  return {{"name", robot.name}, {"cell", robot.cell}, {"hash", hash_text(tables.hash)}};
}

Json crash_json(const std::optional<DrivePathPoint>& crash) {
  if (!crash) return nullptr;
  const Cell cell = cell_of(*crash);
  return {{"time", crash->time}, {"cell", {cell.x, cell.y}}};
}

/// The path of a run up to its crash, where it has one.
std::vector<DrivePathPoint> driven_path(const DriveRecordFile& contest, std::size_t run, DrivePath& path,
                                        const std::optional<DrivePathPoint>& crash) {
  if (has_trace(contest)) return true_path(contest, run);
  const DriveRun& driven = contest.record.runs[run];
  std::vector<DrivePathPoint> points = path.follow(driven, pace_of(contest, driven));
  if (!crash || points.empty() || points.back().time >= crash->time) return points;
  DrivePathPoint& last = points.back();
  last.acceleration = (crash->speed - last.speed) / ((crash->time - last.time) / 1e6);
  points.push_back(*crash);
  // The headings of the last two points must not differ by whole turns.
  points.back().heading += 8.0 * std::round((points[points.size() - 2].heading - crash->heading) / 8.0);
  return points;
}

Json drive_json(const DriveRecordFile& contest, const DriveRun& best, const std::vector<DriveRunFrames>& frames) {
  const DriveScore scores = score(contest.record, contest.rules);
  DrivePath path({contest.maze->start(), contest.maze->start_heading()}, *contest.model);
  PathLists lists, best_lists;
  Json runs = Json::array();
  for (std::size_t i = 0; i < contest.record.runs.size(); ++i) {
    const DriveRun& driven = contest.record.runs[i];
    Json run = run_json(driven);
    const bool told = contest.physical && i < contest.physical->notes.ends.size();
    run["ended"] = told ? Json(name_of(contest.physical->notes.ends[i])) : Json(nullptr);
    run["crash"] = crash_json(frames[i].crash);
    run["frame"] = frames[i].first;
    run["from"] = lists.size();
    lists.add(driven_path(contest, i, path, frames[i].crash));
    run["to"] = lists.size();
    run["score"] = score_json(scores, i);
    runs.push_back(std::move(run));
  }
  best_lists.add(path_of(best.route, 0, *contest.model));
  Json drive = {{"robot", robot_json(contest.model->robot, contest.model->tables)},
                {"rules", rules_json(contest.rules)},
                {"decisions", contest.record.decisions},
                {"replanned", contest.record.replanned},
                {"runs", std::move(runs)},
                {"path", lists.json()},
                {"best", best_lists.json()}};
  if (has_trace(contest)) drive["bodies"] = bodies_json(contest);
  return drive;
}

/// What the page says of all contests in seconds, by what counts.
Json traits_of(const DriveRules& rules) {
  PlayTraits traits = {.in_steps = false,
                       .unit = unit_of(rules.counts),
                       .bound = "the best possible score: that of the fastest run, made at once",
                       .runs = {"search", "way home", "speed run"}};
  if (rules.counts == Counted::lap) {
    traits.bound = "the best possible score: the fastest lap without errors";
    traits.runs.emplace_back("laps");
  }
  if (rules.counts == Counted::dead_end) traits.bound = "no marks lost";
  return traits_json(traits);
}

Json header_json(const DriveRecordFile& contest, const DriveRun& best) {
  const auto value = score(contest.record, contest.rules).value();
  const DriveBound bound = drive_bound_of(*contest.maze, contest.rules, *contest.model);
  const bool laps = contest.rules.counts == Counted::lap;
  const DriveTime optimum = laps ? bound.fastest.value_or(no_time) : best.route.time;
  return {{"world", world_of(contest)},
          {"traits", traits_of(contest.rules)},
          {"mouse", contest.mouse},
          {"maze", maze_data(contest.maze_name, *contest.maze)},
          {"rules", nullptr},
          {"seed", contest.seed},
          {"outcome", outcome_words(contest.record)},
          {"finished", value.has_value()},
          {"score", seconds_json(value)},
          {"bound", seconds_json(bound.score)},
          {"optimum", seconds_json(optimum)},
          {"search_steps", 0},
          {"speed_steps", 0},
          {"discovered", nullptr},
          {"visited", nullptr},
          {"last_words", ""},
          {"counts", Json::array()},
          {"checked", ""},
          {"ended", contest.ended}};
}

/// The share of the reachable cells that the mouse entered.
double share_visited(const DriveRecordFile& contest, const Json& play, const Json& distances) {
  std::set<int> cells = {contest.maze->size().index(contest.maze->start())};
  for (const Json& entered : play["entered"])
    for (const Json& cell : entered) cells.insert(cell.get<int>());
  const auto reachable =
      std::count_if(distances.begin(), distances.end(), [](const Json& d) { return d.get<int>() >= 0; });
  return reachable > 0 ? static_cast<double>(cells.size()) / static_cast<double>(reachable) : 0.0;
}

}  // namespace

Json path_json(const std::vector<DrivePathPoint>& points) {
  PathLists lists;
  lists.add(points);
  return lists.json();
}

Json play_json(const DriveRecordFile& contest) {
  const DriveRun best = best_run(contest);
  Json play = header_json(contest, best);
  const std::vector<DriveRunFrames> frames = add_drive_frames(contest, play);
  play["route"] = Json::array();
  play["distances"] = distances_json(*contest.maze, 1);
  play["visited"] = share_visited(contest, play, play["distances"]);
  play["reasons"] = Json::array();
  play["loses"] = Json::array();
  play["events"] = Json::array();
  play["drive"] = drive_json(contest, best, frames);
  return play;
}

}  // namespace labmouse
