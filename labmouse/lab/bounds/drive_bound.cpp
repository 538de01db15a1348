#include "labmouse/lab/bounds/drive_bound.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "labmouse/contest/drive_gates.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/lap_route.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/drive/search_field.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"

namespace labmouse {
namespace {

SearchPlace start_of(const Maze& maze) { return {{maze.start(), maze.start_heading()}, true}; }

void keep_least(std::optional<MazeTime>& least, MazeTime time) { least = std::min(least.value_or(time), time); }

/// The score of a speed run after a search run, without bonus; nullopt where the rules do not allow it.
std::optional<MazeTime> fast_score(const DriveRun& run, const DriveRules& rules) {
  const MazeTime end = rules.gate_to_gate ? *run.gate_in : *run.centre;
  if (rules.most_runs < 2 || run.begin >= rules.time_limit || end > rules.time_limit) return std::nullopt;
  return end - (rules.gate_to_gate ? *run.gate_out : run.begin) + maze_time_part(run.begin, rules);
}

/// The least time to a goal and back, by Dijkstra's algorithm (1959). A node of the graph is a cell, the heading in
/// which the robot enters it, and whether a goal was entered.
class SearchHome {
 public:
  SearchHome(const Maze& maze, const SearchDrive& search)
      : maze_(maze), search_(search), times_(static_cast<std::size_t>(8 * maze.size().area()), never) {
    reach_from(start_of(maze), 0, false);
    while (!waiting_.empty()) {
      const auto [time, spot] = waiting_.top();
      waiting_.pop();
      if (time != times_[spot]) continue;
      const SearchPlace place = {{maze.size().cell_at(static_cast<int>(spot / 8)), static_cast<Heading>(spot / 2 % 4)},
                                 false};
      const bool on_the_way_home = spot % 2 != 0;
      if (on_the_way_home && place.pose.cell == maze.start()) stop(place, time);
      reach_from(place, time, on_the_way_home);
    }
  }

  std::optional<MazeTime> least() const { return least_; }

 private:
  static constexpr MazeTime never = MazeTime{1} << 60U;

  /// Ends the way home in the middle of the start cell, in the start's heading.
  void stop(const SearchPlace& place, MazeTime time) {
    keep_least(least_, time + search_time(search_, place, search_step(place.pose.heading, maze_.start_heading(), 0)));
  }

  void reach_from(const SearchPlace& place, MazeTime time, bool on_the_way_home) {
    for (const Heading heading : all_headings) {
      if (!maze_.is_open(place.pose.cell, heading)) continue;
      const Action step = search_step(place.pose.heading, heading, 1);
      const Pose next = after_search(place, step).pose;
      reach(next, time + search_time(search_, place, step), on_the_way_home || maze_.is_goal(next.cell));
    }
    if (on_the_way_home && !place.at_rest && search_.dashes()) dash_from(place.pose, time);
  }

  /// On the way home the robot may dash (drive straight over known cells faster than it searches), because it
  /// reads no walls there.
  void dash_from(const Pose& edge, MazeTime time) {
    Pose next = edge;
    for (int cells = 1; maze_.is_open(next.cell, next.heading); ++cells) {
      next.cell = neighbour(next.cell, next.heading);
      reach(next, time + search_.dash(cells), true);
    }
  }

  void reach(const Pose& next, MazeTime time, bool home) {
    const std::size_t spot = 8 * static_cast<std::size_t>(maze_.size().index(next.cell)) +
                             2 * static_cast<std::size_t>(next.heading) + (home ? 1 : 0);
    if (time >= times_[spot]) return;
    times_[spot] = time;
    waiting_.emplace(time, spot);
  }

  const Maze& maze_;
  const SearchDrive& search_;
  std::vector<MazeTime> times_;  ///< by cell, heading, and whether a goal was entered
  using Entry = std::pair<MazeTime, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting_;
  std::optional<MazeTime> least_;
};

}  // namespace

std::optional<MazeTime> shortest_search_home(const Maze& maze, const SearchDrive& search) {
  if (maze.is_goal(maze.start())) return 0;
  return SearchHome(maze, search).least();
}

std::optional<MazeTime> shortest_search(const Maze& maze, const DriveRules& rules, const SearchDrive& search) {
  std::optional<MazeTime> least;
  SearchField to_goal(maze.size(), search);
  to_goal.fill(maze.open_walls(), {}, maze.goals());
  for (const Heading heading : all_headings) {
    if (!maze.is_open(maze.start(), heading)) continue;
    const SearchPlace start = start_of(maze);
    const Action step = search_step(start.pose.heading, heading, 1);
    const DriveTime rest = to_goal.from(after_search(start, step));
    if (rest >= no_time) continue;
    // With gate-to-gate timing the clock starts when the robot leaves the start cell, else when it starts to move.
    const MazeTime out = search_time(search, start, step), stop = std::min(search.cell / 2, search.half_cell);
    const MazeTime end = out + rest + (rules.gate_to_gate ? 0 : stop);
    if (end <= rules.time_limit) keep_least(least, end - (rules.gate_to_gate ? out : 0));
  }
  return least;
}

namespace {

DriveBound lap_bound_of(const Maze& maze, const DriveRules& rules, const DriveModel& model) {
  DriveRun run;
  run.kind = DriveRun::Kind::laps;
  run.route = lap_route(maze, model, rules.most_runs);
  set_gates(run, maze, model);
  DriveRecord record;
  record.runs.push_back(std::move(run));
  DriveBound bound;
  bound.score = score(record, rules).value();
  if (const auto lap = fastest_lap(record.runs.front(), rules.time_limit))
    bound.fastest = static_cast<DriveTime>(lap->time);
  return bound;
}

}  // namespace

DriveBound drive_bound_of(const Maze& maze, const DriveRules& rules, const DriveModel& model) {
  if (rules.counts == Counted::lap) return lap_bound_of(maze, rules, model);
  FastestRoutes routes(maze.size(), route_tables_of(model));
  routes.fill(maze.open_walls(), maze.goals());
  DriveRun run;
  routes.route_from(start_of(maze).pose, run.route);
  DriveBound bound;
  bound.score = shortest_search(maze, rules, model.search);
  if (rules.counts == Counted::dead_end) {
    if (bound.score) bound.score = 0;
    return bound;
  }
  if (run.route.time < no_time) {
    bound.fastest = run.route.time;
    run.begin = shortest_search_home(maze, model.search).value_or(0);
    set_gates(run, maze, model);
    if (const auto value = fast_score(run, rules)) keep_least(bound.score, *value);
  }
  if (bound.score) *bound.score -= rules.untouched_bonus;
  return bound;
}

}  // namespace labmouse
