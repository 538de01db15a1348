#include "labmouse/lab/logs/log_fit.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/lab/logs/log_motion.hpp"

namespace labmouse {
namespace {

/// The duties of both axes, and what turning takes of the one of driving, but for a factor.
struct AxisDuties {
  std::vector<double> drive, turn, taken;
};
AxisDuties axis_duties(const LogMotion& motion, const std::vector<double>& speed) {
  // In the mean of a time in which a body shakes once, so that shaking is no turning.
  constexpr std::size_t shaking = 16;
  const std::vector<double> turning = rates_of(motion.angle, shaking);
  AxisDuties duties;
  for (std::size_t tick = 0; tick < motion.ticks; ++tick) {
    duties.drive.push_back((motion.left[tick] + motion.right[tick]) / 2.0);
    duties.turn.push_back(motion.right[tick] - motion.left[tick]);
    if (!turning.empty() && !speed.empty())
      duties.taken.push_back(std::clamp(speed[tick], -1.0, 1.0) * std::abs(turning[tick]));
  }
  return duties;
}

/// A number, less sure by a share.
void doubt(Estimate& number, double share) {
  if (number.said()) number.error = std::hypot(number.error, share * number.value);
}

}  // namespace

LogFit fit_log(const Log& log, const Hardware& hardware, double cell, const WholeWay& whole) {
  LogFit fit;
  fit.seconds = log.times.back() / 1000.0;
  fit.count = fit_count(log, whole);
  Hardware counted = hardware;
  if (fit.count.count.said()) counted.sensors.count = fit.count.count.value;
  const LogMotionResult moved = motion_of(log, counted);
  fit.error = moved.error;
  if (!fit.error.empty()) return fit;
  const LogMotion& motion = moved.motion;
  fit.gyro = fit_gyro(log, motion);
  fit.infrared = fit_infrared(log, hardware, cell);
  if (motion.left.empty()) {
    fit.drive.refusal = fit.turn.refusal = "the log has no duties";
    return fit;
  }
  const std::vector<double> speed = rates_of(motion.way), turning = rates_of(motion.angle);
  const AxisDuties duties = axis_duties(motion, speed);
  const double scale =
      fit.count.count.said() ? fit.count.count.error / fit.count.count.value : hardware.noise.encoder_scale;
  if (motion.way.empty()) {
    fit.drive.refusal = "the log has no encoders";
  } else {
    fit.drive = fit_motor({motion.way, speed, duties.drive, duties.turn, duties.taken, hardware.motors.turning, 40},
                          hardware.motors.drive);
    doubt(fit.drive.gain, scale);
    // Turning is not told from shaking better than that.
    constexpr double told = 0.02;
    doubt(fit.drive.taking, told);
  }
  if (motion.angle.empty()) {
    fit.turn.refusal = "the log has neither gyro nor encoders";
  } else {
    fit.turn = fit_motor({motion.angle, turning, duties.turn, duties.drive, {}, 0.0, 8}, hardware.motors.turn);
    doubt(fit.turn.gain, motion.by_gyro ? hardware.noise.gyro_scale : scale);
  }
  return fit;
}

}  // namespace labmouse
