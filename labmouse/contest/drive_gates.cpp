#include "labmouse/contest/drive_gates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "labmouse/mouse/robot/drive_profile.hpp"

namespace labmouse {
namespace {

/// A lower bound of the distance from a point to a cell of side `side`, mm; 0 inside.
double distance_to(Cell cell, double side, const DriveSpot& spot) {
  const auto beyond = [side](double place, int from) {
    return std::max({from * side - place, place - (from + 1) * side, 0.0});
  };
  return std::max(beyond(spot.x, cell.x), beyond(spot.y, cell.y));
}

/// Shortest distance from a point in a cell to the outside, mm.
double distance_out_of(Cell cell, double side, const DriveSpot& spot) {
  return std::min(
      {spot.x - cell.x * side, (cell.x + 1) * side - spot.x, spot.y - cell.y * side, (cell.y + 1) * side - spot.y});
}

/// A moment of a route: its time in microseconds, and its segment.
struct Moment {
  MazeTime time = 0;
  std::size_t segment = 0;
};

/// The first moment of a route, from a segment on, at which arrived(Cell) is true for the cell of the mouse's centre;
/// the end of the route if there is none. left(DriveSpot) is a lower bound of the distance to go; steps within it are
/// skipped.
template <class Arrived, class Left>
Moment first_moment(const DriveModel& model, const DriveRoute& route, std::size_t from, Arrived arrived, Left left) {
  constexpr int steps_a_cell = 64, halvings = 40;
  // A margin for rounding: curves are numerical sums.
  constexpr double sure_part = 0.99;
  const double cell = model.tables.cell;
  for (std::size_t i = from; i < route.segments.size(); ++i) {
    const DriveProfile profile(model, route, i);
    const auto arrived_at = [&](const DriveSpot& spot) {
      return arrived(Cell{static_cast<int>(std::floor(spot.x / cell)), static_cast<int>(std::floor(spot.y / cell))});
    };
    const int steps = static_cast<int>(profile.length() / cell * steps_a_cell) + 1;
    const double stride = std::max(profile.length() / steps, 1e-9);
    const auto strides_over = [&](double distance) {
      return 1 + static_cast<int>(std::clamp(sure_part * distance / stride, 0.0, static_cast<double>(steps)));
    };
    const HalfPoint node = half_point(route.segments[i].from);
    const double to_node = std::fabs(profile.beginning());
    for (int step = strides_over(left({node.x * cell / 2, node.y * cell / 2, 0.0}) - to_node); step <= steps;) {
      double before = profile.length() * (step - 1) / steps, behind = profile.length() * step / steps;
      if (const DriveSpot spot = profile.spot(behind); !arrived_at(spot)) {
        step += strides_over(left(spot));
        continue;
      }
      for (int halving = 0; halving < halvings; ++halving)
        (arrived_at(profile.spot((before + behind) / 2)) ? behind : before) = (before + behind) / 2;
      return {route.segments[i].begin + static_cast<MazeTime>(std::llround(profile.time_at(behind))), i};
    }
  }
  return {route.time, route.segments.size()};
}

/// A lower bound of the distance from a point to the nearest of some cells, mm.
double distance_to(const CellSet& cells, double side, const DriveSpot& spot) {
  double least = std::numeric_limits<double>::infinity();
  cells.for_each([&](Cell cell) { least = std::min(least, distance_to(cell, side, spot)); });
  return least;
}

/// The first moment, from a segment on, at which the mouse leaves the start cell, where it is or comes to.
Moment leaves_start(const DriveRun& run, const Maze& maze, const DriveModel& model, std::size_t from) {
  const double side = model.tables.cell;
  const Cell start = maze.start();
  bool inside = from == 0;
  return first_moment(
      model, run.route, from,
      [&](Cell cell) {
        inside = inside || cell == start;
        return inside && cell != start;
      },
      [&](const DriveSpot& spot) {
        return inside ? distance_out_of(start, side, spot) : distance_to(start, side, spot);
      });
}

/// Sets the gates of a run of laps. Each segment passes the gate once at most.
void set_laps(DriveRun& run, const Maze& maze, const DriveModel& model) {
  for (std::size_t segment = 0; segment < run.route.segments.size();) {
    const Moment gate = leaves_start(run, maze, model, segment);
    segment = gate.segment + 1;
    if (gate.segment == run.route.segments.size()) return;
    if (run.gate_out)
      run.laps.push_back(run.begin + gate.time);
    else
      run.gate_out = run.begin + gate.time;
  }
}

}  // namespace

void set_gates(DriveRun& run, const Maze& maze, const DriveModel& model) {
  if (run.kind == DriveRun::Kind::laps) return set_laps(run, maze, model);
  run.centre = run.begin + run.route.time;
  run.gate_out = run.gate_in = run.begin;
  if (run.route.segments.empty()) return;
  const Cell start = maze.start();
  const CellSet& goals = maze.goals();
  const double side = model.tables.cell;
  const auto moment = [&](auto arrived, auto left) {
    return run.begin + first_moment(model, run.route, 0, arrived, left).time;
  };
  run.gate_out = moment([&](Cell cell) { return cell != start; },
                        [&](const DriveSpot& spot) { return distance_out_of(start, side, spot); });
  run.gate_in = moment([&](Cell cell) { return maze.is_goal(cell); },
                       [&](const DriveSpot& spot) { return distance_to(goals, side, spot); });
}

void note_gates(DriveRun& search, const Maze& maze, MazeTime half_cell, const SearchPlace& from, const Action& step,
                MazeTime begin, MazeTime end) {
  const SearchPlace next = after_search(from, step);
  const bool turns = step.rotation % 180 != 0 && step.movement > 0;
  if (search.gate_in && !search.centre && !from.at_rest && !turns && maze.is_goal(from.pose.cell)) {
    const bool passes = step.rotation == 0 && step.movement > 0;
    search.centre = begin + (passes ? (end - begin) / 2 : half_cell);
  }
  if (!search.gate_out && from.pose.cell == maze.start() && step.movement > 0) search.gate_out = end;
  if (!search.gate_in && maze.is_goal(next.pose.cell) && search.gate_out) search.gate_in = end;
}

void note_stop(DriveRun& search, const Maze& maze, MazeTime half_cell, const SearchPlace& place, MazeTime time) {
  if (search.gate_in && !search.centre && !place.at_rest && maze.is_goal(place.pose.cell))
    search.centre = time + half_cell;
}

}  // namespace labmouse
