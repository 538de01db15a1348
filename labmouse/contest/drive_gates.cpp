#include "labmouse/contest/drive_gates.hpp"

#include <cmath>

#include "labmouse/mouse/robot/drive_profile.hpp"

namespace labmouse {
namespace {

/// The first moment of a route, in microseconds, at which arrived(Cell) holds of the cell that the mouse's middle is
/// in.
template <class Arrived>
MazeTime first_moment(const DriveModel& model, const DriveRoute& route, Arrived arrived) {
  constexpr int steps_a_cell = 64, halvings = 40;
  const double cell = model.tables.cell;
  for (std::size_t i = 0; i < route.segments.size(); ++i) {
    const DriveProfile profile(model, route, i);
    const auto arrived_at = [&](double distance) {
      const DriveSpot spot = profile.spot(distance);
      return arrived(Cell{static_cast<int>(std::floor(spot.x / cell)), static_cast<int>(std::floor(spot.y / cell))});
    };
    const int steps = static_cast<int>(profile.length() / cell * steps_a_cell) + 1;
    for (int step = 1; step <= steps; ++step) {
      double before = profile.length() * (step - 1) / steps, behind = profile.length() * step / steps;
      if (!arrived_at(behind)) continue;
      for (int halving = 0; halving < halvings; ++halving)
        (arrived_at((before + behind) / 2) ? behind : before) = (before + behind) / 2;
      return route.segments[i].begin + static_cast<MazeTime>(std::llround(profile.time_at(behind)));
    }
  }
  return route.time;
}

}  // namespace

void set_gates(DriveRun& run, const Maze& maze, const DriveModel& model) {
  run.centre = run.begin + run.route.time;
  run.gate_out = run.gate_in = run.begin;
  if (run.route.segments.empty()) return;
  run.gate_out = run.begin + first_moment(model, run.route, [&](Cell cell) { return cell != maze.start(); });
  run.gate_in = run.begin + first_moment(model, run.route, [&](Cell cell) { return maze.is_goal(cell); });
}

void note_gates(DriveRun& search, const Maze& maze, const SearchDrive& drive, const SearchPlace& from,
                const Action& step, MazeTime begin, MazeTime end) {
  const SearchPlace next = after_search(from, step);
  const bool turns = step.rotation % 180 != 0 && step.movement > 0;
  if (search.gate_in && !search.centre && !from.at_rest && !turns && maze.is_goal(from.pose.cell)) {
    const bool passes = step.rotation == 0 && step.movement > 0;
    search.centre = begin + (passes ? (end - begin) / 2 : drive.half_cell);
  }
  if (!search.gate_out && from.pose.cell == maze.start() && step.movement > 0) search.gate_out = end;
  if (!search.gate_in && maze.is_goal(next.pose.cell) && search.gate_out) search.gate_in = end;
}

void note_stop(DriveRun& search, const Maze& maze, const SearchDrive& drive, const SearchPlace& place, MazeTime time) {
  if (search.gate_in && !search.centre && !place.at_rest && maze.is_goal(place.pose.cell))
    search.centre = time + drive.half_cell;
}

}  // namespace labmouse
