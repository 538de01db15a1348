#include "labmouse/contest/timed_driver.hpp"

#include <algorithm>

#include "labmouse/contest/drive_gates.hpp"

namespace labmouse {

MazeTime TimedDriver::time_of(const Action& part) const {
  return slowed(part.movement > 1 ? model_.search.dash(part.movement) : search_time(model_.search, place_, part));
}

/// If a search ended at the edge of a goal, the first move home gives the time at the goal's middle.
void TimedDriver::advance(const Action& part, MazeTime begin, bool replanned) {
  auto& runs = record_.runs;
  DriveRun& run = runs.back();
  const Pose from = place_.pose;
  const MazeTime half_cell = slowed(model_.search.half_cell), end = begin + time_of(part);
  const bool home = run.kind == DriveRun::Kind::home;
  if (home && runs.size() > 1 && run.moves.empty()) note_stop(runs[runs.size() - 2], maze_, half_cell, place_, begin);
  const Action step = part.movement > 1 ? Action::step(0, 1) : part;
  MazeTime passed = begin;
  for (int edge = 1; edge <= std::max(1, part.movement); ++edge) {
    const bool last = edge >= part.movement;
    clock_ = last ? end : begin + slowed(model_.search.dash_part(part.movement, edge));
    if (!home) note_gates(run, maze_, half_cell, place_, step, passed, clock_);
    passed = clock_;
    place_ = after_search(place_, step);
    arrive();
  }
  run.moves.push_back({begin, end, from, part, place_.pose, replanned});
  run.end = end;
}

void TimedDriver::stand_behind(const DriveRoute& route) {
  if (!route.segments.empty()) place_ = {{route.segments.back().to.cell, route.segments.back().to.heading}, true};
}

}  // namespace labmouse
