// The duties that the built-in controller sets, whatever drives the motors.
#include "labmouse/controller/axis_control.hpp"

#include <gtest/gtest.h>

#include "labmouse/hardware/motor_driver.hpp"
#include "tests/controller/robots.hpp"

namespace labmouse {
namespace {

TEST(AxisControl, HasTheSameEffectWithEachDriver) {
  const Hardware plain = *test::model_of("kerise").robot.hardware;
  const Command command = {.speed = 400.0, .speeding = 800.0, .turning = 2.0, .twisting = 5.0};
  const double speed = 390.0, turning = 1.8, voltage = 0.9;
  const auto control = [&](const Hardware& hardware) {
    return AxisControl(gains_for(hardware, 90.0), hardware.motors)
        .control(command, speed, turning, voltage * hardware.motors.volts);
  };
  const Drive usual = control(plain);
  for (const double coast : {0.0, 1.0}) {
    Hardware own = plain;
    own.motors.strength = {0.8, 1.2};
    own.motors.dead_time = 0.03;
    own.motors.coast = coast;
    const Drive drive = control(own);
    const auto effect = [&](Wheel wheel, double duty) {
      return braked_duty(own.motors, duty, own.motors.strength[wheel], voltage,
                         idle_duty(own.motors, wheel, speed, turning));
    };
    EXPECT_NEAR(effect(left_wheel, drive.left), usual.left * voltage, 1e-6) << coast;
    EXPECT_NEAR(effect(right_wheel, drive.right), usual.right * voltage, 1e-6) << coast;
  }
}

}  // namespace
}  // namespace labmouse
