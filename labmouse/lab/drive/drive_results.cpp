#include "labmouse/lab/drive/drive_results.hpp"

#include <fmt/format.h>

#include "labmouse/contest/dead_ends.hpp"
#include "labmouse/contest/lap_route.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

/// "1/30 of "
std::string share_of(int divisor) { return divisor == 1 ? "" : fmt::format("1/{} of ", divisor); }

}  // namespace

std::string outcome_of(const DriveRecord& record, const DriveScore& score) {
  const std::string outcome(name_of(score.outcome));
  return score.outcome == DriveOutcome::forfeit ? fmt::format("{}: {}", outcome, name_of(record.reason)) : outcome;
}

std::optional<MazeTime> best_of(const DriveScore& score) {
  std::optional<MazeTime> best;
  for (const DriveRunScore& run : score.runs)
    if (const auto& time = run.lap > 0 ? run.gate_to_gate : run.rest_to_centre; time && (!best || *time < *best))
      best = time;
  return best;
}

std::optional<double> excess_of(const std::optional<MazeTime>& best, const DriveBound& bound) {
  if (!best || !bound.fastest || *bound.fastest == 0) return std::nullopt;
  return static_cast<double>(*best) / *bound.fastest - 1.0;
}

MazeTime search_time_of(const DriveRecord& record) {
  MazeTime search = 0;
  for (const DriveRun& run : record.runs) {
    if (run.has_route()) return run.begin;
    search = run.end;
  }
  return search;
}

void add_score(MazeTime value, const DriveBound& bound, const DriveRules& rules, ContestResult& result) {
  result.score = result.counted = in_seconds(value);
  // The ratio is of scores without the bonus: less the bonus, the best possible score could be 0 or below.
  const MazeTime bonus = rules.untouched_bonus;
  if (const MazeTime best = bound.score.value_or(0) + bonus; bound.score && best > 0)
    result.ratio = static_cast<double>(value + bonus) / static_cast<double>(best);
}

namespace {

/// Why no laps are driven in a maze; empty where they are.
std::string refuse_laps_in(const Maze& maze, const DriveModel& model) {
  const Cell start = maze.start();
  if (!starts_on_ring(maze))
    return fmt::format(
        "starts at ({},{}) heading {}; a time trial starts in a corner of at least 2x2 cells, heading clockwise round "
        "the outermost ring: choose another maze or other --rules",
        start.x, start.y, name_of(maze.start_heading()));
  if (const auto wall = closed_on_ring(maze))
    return fmt::format(
        "has a closed wall {} of ({},{}); the course of a time trial is the outermost ring, open all round: choose "
        "another maze or other --rules",
        name_of(wall->side), wall->cell.x, wall->cell.y);
  if (lap_route(maze, model, 1).time < no_time) return "";
  return fmt::format("is too small for the turns of the robot {}: no lap of the outermost ring can be driven",
                     shown(model.robot.name));
}

/// Why dead ends are not counted in a maze; empty where they are.
std::string refuse_dead_ends_in(const Maze& maze) {
  return dead_ends_in(maze).empty() ? "has no dead ends besides start and goal, and the rules count those: choose "
                                      "another maze or other --rules"
                                    : "";
}

}  // namespace

std::string refuse_to_drive_in(const Maze& maze, const DriveRules& rules, const DriveModel& model) {
  const Size size = maze.size();
  if (size.width <= max_drive_side && size.height <= max_drive_side)
    return rules.counts == Counted::lap        ? refuse_laps_in(maze, model)
           : rules.counts == Counted::dead_end ? refuse_dead_ends_in(maze)
                                               : "";
  return fmt::format("is {}x{}; the world in seconds takes mazes up to {}x{}", size.width, size.height, max_drive_side,
                     max_drive_side);
}

std::shared_ptr<const DriveModel> sharing_tables(std::shared_ptr<const DriveModel> model) {
  if (model->route_tables) return model;
  auto sharing = std::make_shared<DriveModel>(*model);
  share_route_tables(*sharing);
  return sharing;
}

std::optional<double> mean_bound(const Race& race) {
  std::vector<double> bounds;
  for (const MazeFacts& facts : race.facts)
    if (facts.bound) bounds.push_back(*facts.bound);
  return mean_if_any(bounds);
}

std::string formula_of(const DriveRules& rules) {
  if (rules.counts == Counted::dead_end)
    return fmt::format(
        "what a search loses of {0} marks: {0} * dead ends seen / all * cells of the shortest way / steps to the goal, "
        "in {1:g} s; the best of at most {2}",
        rules.marks, in_seconds(rules.time_limit), counted(rules.most_runs, "run", "runs"));
  const bool laps = rules.counts == Counted::lap;
  std::string text = fmt::format("the best of at most {} in {:g} s, {}",
                                 counted(rules.most_runs, laps ? "lap" : "run", laps ? "laps" : "runs"),
                                 in_seconds(rules.time_limit), rules.gate_to_gate ? "gate to gate" : "rest to centre");
  if (rules.maze_time_divisor > 0)
    text += fmt::format(", plus {}the time in the maze before it", share_of(rules.maze_time_divisor));
  if (rules.untouched_bonus > 0) text += fmt::format(", minus {:g} s if untouched", in_seconds(rules.untouched_bonus));
  if (rules.touch_penalty > 0) text += fmt::format(", plus {:g} s if touched", in_seconds(rules.touch_penalty));
  return text;
}

}  // namespace labmouse
