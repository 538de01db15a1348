#include "labmouse/contest/drive.hpp"

#include <utility>

#include "labmouse/contest/drive_contest.hpp"
#include "labmouse/contest/ideal_drive.hpp"

namespace labmouse {

Briefing brief(const Maze& maze, const DriveRules& rules, const DriveModel& model, std::uint64_t seed) {
  Briefing briefing;
  briefing.size = maze.size();
  briefing.start = {maze.start(), maze.start_heading()};
  briefing.goals = maze.goals();
  briefing.seed = seed;
  briefing.sight = model.robot.sight;
  briefing.drive = {&model, rules.time_limit, 1.0, rules.maze_time_divisor, rules.most_runs, rules.untouched_bonus};
  return briefing;
}

DriveRecord drive(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse) {
  PhysicalRecord record;
  IdealDriver driver(maze, model, rules.time_limit, record.drive);
  run_contest(maze, rules, model, mouse, driver, record);
  return std::move(record.drive);
}

}  // namespace labmouse
