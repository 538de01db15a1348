#include "labmouse/contest/fallible.hpp"

#include "labmouse/contest/fallible_contest.hpp"
#include "labmouse/contest/fallible_drive.hpp"

namespace labmouse {

PhysicalRecord drive_fallibly(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                              const PhysicalConditions& conditions, const Hazards& hazards, std::uint64_t seed,
                              Strategy& mouse) {
  PhysicalRecord record;
  PhysicalConditions held = conditions;
  held.map = mouse.map_kind().value_or(conditions.map);
  FallibleDriver driver(maze, model, held, hazards, seed, rules.time_limit, record);
  hold_contest(maze, rules, model, held, mouse, driver, record);
  return record;
}

}  // namespace labmouse
