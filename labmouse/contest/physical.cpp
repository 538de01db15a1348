#include "labmouse/contest/physical.hpp"

#include "labmouse/contest/drive_contest.hpp"
#include "labmouse/contest/failure_drive.hpp"
#include "labmouse/contest/physical_drive.hpp"

namespace labmouse {
namespace {

/// The conditions, with the map kind that the strategy chooses.
PhysicalConditions conditions_for(const DrivingStrategy& mouse, PhysicalConditions conditions) {
  conditions.map = mouse.map_kind().value_or(conditions.map);
  return conditions;
}

/// Notes that a part of the controller gave up. As in other worlds with errors, the mouse keeps its score.
void give_up(ForfeitReason reason, PhysicalRecord& record) {
  record.drive.reason = reason;
  if (record.drive.outcome != DriveOutcome::finished) record.drive.outcome = DriveOutcome::forfeit;
  if (!record.ends.empty() && record.ends.back() == RunEnd::out_of_time) record.ends.back() = RunEnd::given_up;
}

}  // namespace

PhysicalRecord drive_physically(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                                const PhysicalConditions& conditions, std::uint64_t seed, DrivingStrategy& mouse,
                                const ControllerParts& parts) {
  PhysicalRecord record;
  const PhysicalConditions held = conditions_for(mouse, conditions);
  PhysicalDriver driver(maze, model, held, seed, rules.time_limit, record, parts);
  run_contest(maze, rules, model, mouse, driver, record);
  if (parts.reason() != ForfeitReason::none) give_up(parts.reason(), record);
  return record;
}

PhysicalRecord drive_with_failures(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                                   const PhysicalConditions& conditions, const FailureRates& failure_rates,
                                   std::uint64_t seed, DrivingStrategy& mouse) {
  PhysicalRecord record;
  const PhysicalConditions held = conditions_for(mouse, conditions);
  FailureDriver driver(maze, model, held, failure_rates, seed, rules.time_limit, record);
  run_contest(maze, rules, model, mouse, driver, record);
  return record;
}

std::string why_not_physical(const DriveModel& model) {
  if (!model.robot.hardware)
    return "it has no [body], [motors], [sensors], [noise] and [variation], which describe its parts; "
           "robots/classic.toml is an example";
  const Sensors& sensors = model.robot.hardware->sensors;
  if (sensors.infrared.size() > most_infrared || sensors.rangers.size() > most_rangers)
    return "it has too many sensors: at most 16 infrared and 8 ToF sensors are simulated";
  if (model.robot.fixed) return "its turns are times, without the curves behind them";
  return "";
}

}  // namespace labmouse
