#include "labmouse/lab/routes/route_report.hpp"

#include <fmt/format.h>

#include "labmouse/contest/drive_gates.hpp"
#include "labmouse/lab/routes/one_plan.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

using Tables = std::shared_ptr<const RouteTables>;

/// The tables of the robot with only some of its turns.
template <class Keep>
Tables with_turns(DriveTables tables, Keep keep) {
  std::erase_if(tables.turns, [&](const DrivenTurn& turn) { return !keep(turn.turn); });
  return std::make_shared<const RouteTables>(tables);
}

bool keeps_to_the_axes(Turn turn) { return !begins_diagonal(turn) && !ends_diagonal(turn); }
bool is_small(Turn turn) { return turn == Turn::s90; }

MazeTime gate_to_gate_of(const DriveRoute& route, const Maze& maze, const DriveModel& model) {
  DriveRun run;
  run.route = route;
  set_gates(run, maze, model);
  return *run.gate_in - *run.gate_out;
}

DistanceField cells_from(const Maze& maze, const CellSet& cells) {
  DistanceField field(maze.size(), strides(1));
  field.fill(maze.open_walls(), cells);
  return field;
}

/// Adds the open passages in a line through a goal, where a mouse may stop.
void add_open_lines(WallSet& passages, const Maze& maze, Cell goal) {
  for (const Heading heading : all_headings)
    for (Cell cell = goal; maze.open_walls().contains(wall_at(cell, heading)); cell = neighbour(cell, heading))
      passages.insert(wall_at(cell, heading));
}

/// The passages of all routes with the fewest cells, and the open ones in a line through the goals.
WallSet shortest_passages(const Maze& maze, const DistanceField& start, const DistanceField& goal) {
  const int fewest = goal.at(maze.start());
  WallSet passages;
  maze.open_walls().for_each([&](Wall wall) {
    const Cell here = wall.cell, there = neighbour(wall.cell, wall.side);
    if (start.at(here) + 1 + goal.at(there) == fewest || start.at(there) + 1 + goal.at(here) == fewest)
      passages.insert(wall);
  });
  maze.goals().for_each([&](Cell cell) { add_open_lines(passages, maze, cell); });
  return passages;
}

void add_fewest_cells(RouteReport& report, const Maze& maze, const Tables& tables) {
  const DistanceField from_start = cells_from(maze, CellSet::of(maze.start())),
                      to_goal = cells_from(maze, maze.goals());
  report.fewest_cells = to_goal.at(maze.start());
  const DriveRoute route = fastest_route(maze, shortest_passages(maze, from_start, to_goal), tables);
  if (route.time < no_time && walls_of(route).count() == report.fewest_cells) report.fewest_cells_time = route.time;
}

RouteReport without_route(std::string why) {
  RouteReport report;
  report.error = std::move(why);
  return report;
}

}  // namespace

std::optional<double> RouteReport::gain_over(DriveTime other) const {
  if (other >= no_time || other == 0) return std::nullopt;
  return 1.0 - static_cast<double>(route.time) / other;
}

RouteReporter::RouteReporter(const DriveModel& model)
    : model_(model),
      all_(route_tables_of(model)),
      without_diagonals_(with_turns(model.tables, keeps_to_the_axes)),
      small_turns_(with_turns(model.tables, is_small)) {}

RouteReport RouteReporter::report(const Maze& maze) const {
  const Size size = maze.size();
  if (size.width > max_drive_side || size.height > max_drive_side)
    return without_route(fmt::format("is {}x{}; the world in seconds takes mazes up to {}x{}", size.width, size.height,
                                     max_drive_side, max_drive_side));
  RouteReport report;
  report.route = fastest_route(maze, maze.open_walls(), all_);
  if (report.route.time >= no_time)
    return without_route(
        fmt::format("no route leads {} from the start ({},{}) to a goal, and a run cannot turn at the start",
                    name_of(maze.start_heading()), maze.start().x, maze.start().y));
  report.cells = walls_of(report.route).count();
  report.gate_to_gate = static_cast<DriveTime>(gate_to_gate_of(report.route, maze, model_));
  report.without_diagonals = fastest_route(maze, maze.open_walls(), without_diagonals_).time;
  report.small_turns = fastest_route(maze, maze.open_walls(), small_turns_).time;
  add_fewest_cells(report, maze, all_);
  return report;
}

}  // namespace labmouse
