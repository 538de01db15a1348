#include "labmouse/contest/physical.hpp"

#include "labmouse/contest/fallible_contest.hpp"
#include "labmouse/contest/physical_drive.hpp"

namespace labmouse {

PhysicalRecord drive_physically(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                                const PhysicalConditions& conditions, std::uint64_t seed, Strategy& mouse,
                                const PilotParts& parts) {
  PhysicalRecord record;
  PhysicalConditions held = conditions;
  held.map = mouse.map_kind().value_or(conditions.map);
  PhysicalDriver driver(maze, model, held, seed, rules.time_limit, record, parts);
  hold_contest(maze, rules, model, held, mouse, driver, record);
  return record;
}

std::string why_not_physical(const DriveModel& model) {
  if (!model.robot.hardware) return "it has no [body], [motors], [sensors] and [noise], which say what it is built of";
  if (model.robot.fixed) return "its turns are times, without the curves behind them";
  return "";
}

}  // namespace labmouse
