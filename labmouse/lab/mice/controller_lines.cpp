#include "labmouse/lab/mice/controller_lines.hpp"

#include <fmt/format.h>

#include "labmouse/external/controller_protocol.hpp"
#include "labmouse/lab/robots/hardware_keys.hpp"

namespace labmouse {
namespace {

std::string milliseconds(std::int64_t microseconds) { return fmt::format("{:.12g}", microseconds / 1e3); }

/// A sensor with its numbers in the order of the keys of robot files.
template <class Sensor>
std::string sensor_line(std::string_view name, Sensor sensor, std::span<const SensorKey<Sensor>> keys) {
  std::string line(name);
  for (const SensorKey<Sensor>& key : keys) line += fmt::format(" {:.12g}", key.number(sensor));
  return line + "\n";
}

}  // namespace

std::string controller_lines(const ControllerBriefing& briefing) {
  const DriveRules& rules = briefing.rules;
  const Pose& start = briefing.start;
  std::string text = fmt::format("{}\nsize {} {}\nstart {} {} {}\n", controller_greeting, briefing.size.width,
                                 briefing.size.height, start.cell.x, start.cell.y, name_of(start.heading));
  briefing.goals.for_each([&](Cell goal) { text += fmt::format("goal {} {}\n", goal.x, goal.y); });
  text += fmt::format(
      "time_limit {}\nruns {}\nclock {}\nmaze_time_divisor {}\ntouch_penalty {}\nuntouched_bonus {}\nhandling {}\n"
      "seed {}\ncell {:.12g}\n",
      milliseconds(rules.time_limit), rules.most_runs, rules.gate_to_gate ? "gate" : "rest", rules.maze_time_divisor,
      milliseconds(rules.touch_penalty), milliseconds(rules.untouched_bonus), milliseconds(briefing.handling),
      briefing.seed, briefing.model.tables.cell);
  const Hardware& hardware = *briefing.model.robot.hardware;
  HardwareTerms terms = terms_of(hardware);
  for (const HardwareKey& each : hardware_keys())
    if (terms.has(each.key)) text += fmt::format("{} {:.12g}\n", each.key.name, each.number(terms.numbers) * each.unit);
  for (const Infrared& one : hardware.sensors.infrared) text += sensor_line("infrared", one, infrared_keys());
  for (const Ranger& one : hardware.sensors.rangers) text += sensor_line("ranger", one, ranger_keys());
  return text + "begin\n";
}

}  // namespace labmouse
