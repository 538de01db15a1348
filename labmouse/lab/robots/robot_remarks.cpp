#include "labmouse/lab/robots/robot_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "labmouse/hardware/beam.hpp"

namespace labmouse {
namespace {

constexpr double degree = 3.141592653589793 / 180.0;

/// A mouse needs hundredths of a second to reach its full yaw rate. A yaw acceleration or jerk above these limits
/// (rad/s², rad/s³) is likely to be in degrees if it reaches the full yaw rate or acceleration in less than 4 ms. No
/// known mouse turns so hard, but many would have such a number in degrees.
constexpr double likely_seconds = 0.004, likely_acceleration = 1000.0, likely_jerk = 50'000.0;
/// About six turns a second, rad/s.
constexpr double likely_speed = 40.0;

std::string in_degrees(std::string_view key, double value, std::string_view unit, std::string_view what) {
  return fmt::format("at {} = {:g} rad{} it {}; if the value is in degrees{}, write {:.4g}", key, value, unit, what,
                     unit, value * degree);
}

std::string too_soon(std::string_view key, double rate, std::string_view unit, double full, double likely,
                     std::string_view what) {
  if (rate < likely || full / rate >= likely_seconds) return "";
  return in_degrees(key, rate, unit, fmt::format("{} after {:.1f} ms", what, full / rate * 1e3));
}

std::string too_quick(std::string_view key, double speed) {
  if (speed <= likely_speed) return "";
  return in_degrees(key, speed, "/s", fmt::format("turns {:.0f} times a second", speed / (360.0 * degree)));
}

std::string too_near(std::string_view key, double length) {
  if (length <= 0.0 || length >= 1.0) return "";
  return fmt::format("{} = {:g} mm is less than a millimetre; if the value is in metres, write {:g}", key, length,
                     length * 1e3);
}

/// From here on in a cell, as a share of it, sensors see walls and not the post.
constexpr double behind_post = 0.14;
/// Readings later than so many cells are remarked.
constexpr double late_cells = 0.05;

/// What the controller cannot do with these sensors.
std::vector<std::string> sensor_remarks(const Sensors& sensors, double cell) {
  const auto any = [](const auto& list, auto looks) {
    return std::any_of(list.begin(), list.end(), [&](const auto& one) { return looks(side_of(one.beam)); });
  };
  const auto aside = [](BeamSide side) { return side != BeamSide::ahead; };
  const auto ahead = [](BeamSide side) { return side == BeamSide::ahead; };
  const bool range_ahead = any(sensors.rangers, ahead), infrared_aside = any(sensors.infrared, aside);
  std::vector<std::string> remarks;
  const auto remark_if = [&](bool lacks, const char* text) {
    if (lacks) remarks.emplace_back(text);
  };
  remark_if(!sensors.has_gyro(), "no gyro: the built-in controller measures turns by the wheels");
  remark_if(!sensors.has_accelerometer(),
            "no accelerometer: the built-in controller takes the slip in turns from the tyres' numbers");
  remark_if(!range_ahead && !any(sensors.infrared, ahead),
            "no sensor looks ahead: the built-in controller drives into walls that it does not know");
  remark_if(!range_ahead, "no ToF sensor looks ahead: no correction by walls ahead");
  remark_if(!infrared_aside, "no infrared sensor looks aside: no correction by the edges of walls and by posts");
  const bool looks_aside = infrared_aside || any(sensors.rangers, aside);
  remark_if(!looks_aside, "no sensor looks aside: no correction by side walls");
  for (const BeamSide blind : {BeamSide::left, BeamSide::right}) {
    const auto there = [&](BeamSide side) { return side == blind; };
    remark_if(looks_aside && !any(sensors.infrared, there) && !any(sensors.rangers, there),
              blind == BeamSide::left
                  ? "no sensor looks to the left: the built-in controller cannot read the walls there"
                  : "no sensor looks to the right: the built-in controller cannot read the walls there");
  }
  const auto foresees = [&](const auto& one) {
    const Beam& beam = one.beam;
    const double along = beam.ahead + calibrated_distance(beam, cell) * direction_of(beam.angle).cosine;
    return side_of(beam) != BeamSide::ahead && along > behind_post * cell;
  };
  remark_if(
      looks_aside && std::none_of(sensors.infrared.begin(), sensors.infrared.end(), foresees) &&
          std::none_of(sensors.rangers.begin(), sensors.rangers.end(), foresees),
      "at the edge of a cell, no sensor sees its side walls; there the built-in controller decides where to drive");
  return remarks;
}

/// What goes too fast for the counters or the infrared sensors.
std::vector<std::string> speed_remarks(const Robot& robot) {
  const Hardware& hardware = *robot.hardware;
  const Sensors& sensors = hardware.sensors;
  std::vector<std::string> remarks;
  const double seconds = hardware.motors.period / 1e3;
  const double counts = std::max(robot.speed, robot.speed_diagonal) * seconds / sensors.count;
  const double most = std::exp2(sensors.count_bits - 1.0);
  if (counts >= most)
    remarks.push_back(
        fmt::format("its wheels turn by up to {:.0f} counts in {:g} ms, and a counter of {:g} bits tells "
                    "apart less than {:g}",
                    counts, hardware.motors.period, sensors.count_bits, most));
  double late = 0.0;
  for (const Infrared& sensor : sensors.infrared) late = std::max(late, sensor.latency / 1e3 * robot.speed);
  if (late > late_cells * robot.cell)
    remarks.push_back(
        fmt::format("infrared sensors are read up to {:.0f} mm late, which the built-in controller does "
                    "not allow for",
                    late));
  return remarks;
}

/// The highest yaw rate in a curve, rad/s.
double quickest_curve(const DriveModel& model) {
  double quickest = 0.0;
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    // Where the bend is hardest, the speed may be lower than at the ends: lateral acceleration limits both together.
    const double peak = model.shapes[i].ramp.peak;
    quickest = std::max(
        quickest, std::min(peak * model.tables.turns[i].speed, std::sqrt(peak * model.robot.lateral_acceleration)));
  }
  return quickest;
}

}  // namespace

std::vector<std::string> robot_remarks(const Robot& robot, const DriveModel& model) {
  std::vector<std::string> remarks;
  if (!robot.fixed) {
    const double quickest = quickest_curve(model);
    remarks = {too_near("clearance", robot.clearance), too_near("run_up", robot.run_up),
               too_soon("curve.yaw_acceleration", robot.yaw_acceleration, "/s²", quickest, likely_acceleration,
                        "turns at full speed"),
               too_quick("curve.yaw_speed", robot.yaw_speed),
               too_soon("curve.yaw_jerk", robot.yaw_jerk, "/s³", robot.yaw_acceleration, likely_jerk,
                        "reaches its yaw acceleration")};
  }
  if (robot.search.cell == 0) {
    remarks.push_back(too_soon("search.pivot_acceleration", robot.pivot_acceleration, "/s²", robot.pivot_speed,
                               likely_acceleration, "turns at full speed"));
    remarks.push_back(too_quick("search.pivot_speed", robot.pivot_speed));
  }
  if (robot.hardware) {
    std::vector<std::string> of_sensors = sensor_remarks(robot.hardware->sensors, robot.cell);
    std::move(of_sensors.begin(), of_sensors.end(), std::back_inserter(remarks));
    std::vector<std::string> of_speed = speed_remarks(robot);
    std::move(of_speed.begin(), of_speed.end(), std::back_inserter(remarks));
  }
  std::erase_if(remarks, [](const std::string& remark) { return remark.empty(); });
  return remarks;
}

}  // namespace labmouse
