#include "labmouse/controller/axis_control.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/hardware/motor_driver.hpp"

namespace labmouse {
namespace {

/// Feedforward: the duty for a rate and its rate of change.
double needed(const MotorAxis& axis, double rate, double change) {
  const double almost = 0.005 * axis.gain;
  return (rate + axis.time * change) / axis.gain + axis.dead_zone * std::clamp(rate / almost, -1.0, 1.0);
}

/// Adds a proportional and an integral term. The integral term is limited to half of full duty (anti-windup).
double corrected(const AxisGains& gains, double error, double seconds, double& sum) {
  constexpr double most = 0.5;
  sum += error * seconds;
  if (gains.integral > 0.0) sum = std::clamp(sum, -most / gains.integral, most / gains.integral);
  return gains.proportional * error + gains.integral * sum;
}

}  // namespace

Drive AxisControl::control(const Command& command, double speed, double turning, double volts) {
  const double onwards = needed(gains_.drive_model, command.speed, command.speeding) +
                         motors_.turning * std::abs(command.turning) * std::clamp(command.speed, -1.0, 1.0) +
                         corrected(gains_.drive, command.speed - speed, gains_.seconds, drive_sum_);
  const double around = needed(gains_.turn_model, command.turning, command.twisting) +
                        corrected(gains_.turn, command.turning - turning, gains_.seconds, turn_sum_);
  const double full = volts > 0.0 ? motors_.volts / volts : 1.0;
  const auto duty = [&](Wheel wheel, double braked) {
    const double idle = idle_duty(motors_, wheel, speed, turning);
    const double given = duty_for(motors_, braked, motors_.strength[wheel], full, idle);
    return static_cast<float>(std::clamp(given, -1.0, 1.0));
  };
  return {duty(left_wheel, onwards - around / 2.0), duty(right_wheel, onwards + around / 2.0)};
}

}  // namespace labmouse
