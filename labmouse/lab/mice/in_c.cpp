#include "labmouse/lab/mice/in_c.hpp"

#include <algorithm>
#include <array>

#include "labmouse/lab/robots/hardware_keys.hpp"

namespace labmouse {
namespace {

/// The fields of a robot in C, in the order of the keys of robot files.
#define LABMOUSE_ROBOT_MEMBER(section, name) &labmouse_robot::section##_##name,
constexpr std::array robot_members = {LABMOUSE_ROBOT_NUMBERS(LABMOUSE_ROBOT_MEMBER)};
#undef LABMOUSE_ROBOT_MEMBER

labmouse_robot robot_in_c(const Hardware& hardware) {
  labmouse_robot robot{};
  HardwareTerms terms = terms_of(hardware);
  const auto keys = hardware_keys();
  for (std::size_t i = 0; i < std::min(keys.size(), robot_members.size()); ++i)
    if (terms.has(keys[i].key)) robot.*robot_members[i] = keys[i].number(terms.numbers) * keys[i].unit;
  for (const Infrared& one : hardware.sensors.infrared)
    robot.infrared[robot.infrared_sensors++] = {one.beam.ahead, one.beam.aside, one.beam.angle, one.gain,   one.fall,
                                                one.most,       one.footprint,  one.group,      one.latency};
  for (const Ranger& one : hardware.sensors.rangers)
    robot.ranger[robot.range_sensors++] = {one.beam.ahead, one.beam.aside, one.beam.angle, one.reach, one.period};
  return robot;
}

}  // namespace

labmouse_briefing briefing_in_c(const ControllerBriefing& briefing) {
  const auto milliseconds = [](std::int64_t time) { return static_cast<double>(time) / 1e3; };
  const DriveRules& rules = briefing.rules;
  labmouse_briefing told{};
  told.width = briefing.size.width;
  told.height = briefing.size.height;
  told.start = {briefing.start.cell.x, briefing.start.cell.y};
  told.start_heading = static_cast<labmouse_heading>(briefing.start.heading);
  briefing.goals.for_each([&](Cell goal) {
    if (told.goals < LABMOUSE_MOST_GOALS) told.goal[told.goals++] = {goal.x, goal.y};
  });
  told.time_limit = milliseconds(rules.time_limit);
  told.runs = rules.most_runs;
  told.gate_to_gate = rules.gate_to_gate ? 1 : 0;
  told.maze_time_divisor = rules.maze_time_divisor;
  told.touch_penalty = milliseconds(rules.touch_penalty);
  told.untouched_bonus = milliseconds(rules.untouched_bonus);
  told.handling = milliseconds(briefing.handling);
  told.seed = briefing.seed;
  told.cell = briefing.model.tables.cell;
  told.robot = robot_in_c(*briefing.model.robot.hardware);
  return told;
}

labmouse_sense sense_in_c(const Sense& sense) {
  labmouse_sense told{};
  told.tick = sense.tick;
  std::copy(sense.counts.begin(), sense.counts.end(), told.counts);
  told.gyro = sense.gyro;
  std::copy(sense.acceleration.begin(), sense.acceleration.end(), told.acceleration);
  std::copy(sense.infrared.begin(), sense.infrared.end(), told.infrared);
  for (std::size_t i = 0; i < sense.ranges.size(); ++i) {
    told.ranges[i] = sense.ranges[i].distance;
    told.ranges_new[i] = sense.ranges[i].is_new ? 1 : 0;
  }
  told.millivolts = sense.millivolts;
  return told;
}

}  // namespace labmouse
