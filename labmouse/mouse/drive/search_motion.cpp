#include "labmouse/mouse/drive/search_motion.hpp"

#include <cassert>
#include <cstdlib>

namespace labmouse {
namespace {

int quarters_of(const Action& step) { return step.rotation / 90; }

/// The time of the pivot of a step.
DriveTime pivot_time(const SearchDrive& drive, const Action& step) {
  return std::abs(quarters_of(step)) * drive.quarter;
}

DriveTime time_to_first_edge(const SearchDrive& drive, const Action& step) {
  return step.rotation == 180 ? drive.back : drive.turn;
}

}  // namespace

bool is_search_step(const SearchPlace& from, const Action& step) {
  if (step.kind != Action::Kind::step || step.movement < 0 || step.movement > max_drive_side) return false;
  const bool rotates = step.rotation == 90 || step.rotation == -90 || step.rotation == 180;
  if (!rotates && step.rotation != 0) return false;
  return rotates || step.movement > 0 || !from.at_rest;
}

SearchPlace after_search(const SearchPlace& from, const Action& step) {
  const Heading heading = turned(from.pose.heading, quarters_of(step));
  return {{neighbour(from.pose.cell, heading, step.movement), heading}, step.movement == 0};
}

DriveTime search_time(const SearchDrive& drive, const SearchPlace& from, const Action& step, const CellSet& known) {
  assert(is_search_step(from, step));
  if (step.movement == 0) return (from.at_rest ? 0 : drive.half_cell) + pivot_time(drive, step);
  DriveTime time = 0;
  int edges = 0;
  if (from.at_rest || step.rotation != 0) {
    time = from.at_rest ? pivot_time(drive, step) + drive.half_cell : time_to_first_edge(drive, step);
    edges = 1;
  }
  const Heading heading = after_search(from, step).pose.heading;
  while (edges < step.movement) {
    const Pose edge = {neighbour(from.pose.cell, heading, edges), heading};
    const int dash = dash_length(drive, edge, step.movement - edges, [&](Cell cell) { return known.contains(cell); });
    time += drive.dash(dash);
    edges += dash;
  }
  return time;
}

Action search_step(Heading heading, Heading direction, int cells) {
  constexpr int degrees[] = {0, 90, 180, -90};
  return Action::step(degrees[quarters_between(heading, direction)], cells);
}

}  // namespace labmouse
