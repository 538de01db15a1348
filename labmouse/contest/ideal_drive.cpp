#include "labmouse/contest/ideal_drive.hpp"

#include <algorithm>
#include <cassert>

#include "labmouse/contest/drive_gates.hpp"

namespace labmouse {

IdealDriver::IdealDriver(const Maze& maze, const DriveModel& model, MazeTime time_limit, DriveRecord& record)
    : TimedDriver(maze, model, time_limit, record), known_(maze.size(), model.robot.sight) {}

Sighting IdealDriver::seen(const Pose& pose) const {
  const auto read = [&](Heading side) { return std::min(model_.robot.sight, maze_.corridor(pose.cell, side)); };
  return {read(left_of(pose.heading)), read(pose.heading), read(right_of(pose.heading))};
}

/// Reads the walls, and records the new ones.
void IdealDriver::arrive() {
  WallSet news = known_.unknown();
  [[maybe_unused]] const bool agrees = known_.learn(place_.pose, seen(place_.pose));
  assert(agrees);
  news -= known_.unknown();
  news.for_each([&](Wall wall) { record_.walls.push_back({clock_, wall, known_.open().contains(wall)}); });
}

void IdealDriver::know_open(const WallSet& walls) {
  walls.for_each([&](Wall wall) {
    known_.learn(wall, true);
    record_.walls.push_back({clock_, wall, true});
  });
}

bool IdealDriver::make(const Action& part, bool replanned) {
  advance(part, clock_, replanned);
  return true;
}

bool IdealDriver::run(const DriveRoute& route) {
  DriveRun& run = record_.runs.back();
  set_gates(run, maze_, model_);
  run.end = clock_ = run.begin + route.time;
  stand_behind(route);
  arrive();
  return true;
}

}  // namespace labmouse
