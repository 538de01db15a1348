#include "labmouse/contest/drive_search.hpp"

#include <cassert>

#include "labmouse/contest/drive_gates.hpp"

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
  const bool searches = run.kind == DriveRun::Kind::search;
  if (searches) note_gates(run, maze_, model_.search.half_cell, place_, action, clock_, end);
  place_ = after_search(place_, action);
  goal_entered_ = goal_entered_ || (searches && maze_.is_goal(place_.pose.cell));
  run.end = clock_ = end;
  read();
}

void SearchDriver::stop_search() { note_stop(record_.runs.back(), maze_, model_.search.half_cell, place_, clock_); }

void SearchDriver::put(const SearchPlace& place, MazeTime clock) {
  place_ = place;
  clock_ = clock;
  read();
}

}  // namespace labmouse
