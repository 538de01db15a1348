// How a body moves, against the closed forms of its equations.
#include "labmouse/body/plant.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "labmouse/chance/rng.hpp"
#include "labmouse/functions/whole.hpp"
#include "labmouse/hardware/motor_driver.hpp"
#include "tests/body/plain_mouse.hpp"

namespace labmouse {
namespace {

/// A plant in a hall of 64 by 64 cells, from its middle.
class World {
 public:
  explicit World(const Hardware& hardware, const ErrorScale& level = {}, std::uint64_t seed = 1)
      : hardware_(hardware),
        field_(maze_, test::cell),
        robot_sample_(hardware_, level, maze_.size(), seed),
        plant_(field_, hardware_, robot_sample_, seed) {
    plant_.put({3250.0, 3250.0}, 0.0);
  }

  const BodyMotion& after(int ticks, double left, double right) {
    for (int i = 0; i < ticks; ++i) plant_.step({static_cast<float>(left), static_cast<float>(right)});
    return plant_.motion();
  }
  /// By duties that hold a speed and a yaw rate, of a mouse without noise and losses.
  const BodyMotion& hold(int ticks, double speed, double turning) {
    for (int i = 0; i < ticks; ++i) {
      const auto needed = [](const MotorAxis& axis, double rate) {
        return rate / axis.gain + (rate > 0.0 ? axis.dead_zone : rate < 0.0 ? -axis.dead_zone : 0.0);
      };
      const double on = needed(hardware_.motors.drive, speed), around = needed(hardware_.motors.turn, turning);
      after(1, on - around / 2.0, on + around / 2.0);
    }
    return plant_.motion();
  }
  Plant& plant() { return plant_; }
  const RobotSample& robot_sample() const { return robot_sample_; }

