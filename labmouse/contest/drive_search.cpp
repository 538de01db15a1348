#include "labmouse/contest/drive_search.hpp"

#include <cassert>

namespace labmouse {

Sighting look(const Maze& maze, Pose pose, int sight) {
  const auto read = [&](Heading heading) { return std::min(sight, maze.corridor(pose.cell, heading)); };
  return {read(left_of(pose.heading)), read(pose.heading), read(right_of(pose.heading))};
}

SearchDriver::SearchDriver(const Maze& maze, const DriveModel& model, DriveRecord& record)
    : maze_(maze),
      model_(model),
      record_(record),
      known_(maze.size(), model.robot.sight),
      place_(start()),
      goal_entered_(maze.is_goal(maze.start())) {
  read();
}

void SearchDriver::read() {
  seen_ = look(maze_, place_.pose, model_.robot.sight);
  WallSet news = known_.unknown();
  [[maybe_unused]] const bool agrees = known_.learn(place_.pose, seen_);
  assert(agrees);
  news -= known_.unknown();
  news.for_each([&](Wall wall) { record_.walls.push_back({clock_, wall, known_.open().contains(wall)}); });
}

int SearchDriver::cells_at_once(int rotation, int most) const {
  if (rotation != 0 || place_.at_rest) return 1;
  return dash_length(model_.search, place_.pose, most, [&](Cell cell) { return known_.knows(cell); });
}

/// Over one edge, or to rest.
void SearchDriver::pass(const Action& action, MazeTime end) {
  DriveRun& run = record_.runs.back();
  if (run.kind == DriveRun::Kind::search) note_gates(action, end);
  place_ = after_search(place_, action);
  run.end = clock_ = end;
  read();
}

/// A goal is entered at the end of a move, and its middle is passed, or stopped in, by the next, unless that is a small
/// turn.
void SearchDriver::note_gates(const Action& action, MazeTime end) {
  DriveRun& run = record_.runs.back();
  const SearchPlace next = after_search(place_, action);
  const bool turns = action.rotation % 180 != 0 && action.movement > 0;
  if (run.gate_in && !run.centre && !place_.at_rest && !turns && maze_.is_goal(place_.pose.cell)) {
    const bool passes = action.rotation == 0 && action.movement > 0;
    run.centre = clock_ + (passes ? (end - clock_) / 2 : model_.search.half_cell);
  }
  if (!run.gate_out && place_.pose.cell == maze_.start() && action.movement > 0) run.gate_out = end;
  if (!run.gate_in && maze_.is_goal(next.pose.cell) && run.gate_out) run.gate_in = end;
  goal_entered_ = goal_entered_ || maze_.is_goal(next.pose.cell);
}

void SearchDriver::stop_search() {
  DriveRun& run = record_.runs.back();
  if (run.gate_in && !run.centre && !place_.at_rest && maze_.is_goal(place_.pose.cell))
    run.centre = clock_ + model_.search.half_cell;
}

void SearchDriver::put(const SearchPlace& place, MazeTime clock) {
  place_ = place;
  clock_ = clock;
  read();
}

}  // namespace labmouse
