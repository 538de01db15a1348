// A contest in seconds as a play: `Play` with `drive` in apps/web/page/src/core/types.ts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/drive/robot.hpp"

namespace labmouse {

/// What a play in seconds is made of: a record that agrees with its maze, and what it was made with.
struct DrivenContest {
  std::string mouse;
  std::string maze_name;
  std::uint64_t seed = 0;
  const Maze& maze;
  const DriveModel& model;
  const DriveRules& rules;
  const DriveRecord& record;
};

nlohmann::ordered_json play_json(const DrivenContest& contest);

}  // namespace labmouse