 private:
  Hardware hardware_;
  Maze maze_ = test::hall(64);
  Field field_;
  RobotSample robot_sample_;
  Plant plant_;
};

TEST(Motors, ApproachTheirSpeedAsTheExponential) {
  World world(test::plain_mouse());
  // The motor is past the first moments, in which it breaks loose.
  const double first = world.after(20, 0.25, 0.25).speed;
  const double last = 3000.0 * (0.25 - 0.05);
  for (int tick = 1; tick <= 500; ++tick) {
    const double expected = last + (first - last) * std::exp(-tick * 0.001 / 0.1);
    ASSERT_NEAR(world.after(1, 0.25, 0.25).speed, expected, 1e-4) << tick;
  }
}

TEST(Motors, TurnAsTheExponentialWhereTheWheelsDiffer) {
  World world(test::plain_mouse());
  const double first = world.after(20, -0.1, 0.1).turning;
  const double last = 80.0 * (0.2 - 0.04);
  for (int tick = 1; tick <= 400; ++tick) {
    const double expected = last + (first - last) * std::exp(-tick * 0.001 / 0.08);
    ASSERT_NEAR(world.after(1, -0.1, 0.1).turning, expected, 1e-5) << tick;
  }
  EXPECT_GT(world.plant().motion().angle, 0.0) << "the right wheel ahead turns it to the left";
  EXPECT_NEAR(world.plant().motion().speed, 0.0, 1e-9);
}

TEST(Motors, DoNotBreakLooseBelowTheirDeadZone) {
  World world(test::plain_mouse());
  EXPECT_EQ(world.after(300, 0.0499, 0.0499).speed, 0.0);
  EXPECT_GT(world.after(300, 0.0501, 0.0501).speed, 0.0);
}

TEST(Motors, ComeToRestWithoutDuty) {
  World world(test::plain_mouse());
  world.hold(500, 600.0, 0.0);
  // Friction takes 150 mm/s more than the exponential would: it stands after T ln(1 + 600 / 150).
  EXPECT_GT(world.after(150, 0.0, 0.0).speed, 15.0);
  EXPECT_NEAR(world.after(100, 0.0, 0.0).speed, 0.0, 1.0);
}

TEST(Motors, LoseTheVoltageThatTheirDutyTakes) {
  Hardware hardware = test::plain_mouse();
  hardware.motors.sag = 0.1;
  World world(hardware);
  // A duty of 0.4 leaves 96 % of the voltage.
  EXPECT_NEAR(world.after(2000, 0.4, 0.4).speed, 3000.0 * (0.4 * 0.96 - 0.05), 1e-3);
  EXPECT_NEAR(world.plant().voltage(), 0.96, 1e-7);
}

TEST(Motors, AreSlowerInTurns) {
  Hardware hardware = test::plain_mouse();
  hardware.motors.turning = 0.002;
  World world(hardware);
  const BodyMotion& motion = world.after(2000, 0.2, 0.3);
  EXPECT_NEAR(motion.turning, 80.0 * 0.06, 1e-4);
  EXPECT_NEAR(motion.speed, 3000.0 * (0.25 - 0.05 - 0.002 * motion.turning), 1e-3);
}

TEST(Motors, AreCutAtFullDuty) {
  World full(test::plain_mouse()), over(test::plain_mouse());
  EXPECT_EQ(full.after(300, 1.0, 1.0).speed, over.after(300, 7.0, 1.5).speed);
}

TEST(Motors, DifferAsTheContestDrewThem) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.motor_gain = 0.1;
  World world(hardware, {}, 3);
  const auto& [left, right] = world.robot_sample().motor;
  ASSERT_GT(std::abs(right - left), 0.02);
  const BodyMotion& motion = world.after(3000, 0.3, 0.3);
  EXPECT_NEAR(motion.speed, 3000.0 * (0.3 * (left + right) / 2.0 - 0.05), 1e-3);
}

TEST(Slip, IsLateralAccelerationOverStiffness) {
  World world(test::plain_mouse());
  for (const double turning : {3.0, 11.0, -7.0}) {
    const BodyMotion& motion = world.hold(1000, 330.0, turning);
    EXPECT_NEAR(motion.slip, -motion.speed * motion.yaw / 100000.0, 1e-4 * std::abs(motion.slip)) << turning;
    EXPECT_NEAR(motion.sideways, motion.speed * motion.yaw, 1e-4 * std::abs(motion.sideways)) << turning;
  }
}

TEST(Slip, ComesAndGoesWithSpeedOverStiffness) {
  World world(test::plain_mouse());
  world.hold(1000, 500.0, 0.0);
  // Turned at once, as by the floor, it goes on as before and comes round: the slip dies away.
  world.plant().graze(world.plant().motion().position, 0.0, 1.0);
  double slip = 0.0;
  for (int tick = 0; tick < 60; ++tick) {
    const BodyMotion& motion = world.hold(1, 500.0, 8.0);
    // Semi-implicitly: (slip - yaw dt) / (1 + K dt / v).
    slip = (slip - motion.yaw * 0.001) / (1.0 + 100000.0 * 0.001 / motion.speed);
    ASSERT_NEAR(motion.slip, slip, 1e-12) << tick;
  }
}

TEST(Slip, GoesOutwardsAndDoesNotWidenASteadyCircle) {
  World world(test::plain_mouse());
  world.hold(1000, 400.0, 8.0);
  double west = 1e9, east = -1e9, south = 1e9, north = -1e9;
  for (int tick = 0; tick < 2000; ++tick) {
    const Position at = world.hold(1, 400.0, 8.0).position;
    west = std::min(west, at.x);
    east = std::max(east, at.x);
    south = std::min(south, at.y);
    north = std::max(north, at.y);
  }
  EXPECT_LT(world.plant().motion().slip, 0.0) << "a mouse that turns to the left goes to the right of where it points";
  EXPECT_NEAR(east - west, 2.0 * 400.0 / 8.0, 0.02);
  EXPECT_NEAR(north - south, 2.0 * 400.0 / 8.0, 0.02);
}

TEST(Tyres, HoldTheCircleThatTheirGripAllows) {
  World world(test::plain_mouse());
  // 600 mm/s at 20 rad/s would need 12 m/s²; they hold 10.
  world.hold(600, 600.0, 0.0);
  for (int tick = 0; tick < 200; ++tick) {
    const BodyMotion& motion = world.hold(1, 600.0, 20.0);
    if (world.plant().slides()) {
      EXPECT_NEAR(std::hypot(motion.sideways, motion.speeding), 10000.0, 1e-6);
    }
  }
  EXPECT_TRUE(world.plant().slides());
  EXPECT_LT(world.plant().motion().slip, -0.1) << "it no longer goes where it points";
}

TEST(Tyres, HoldLessAsideWhereTheyBrake) {
  World world(test::plain_mouse());
  world.hold(600, 600.0, 0.0);
  double most = 0.0;
  bool slid = false;
  for (int tick = 0; tick < 60; ++tick) {
    const BodyMotion& motion = world.after(1, -0.35, 0.15);
    ASSERT_LE(std::hypot(motion.sideways, motion.speeding), 10000.0 * (1.0 + 1e-9)) << tick;
    slid = slid || world.plant().slides();
    most = std::max(most, std::abs(motion.speeding));
  }
  EXPECT_TRUE(slid);
  EXPECT_GT(most, 4000.0);
}

TEST(Tyres, PushNoHarderThanTheirGrip) {
  World world(test::plain_mouse());
  double before = 0.0;
  for (int tick = 0; tick < 60; ++tick) {
    const double speed = world.after(1, 1.0, 1.0).speed;
    ASSERT_LE(speed - before, 10.0 + 1e-9) << tick;
    before = speed;
  }
  EXPECT_NEAR(before, 600.0, 1.0);
}

/// The wheels turn faster than the mouse drives: what the tyres do not hold of the motors' torque turns them, whose
/// share of the inertia is r. Their speed approaches `last` - (1 - r) grip time with the time constant r time.
TEST(Wheels, SpinAsTheExponentialWhereTheTyresDoNotHold) {
  Hardware hardware = test::plain_mouse();
  hardware.motors.drive.dead_zone = 0.0;
  hardware.motors.rotating = 0.2;
  World world(hardware);
  const double grip = 10'000.0, time = 0.1, share = 0.2, last = 3000.0;
  const double end = last - (1.0 - share) * grip * time;
  for (int tick = 1; tick <= 100; ++tick) {
    const BodyMotion& motion = world.after(1, 1.0, 1.0);
    ASSERT_NEAR(motion.speed, grip * 0.001 * tick, 1e-6) << tick;
    // The motor steps by an exact exponential, the wheels by Euler's method: 2.5 % of the way at most.
    ASSERT_NEAR(motion.rolling, end * (1.0 - std::exp(-0.001 * tick / (share * time))), 0.025 * end) << tick;
  }
}

TEST(Wheels, HoldAgainWhenTheMouseIsAsFast) {
  Hardware hardware = test::plain_mouse();
  hardware.motors.rotating = 0.2;
  World world(hardware);
  ASSERT_GT(world.after(50, 1.0, 1.0).rolling, 1.5 * world.plant().motion().speed);
  const BodyMotion& motion = world.after(1500, 0.25, 0.25);
  EXPECT_EQ(motion.rolling, motion.speed);
  EXPECT_NEAR(motion.speed, 3000.0 * (0.25 - 0.05), 0.1);
  // They slide in the same way when it brakes.
  world.after(20, -1.0, -1.0);
  EXPECT_LT(motion.rolling, motion.speed);
  EXPECT_NEAR(motion.speeding, -10'000.0, 1e-6);
}

TEST(Wheels, NeverSpinWithoutInertiaOfTheirOwn) {
  World world(test::plain_mouse());
  for (int tick = 0; tick < 200; ++tick) {
    const BodyMotion& motion = world.after(1, 1.0, 1.0);
    ASSERT_EQ(motion.rolling, motion.speed);
  }
}

/// In a steady turn the moment takes time * moment * lateral acceleration from the yaw speed that the motors ask for.
TEST(Tyres, TurnTheMouseBack) {
  Hardware hardware = test::plain_mouse();
  hardware.tyres.yaw_moment = 0.005;
  World world(hardware);
  const BodyMotion& motion = world.hold(3000, 330.0, 9.0);
  EXPECT_NEAR(motion.turning, 9.0 / (1.0 + 0.08 * 0.005 * motion.speed), 0.01);
  EXPECT_LT(motion.turning, 8.5);
}

TEST(Motors, DriveByTheirOwnStrength) {
  Hardware hardware = test::plain_mouse();
  hardware.motors.drive.dead_zone = hardware.motors.turn.dead_zone = 0.0;
  hardware.motors.strength = {0.9, 1.2};
  World world(hardware);
  const BodyMotion& motion = world.after(2000, 0.1, 0.1);
  EXPECT_NEAR(motion.speed, 3000.0 * 0.1 * 1.05, 1e-3);
  EXPECT_NEAR(motion.turning, 80.0 * 0.1 * 0.3, 1e-6);
  EXPECT_NEAR(world.after(2000, 0.12, 0.09).turning, 0.0, 1e-6);
}

TEST(Motors, LoseTheDeadTimeOfTheirDriver) {
  Hardware hardware = test::plain_mouse();
  hardware.motors.drive.dead_zone = 0.0;
  hardware.motors.dead_time = 0.04;
  World world(hardware);
  EXPECT_EQ(world.after(100, 0.04, 0.04).speed, 0.0);
  EXPECT_NEAR(world.after(3000, 0.24, 0.24).speed, 3000.0 * 0.2, 1e-3);
  EXPECT_NEAR(world.after(3000, -0.24, -0.24).speed, -3000.0 * 0.2, 1e-3);
}

/// At a share d of the time they are driven: the speed approaches the highest one with the time constant over d.
TEST(Motors, CoastWhileTheirDriverIsOff) {
  Hardware hardware = test::plain_mouse();
  hardware.motors.drive.dead_zone = 0.0;
  hardware.motors.coast = 1.0;
  World world(hardware);
  for (int tick = 1; tick <= 400; ++tick)
    ASSERT_NEAR(world.after(1, 0.2, 0.2).speed, 3000.0 * (1.0 - std::exp(-0.2 * tick * 0.001 / 0.1)), 5.0) << tick;
  const double speed = world.after(0, 0.0, 0.0).speed;
  EXPECT_NEAR(world.after(500, 0.0, 0.0).speed, speed, 1e-9);
  // A duty in the other direction brakes with the voltage of both the battery and the motor.
  EXPECT_NEAR(world.after(1, -0.2, -0.2).speed - speed, -0.2 * (3000.0 + speed) * 0.01, 0.5);
}

TEST(Motors, AreDrivenByTheDutyForAnEffect) {
  Rng rng(11);
  const auto any = [&](double low, double high) { return low + (high - low) * rng.below(1 << 20) / (1 << 20); };
  for (int i = 0; i < 1000; ++i) {
    Motors motors = test::plain_mouse().motors;
    motors.dead_time = any(0.0, 0.1);
    motors.coast = i % 2;
    const double strength = any(0.8, 1.3), voltage = any(0.8, 1.0), idle = any(-0.5, 0.5), braked = any(-0.5, 0.5);
    const double duty = duty_for(motors, braked, strength, 1.0 / voltage, idle);
    EXPECT_NEAR(braked_duty(motors, duty, strength, voltage, idle), braked, 1e-12) << i;
  }
}

TEST(Battery, LosesAShareASecondAtFullDuty) {
  Hardware hardware = test::plain_mouse();
  hardware.motors.discharge = 0.01;
  World world(hardware);
  world.after(1000, 0.5, -0.5);
  EXPECT_NEAR(world.plant().voltage(), 1.0 - 0.01 * 0.5, 1e-9);
  world.after(1000, 0.0, 0.0);
  EXPECT_NEAR(world.plant().voltage(), 1.0 - 0.01 * 0.5, 1e-9);
  world.plant().put({3250.0, 3250.0}, 0.0);
  EXPECT_NEAR(world.plant().voltage(), 1.0 - 0.01 * 0.5, 1e-9) << "it is the same battery";
}

TEST(Battery, BeginsWithWhatTheContestDrewAndSags) {
  Hardware hardware = test::plain_mouse();
  hardware.motors.sag = 0.1;
  hardware.variation.battery = 0.1;
  World world(hardware, {}, 3);
  const double full = world.robot_sample().battery;
  ASSERT_LT(full, 0.99);
  EXPECT_EQ(world.plant().voltage(), full);
  const double duty = 0.25;
  EXPECT_NEAR(world.after(3000, duty, duty).speed, 3000.0 * (duty * full * (1.0 - 0.1 * duty) - 0.05), 1e-3);
}

TEST(Fan, AddsGripWhileItRuns) {
  Hardware hardware = test::plain_mouse();
  hardware.tyres.downforce = 5000.0;
  World world(hardware);
  world.plant().set_fan(true);
  EXPECT_NEAR(world.after(40, 1.0, 1.0).speeding, 15'000.0, 1e-6);
  world.plant().set_fan(false);
  EXPECT_NEAR(world.after(1, 1.0, 1.0).speeding, 10'000.0, 1e-6);
}

TEST(Dust, TakesGripInItsCell) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.dust = 0.3;
  World world(hardware, {}, 2);
  const double grip = world.robot_sample().floor({32, 32}).grip;
  ASSERT_LT(grip, 0.95);
  EXPECT_NEAR(world.after(10, 1.0, 1.0).speeding, 10'000.0 * grip, 1e-6);
}

/// Downhill by a slope s, a mouse whose motors hold its speed gains g s time; across it, the tyres hold g s.
TEST(Slope, PullsAMouse) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.floor_tilt = 0.01;
  World world(hardware, {}, 9);
  const Position slope = world.robot_sample().floor({32, 32}).slope;
  ASSERT_GT(std::abs(slope.x), 0.0015);
  ASSERT_GT(std::abs(slope.y), 0.002);
  for (int tick = 0; tick < 2000; ++tick) {
    world.hold(1, 300.0, 0.0);
    world.plant().graze({3250.0, 3250.0}, 0.0, 1.0);
  }
  // Ten ticks from the middle of the cell on: a graze ends the slip.
  const BodyMotion& motion = world.hold(10, 300.0, 0.0);
  EXPECT_NEAR(motion.speed, 300.0 - 9810.0 * slope.x * 0.1, 0.02 * 9810.0 * 0.1 * std::abs(slope.x) + 0.5);
  EXPECT_NEAR(motion.sideways, 9810.0 * slope.y, 0.1 * 9810.0 * std::abs(slope.y));
}

TEST(Slope, LeavesAMouseThatStands) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.floor_tilt = 0.05;
  World world(hardware, {}, 6);
  const BodyMotion& motion = world.after(500, 0.0, 0.0);
  EXPECT_EQ(motion.speed, 0.0);
  EXPECT_EQ(motion.position.x, 3250.0);
}

TEST(Tyres, AreAsStiffAndHoldAsMuchAsTheContestDrew) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.stiffness = 0.2;
  World world(hardware, {}, 5);
  ASSERT_GT(std::abs(world.robot_sample().stiffness - 1.0), 0.03);
  const BodyMotion& motion = world.hold(1000, 330.0, 9.0);
  EXPECT_NEAR(motion.slip, -motion.speed * motion.yaw / (100000.0 * world.robot_sample().stiffness), 1e-6);
}

TEST(Plant, DrivesTheArcThatItsSpeedsSay) {
  World world(test::plain_mouse());
  world.hold(2000, 300.0, 0.0);
  const BodyMotion before = world.plant().motion();
  const BodyMotion& after = world.hold(1000, 300.0, 0.0);
  EXPECT_NEAR(after.position.x - before.position.x, 300.0, 1e-3);
  EXPECT_NEAR(after.position.y - before.position.y, 0.0, 1e-9);
  const double angle = after.angle;
  EXPECT_NEAR(world.hold(1000, 300.0, 2.0).angle - angle, 2.0, 0.08 * 2.0 * 1.3) << "after its motors have come up";
  EXPECT_NEAR(std::remainder(std::atan2(after.ahead.sine, after.ahead.cosine) - after.angle, 2.0 * pi), 0.0, 1e-9);
}

TEST(Shaking, HasTheDeviationAndThePitchOfTheNoise) {
  Hardware hardware = test::plain_mouse();
  hardware.noise = test::plain_noise();
  World world(hardware, test::only(ErrorCause::shaking), 11);
  world.hold(2000, 400.0, 0.0);
  constexpr int ticks = 200'000;
  double squares = 0.0, steps = 0.0, before = 0.0;
  for (int tick = 0; tick < ticks; ++tick) {
    // Round and round: the hall is not long enough.
    if (tick % 1000 == 0) {
      const BodyMotion motion = world.plant().motion();
      world.plant().graze({3250.0, 3250.0}, 0.0, 1.0);
      ASSERT_EQ(world.plant().motion().speed, motion.speed);
    }
    const BodyMotion& motion = world.hold(1, 400.0, 0.0);
    const double shaking = motion.yaw - motion.turning;
    squares += shaking * shaking;
    steps += square(shaking - before);
    before = shaking;
  }
  EXPECT_NEAR(std::sqrt(squares / ticks), 0.25, 0.02);
  // Of an oscillator its rate's deviation is the pitch times that of its place.
  EXPECT_NEAR(std::sqrt(steps / squares) * 1000.0, 200.0, 15.0);
}

TEST(Shaking, FallsWithTheSpeedBelowItsSpeed) {
  Hardware hardware = test::plain_mouse();
  hardware.noise = test::plain_noise();
  World slow(hardware, test::only(ErrorCause::shaking), 11), fast(hardware, test::only(ErrorCause::shaking), 11);
  for (int tick = 0; tick < 1000; ++tick) {
    slow.hold(1, 60.0, 0.0);
    fast.hold(1, 300.0, 0.0);
  }
  for (int tick = 0; tick < 200; ++tick) {
    const BodyMotion &a = slow.hold(1, 60.0, 0.0), &b = fast.hold(1, 300.0, 0.0);
    ASSERT_NEAR(a.yaw - a.turning, (b.yaw - b.turning) * a.speed / b.speed, 1e-9);
  }
  EXPECT_EQ(World(hardware, test::only(ErrorCause::shaking), 11).after(100, 0.0, 0.0).yaw, 0.0);
}

TEST(Floor, TurnsAndShiftsAMouseWhereItHasAStep) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.floor_steps = 1.0;
  hardware.variation.floor_turn = 0.02;
  hardware.variation.floor_shift = 1.0;
  World world(hardware, {}, 4);
  world.plant().put({3299.0, 3250.0}, 0.0);
  const FloorStep step = world.robot_sample().floor_step({{32, 32}, Heading::east});
  ASSERT_NE(step.turn, 0.0);
  while (world.hold(1, 300.0, 0.0).position.x < 3300.0) {
  }
  EXPECT_NEAR(world.plant().motion().angle, step.turn, 1e-12);
  EXPECT_NEAR(world.plant().motion().position.y - 3250.0, step.shift, 1e-3);
  // Back over it, as one who comes the other way meets it: it is turned back.
  world.plant().put({3301.0, 3250.0}, pi);
  while (world.hold(1, 300.0, 0.0).position.x >= 3300.0) {
  }
  EXPECT_NEAR(world.plant().motion().angle, pi - step.turn, 1e-12);
  EXPECT_NEAR(world.plant().motion().position.y - 3250.0, step.shift, 1e-3);
}

}  // namespace
}  // namespace labmouse
