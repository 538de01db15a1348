// Records in seconds to test with.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "labmouse/contest/drive.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse::test {

/// A built-in robot, made once: its tables take longer than most contests.
inline std::shared_ptr<const DriveModel> drive_model(const std::string& robot) {
  static std::map<std::string, std::shared_ptr<const DriveModel>> known;
  std::shared_ptr<const DriveModel>& model = known[robot];
  if (!model) {
    DriveModel made = find_robot(robot).model;
    share_route_tables(made);
    model = std::make_shared<const DriveModel>(std::move(made));
  }
  return model;
}

/// The record of a contest of that mouse.
inline DriveRecordFile driven(const std::string& mouse, const Maze& maze = ring(), const std::string& robot = "mm2021",
                              const std::string& rules = "all-japan") {
  DriveRecordFile file;
  file.maze_name = "ring";
  file.maze = maze;
  file.mouse = mouse;
  file.model = drive_model(robot);
  file.tables_hash = file.model->tables.hash;
  file.rules = find_rules(rules).rules;
  for (const BuiltinMouse* entry : builtin_mice())
    if (entry->name == mouse) {
      const auto strategy = entry->drive(brief(maze, file.rules, *file.model, 1), Settings(entry->parameters));
      file.record = drive(maze, file.rules, *file.model, *strategy);
    }
  const DriveScore result = score(file.record, file.rules);
  if (result.best) file.recorded_score = result.runs[*result.best];
  return file;
}

}  // namespace labmouse::test
