#include "labmouse/mouse/robot/straights.hpp"

#include <algorithm>
#include <cmath>

namespace labmouse {
namespace {

/// Undoes rounding that makes a straight longer than two straights that it is made of.
void take_back_rounding(StraightTimes& straights, std::size_t lane) {
  const auto at = [&](int units) -> DriveTime& {
    return straights.between[(static_cast<std::size_t>(units) * straights.count() + lane) * straights.count() + lane];
  };
  for (int units = 2; units <= StraightTimes::longest; ++units)
    for (int part = 1; part <= units / 2; ++part) at(units) = std::min(at(units), at(part) + at(units - part));
}

/// The time to the end of a run; no_time if the mouse cannot stop.
DriveTime time_to_end(double length, double from, double end, const StraightLimits& limits) {
  const double reached = std::sqrt(from * from + 2.0 * limits.acceleration * length);
  if (reached <= end || end >= limits.speed) return microseconds(seconds_onward(length, from, limits));
  const auto seconds = seconds_between(length, from, end, limits);
  return seconds ? microseconds(*seconds) : no_time;
}

}  // namespace

std::optional<double> seconds_between(double length, double from, double to, const StraightLimits& limits) {
  const auto [top, up, down] = limits;
  if (to * to > from * from + 2.0 * up * length || from * from > to * to + 2.0 * down * length) return std::nullopt;
  const double ramps = (top * top - from * from) / (2.0 * up) + (top * top - to * to) / (2.0 * down);
  if (length >= ramps) return (top - from) / up + (top - to) / down + (length - ramps) / top;
  const double peak = std::sqrt((2.0 * up * down * length + down * from * from + up * to * to) / (up + down));
  // At the edge of what is feasible rounding may put the peak a hair below either end.
  return std::max(0.0, (peak - from) / up) + std::max(0.0, (peak - to) / down);
}

double seconds_onward(double length, double from, const StraightLimits& limits) {
  const double ramp = (limits.speed * limits.speed - from * from) / (2.0 * limits.acceleration);
  if (length >= ramp) return (limits.speed - from) / limits.acceleration + (length - ramp) / limits.speed;
  return (std::sqrt(from * from + 2.0 * limits.acceleration * length) - from) / limits.acceleration;
}

DriveTime microseconds(double seconds) { return static_cast<DriveTime>(std::floor(seconds * 1e6 + 0.5)); }

void fill_between(StraightTimes& straights, double unit, const StraightLimits& limits) {
  straights.between.clear();
  for (int units = 0; units <= StraightTimes::longest; ++units)
    for (const Lane& from : straights.lanes)
      for (const Lane& to : straights.lanes) {
        const auto seconds = seconds_between(from.lead + units * unit + to.lead, from.speed, to.speed, limits);
        straights.between.push_back(seconds ? microseconds(*seconds) : no_time);
      }
  for (std::size_t lane = 0; lane < straights.count(); ++lane)
    if (straights.lanes[lane].lead == 0.0) take_back_rounding(straights, lane);
}

double end_speed(const Robot& robot, int room) {
  if (robot.stop == Stop::beyond) return robot.speed;
  return std::min(robot.speed, std::sqrt(2.0 * robot.braking * room * robot.cell));
}

void fill_ends(DriveTables& tables, const Robot& robot) {
  const StraightLimits limits = limits_along(robot);
  for (int units = 0; units <= StraightTimes::longest; ++units)
    for (const Lane& lane : tables.along.lanes) {
      const auto start = seconds_between(robot.run_up + units * robot.cell / 2.0 + lane.lead, 0.0, lane.speed, limits);
      tables.start.push_back(start ? microseconds(*start) : no_time);
    }
  for (int room = 0; room < max_drive_side; ++room) {
    const double end = end_speed(robot, room);
    for (int units = 0; units <= StraightTimes::longest; ++units) {
      const double length = units * robot.cell / 2.0;
      for (const Lane& lane : tables.along.lanes)
        tables.finish.push_back(time_to_end(lane.lead + length, lane.speed, end, limits));
      tables.whole.push_back(time_to_end(robot.run_up + length, 0.0, end, limits));
    }
    if (end >= robot.speed) break;  // more room is of no use
  }
}

}  // namespace labmouse
