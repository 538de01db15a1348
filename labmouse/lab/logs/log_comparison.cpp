#include "labmouse/lab/logs/log_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/hardware/sense.hpp"
#include "labmouse/lab/drives/open_floor.hpp"
#include "labmouse/lab/logs/log_fit.hpp"
#include "labmouse/lab/logs/log_motion.hpp"

namespace labmouse {
namespace {

constexpr std::size_t smoothed = 5;  // ticks to each side

/// Speeds as a reference: with how they change.
struct Reference {
  std::vector<double> rates, changes;
};
Reference reference_of(std::vector<double> rates) {
  Reference reference{std::move(rates), {}};
  reference.changes = rates_of(reference.rates, smoothed);
  return reference;
}

/// By ticks, of rows.
std::vector<double> at_ticks(const Log& log, LogRole role, std::size_t ticks) {
  std::vector<double> values;
  std::size_t row = 0;
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    while (row + 1 < log.times.size() && log.times[row + 1] <= static_cast<double>(tick) * 1e3 * tick_seconds + 1e-3)
      ++row;
    values.push_back(log.of(role)[row]);
  }
  return values;
}

void drive_by_duties(const Log& log, std::size_t ticks, OpenFloor& driven) {
  const std::vector<double> left = at_ticks(log, LogRole::left, ticks), right = at_ticks(log, LogRole::right, ticks);
  for (std::size_t tick = 0; tick + 1 < ticks; ++tick)
    driven.push({static_cast<float>(left[tick]), static_cast<float>(right[tick])});
}

void drive_by_reference(const Log& log, const LogMotion& motion, OpenFloor& driven) {
  const bool told = log.has(LogRole::speed);
  const Reference speed = reference_of(told ? at_ticks(log, LogRole::speed, motion.ticks) : rates_of(motion.way));
  const Reference turning = reference_of(told ? at_ticks(log, LogRole::turning, motion.ticks) : rates_of(motion.angle));
  for (std::size_t tick = 0; tick + 1 < motion.ticks; ++tick)
    driven.follow({speed.rates[tick], speed.changes[tick], turning.rates[tick], turning.changes[tick]});
}

std::string why_not_compared(const Log& log, const LogMotion& motion) {
  if (motion.way.empty() && motion.angle.empty())
    return "has neither encoders nor gyro, so there is nothing to compare with; name 'left_count' and 'right_count', "
           "or 'gyro'";
  if (motion.left.empty() && !log.has(LogRole::speed) && (motion.way.empty() || motion.angle.empty()))
    return "has no duties and no speeds to drive after; name 'left' and 'right', or 'speed' and 'turning'";
  const std::size_t early = std::min<std::size_t>(20, motion.ticks - 1);
  constexpr double still = 1.0, turned = 0.05;  // mm, rad
  if ((!motion.way.empty() && std::abs(motion.way[early] - motion.way[0]) > still) ||
      (!motion.angle.empty() && std::abs(motion.angle[early] - motion.angle[0]) > turned))
    return "begins while the mouse moves; cut it so that it begins at rest";
  return "";
}

ComparedCurve from_zero(const std::vector<double>& log, const std::vector<double>& robot) {
  if (log.empty()) return {};
  ComparedCurve curve{log, robot, {}};
  for (double& value : curve.log) value -= log.front();
  for (double& value : curve.robot) value -= robot.front();
  return curve;
}

ComparedCurve rates_in(const ComparedCurve& places) {
  if (places.log.empty()) return {};
  return {rates_of(places.log, smoothed), rates_of(places.robot, smoothed), {}};
}

double peak_of(const std::vector<double>& values) {
  double peak = 0.0;
  for (const double value : values) peak = std::max(peak, std::abs(value));
  return peak;
}

/// The first tick about which they differ by more than the share of the peak, and by more than that.
std::optional<std::size_t> parting_of(const ComparedCurve& curve, double least) {
  constexpr std::size_t about = 50;  // ticks, in whose mean shaking is little
  const double most = std::max(least, parting_share * peak_of(curve.log));
  double sum = 0.0;
  for (std::size_t tick = 0; tick < curve.log.size(); ++tick) {
    sum += curve.robot[tick] - curve.log[tick];
    if (tick >= about) sum -= curve.robot[tick - about] - curve.log[tick - about];
    if (tick + 1 >= about && std::abs(sum) > most * about) return tick + 1 - about / 2;
  }
  return std::nullopt;
}

}  // namespace

LogComparison compare_log(const Log& log, const Robot& robot) {
  LogComparison comparison;
  const LogMotionResult moved = motion_of(log, *robot.hardware);
  comparison.error = moved.error;
  if (comparison.error.empty()) comparison.error = why_not_compared(log, moved.motion);
  if (!comparison.error.empty()) return comparison;
  comparison.by_duties = !moved.motion.left.empty();
  if (comparison.by_duties) comparison.stronger = fit_log(log, *robot.hardware, robot.cell, {}).turn.mixed.value;
  OpenFloor driven(*robot.hardware, robot.cell, comparison.stronger);
  if (comparison.by_duties)
    drive_by_duties(log, moved.motion.ticks, driven);
  else
    drive_by_reference(log, moved.motion, driven);
  comparison.way = from_zero(moved.motion.way, driven.ways());
  comparison.turn = from_zero(moved.motion.angle, driven.angles());
  comparison.speed = rates_in(comparison.way);
  comparison.yaw = rates_in(comparison.turn);
  comparison.speed.parts = parting_of(comparison.speed, 20.0);  // mm/s
  comparison.yaw.parts = parting_of(comparison.yaw, 0.5);       // rad/s
  comparison.way.parts = parting_of(comparison.way, 3.0);       // mm
  comparison.turn.parts = parting_of(comparison.turn, 0.04);    // rad
  return comparison;
}

}  // namespace labmouse
