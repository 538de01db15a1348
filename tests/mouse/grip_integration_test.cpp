// Turns of robots whose speed changes in them: that their tables say what driving them in small steps does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "tests/mouse/drive_robots.hpp"
#include "tests/mouse/robot_parameters.hpp"
#include "tests/mouse/turns_in_steps.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::Course;
using test::endless;
using test::largest_speed;
using test::Layout;
using test::PrintRobot;
using test::TurnsInSteps;

/// A curve in many short steps, each of one length.
struct Bends {
  double step = 0.0;              ///< mm
  std::vector<double> curvature;  ///< rad/mm in the middle of each
  std::vector<double> growth;     ///< rad/mm² in it
};

Bends bends_of(const Layout& layout, std::size_t steps) {
  Bends bends{layout.length() / static_cast<double>(steps), {}, {}};
  std::size_t phase = 0;
  double rate = 0.0, passed = 0.0;
  const auto ends = [&](double time) { return time > passed + layout.phases[phase].seconds; };
  for (std::size_t i = 0; i < steps; ++i) {
    const double time = (static_cast<double>(i) + 0.5) * bends.step / layout.speed;
    for (; phase + 1 < layout.phases.size() && ends(time); ++phase) {
      const auto& [acceleration, jerk, seconds] = layout.phases[phase];
      rate += (acceleration + jerk * seconds / 2.0) * seconds;
      passed += seconds;
    }
    const auto& [acceleration, jerk, seconds] = layout.phases[phase];
    const double within = time - passed;
    bends.curvature.push_back((rate + (acceleration + jerk * within / 2.0) * within) / layout.speed);
    bends.growth.push_back((acceleration + jerk * within) / (layout.speed * layout.speed));
  }
  return bends;
}

/// What is left for speeding up at the square of a speed: grip is shared, and the yaw rate, v times the curvature, may
/// grow only so fast.
double left_over(double square, double curvature, double growth, double own, const Robot& robot) {
  const double lateral = square * curvature;
  const double grip = std::sqrt(std::max(0.0, robot.grip * robot.grip - lateral * lateral));
  const double yaw = curvature > 0.0 ? (robot.yaw_acceleration - square * growth) / curvature : endless;
  return std::max(0.0, std::min({own, grip, yaw}));
}

/// Squares of the speeds at the ends of all steps, as fast as allowed from the first on.
std::vector<double> speeding_up(const Bends& bends, double from, double top, double own, const Robot& robot) {
  std::vector<double> squares = {from * from};
  for (std::size_t i = 0; i < bends.curvature.size(); ++i) {
    const auto gain = [&](double square) {
      return 2.0 * bends.step * left_over(square, bends.curvature[i], bends.growth[i], own, robot);
    };
    const double here = squares.back();
    squares.push_back(std::min(top * top, here + gain(here + gain(here) / 2.0)));
  }
  return squares;
}

/// The least time over a curve from one speed to another.
double least_seconds(const std::vector<double>& up, const std::vector<double>& down, double step) {
  double seconds = 0.0, last = 0.0;
  for (std::size_t i = 0; i < up.size(); ++i) {
    const double speed = std::sqrt(std::min(up[i], down[up.size() - 1 - i]));
    if (i > 0) seconds += 2.0 * step / (last + speed);
    last = speed;
  }
  return seconds;
}

using GripInSteps = TurnsInSteps;

/// The tables are made of 128 steps, in each of which the robot keeps to what is allowed all along it: they may say a
/// little more than the least time (0.2 % at most, measured), and never less.
TEST_P(GripInSteps, TakesTheLeastTimeBetweenItsSpeeds) {
  LABMOUSE_SKIP_SANITIZED();
  for_each_turn([](const Course& course, const Layout& layout, const std::vector<DrivenTurn>& turns) {
    const bool diagonal = course.from_diagonal() || course.to_diagonal();
    const double up = std::min(robot().acceleration, diagonal ? robot().acceleration_diagonal : endless);
    const double down = std::min(robot().braking, diagonal ? robot().braking_diagonal : endless);
    const double top = largest_speed(turns);
    const Bends bends = bends_of(layout, 10'000);
    for (const DrivenTurn& turn : turns) {
      // The curve is the same from its end: braking along it is speeding up there.
      const auto ahead = speeding_up(bends, turn.speed, top, up, robot());
      const auto behind = speeding_up(bends, turn.end_speed, top, down, robot());
      ASSERT_GE(ahead.back(), turn.end_speed * turn.end_speed * (1.0 - 1e-6));
      ASSERT_GE(behind.back(), turn.speed * turn.speed * (1.0 - 1e-6));
      const double least = least_seconds(ahead, behind, bends.step) * 1e6;
      EXPECT_GE(turn.time, least - 0.6) << turn.speed << " to " << turn.end_speed;
      EXPECT_LE(turn.time, least * 1.003) << turn.speed << " to " << turn.end_speed;
    }
  });
}

TEST_P(GripInSteps, ReachesEachSpeedThatItCan) {
  for_each_turn([&](const Course& course, const Layout& layout, const std::vector<DrivenTurn>& turns) {
    const bool diagonal = course.from_diagonal() || course.to_diagonal();
    const double up = std::min(robot().acceleration, diagonal ? robot().acceleration_diagonal : endless);
    const double down = std::min(robot().braking, diagonal ? robot().braking_diagonal : endless);
    const Bends bends = bends_of(layout, 10'000);
    std::set<double> speeds;
    for (const DrivenTurn& turn : turns) speeds.insert(turn.speed);
    for (const double from : speeds)
      for (const double to : speeds) {
        const double reached = from < to ? std::sqrt(speeding_up(bends, from, *speeds.rbegin(), up, robot()).back())
                                         : std::sqrt(speeding_up(bends, to, *speeds.rbegin(), down, robot()).back());
        const bool listed = std::any_of(turns.begin(), turns.end(), [&](const DrivenTurn& turn) {
          return turn.speed == from && turn.end_speed == to;
        });
        if (std::abs(reached / std::max(from, to) - 1.0) < 0.01 && from != to) continue;  // a matter of steps
        EXPECT_EQ(listed, reached >= std::max(from, to) * (1.0 - 1e-9)) << from << " to " << to;
      }
  });
}

/// One that cannot reach each of its speeds within a turn.
Robot weak_grip_robot() {
  Robot robot = grip_robot();
  robot.name = "weak_grip";
  robot.acceleration = robot.acceleration_diagonal = 2000.0;
  robot.braking = robot.braking_diagonal = 3000.0;
  return robot;
}

INSTANTIATE_TEST_SUITE_P(Robots, GripInSteps,
                         testing::Values(grip_robot(), small_grip_robot(), weak_grip_robot(),
                                         with_profile(grip_robot(), TurnProfile::sine),
                                         with_profile(small_grip_robot(), TurnProfile::cubic)),
                         PrintRobot());

}  // namespace
}  // namespace labmouse
