// Contests in the physical world to test with.
#pragma once

#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/records/physical_replay.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"

namespace labmouse::test {

/// Noise as measured, and that much of the variation of a robot's file.
inline PhysicalConditions at_variation(double scale) {
  PhysicalConditions conditions;
  conditions.errors.variation = scale;
  return conditions;
}

/// That much of the noise and of the variation of a robot's file.
inline PhysicalConditions at_errors(double scale) {
  PhysicalConditions conditions;
  conditions.errors = {.noise = scale, .variation = scale};
  return conditions;
}

/// What a mouse made of a maze, in the world of these conditions.
inline PhysicalRecord driven_physically(const std::string& mouse, const Maze& maze,
                                        const PhysicalConditions& conditions, std::uint64_t seed = 1,
                                        const DriveRules& rules = find_rules("all-japan").rules,
                                        const std::string& robot = "kerise") {
  const auto model = drive_model(robot);
  Briefing briefing = brief(maze, rules, *model, seed);
  briefing.sight = 1;
  const BuiltinMouse& entry = *find_mouse(mouse);
  const auto strategy = entry.drive(briefing, Settings(entry.parameters));
  return drive_physically(maze, rules, *model, conditions, seed, *strategy);
}

/// The same as a file.
inline DriveRecordFile physical_file(const std::string& mouse, const PhysicalConditions& conditions,
                                     std::uint64_t seed = 1) {
  DriveRecordFile file;
  file.maze_name = "ring";
  file.maze = ring();
  file.mouse = mouse;
  file.seed = seed;
  file.model = drive_model("kerise");
  file.tables_hash = file.model->tables.hash;
  file.rules = find_rules("all-japan").rules;
  PhysicalRecord record = driven_physically(mouse, *file.maze, conditions, seed);
  file.record = std::move(record.drive);
  file.physical = PhysicalPart{conditions, std::move(record), physical_edition, "", ""};
  const DriveScore result = score(file.record, file.rules);
  if (result.best) file.recorded_score = result.runs[*result.best];
  return file;
}

}  // namespace labmouse::test
