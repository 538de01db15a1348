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

}  // namespace labmouse
