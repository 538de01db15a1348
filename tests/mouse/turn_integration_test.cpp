// Turns of robots with limits: that their tables say what driving them in small steps does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "tests/mouse/drive_robots.hpp"
#include "tests/mouse/robot_parameters.hpp"
#include "tests/mouse/turns_in_steps.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::builtin;
using test::clearance_of;
using test::Course;
using test::courses;
using test::drives;
using test::endless;
using test::fine;
using test::largest_speed;
using test::Layout;
using test::leads_of;
using test::Moment;
using test::Point;
using test::PrintRobot;
using test::top_speed;
using test::towards;
using test::turns_of;
using test::TurnsInSteps;

TEST_P(TurnsInSteps, AreThoseThatTheRobotDrives) {
  LABMOUSE_SKIP_SANITIZED();
  for (const Course& course : courses)
    for (const Turn turn : {course.turn, course.back})
      EXPECT_EQ(turns_of(tables(), turn).empty(), !drives(robot(), course)) << name_of(turn);
}

TEST_P(TurnsInSteps, AreLaidOutForTheSpeedOfTheTables) {
  LABMOUSE_SKIP_SANITIZED();
  for_each_turn([](const Course& course, const Layout& layout, const std::vector<DrivenTurn>& turns) {
    const double own = std::min(layout.speed, top_speed(course, robot()));
    // With one speed of each turn they share the slowest one's.
    if (robot().speeds > 1)
      EXPECT_NEAR(largest_speed(turns), own, 1e-6 * own);
    else
      EXPECT_LE(largest_speed(turns), own * (1.0 + 1e-6));
    EXPECT_GE(clearance_of(course, layout, robot().cell), robot().clearance - 1e-3);
  });
}

TEST_P(TurnsInSteps, EndOnTheirNodesWithTheLeadsOfTheTables) {
  LABMOUSE_SKIP_SANITIZED();
  for_each_turn([&](const Course& course, const Layout& layout, const std::vector<DrivenTurn>& turns) {
    for (const DrivenTurn& turn : turns) {
      const auto [before, after] = leads_of(tables(), course, turn);
      const Point end = robot().cell * course.first + before * towards(course.heading) + layout.moments.back().place +
                        after * towards(course.last_heading);
      EXPECT_NEAR(end.x, robot().cell * course.last.x, 1e-4);
      EXPECT_NEAR(end.y, robot().cell * course.last.y, 1e-4);
      EXPECT_NEAR(layout.moments.back().angle, course.last_heading * std::numbers::pi / 180.0, 1e-9);
      EXPECT_NEAR(before, layout.before, 1e-4);
      EXPECT_NEAR(after, layout.after, 1e-4);
      EXPECT_GE(std::min(before, after), 0.0);
    }
  });
}

/// What the steps ask for, by differences.
TEST_P(TurnsInSteps, KeepEveryLimit) {
  LABMOUSE_SKIP_SANITIZED();
  const double yaw_speed = robot().yaw_speed > 0.0 ? robot().yaw_speed : endless;
  const double yaw_jerk = robot().yaw_jerk > 0.0 ? robot().yaw_jerk : endless;
  for_each_turn([&](const Course&, const Layout& layout, const std::vector<DrivenTurn>&) {
    constexpr double slack = 1.0 + 1e-6, noise = 1e-3;
    double acceleration = 0.0;
    for (std::size_t i = 1; i < layout.moments.size(); ++i) {
      const Moment &last = layout.moments[i - 1], &now = layout.moments[i];
      const double time = now.seconds - last.seconds;
      if (time < fine.step / 100.0) continue;
      const double before = std::exchange(acceleration, (now.rate - last.rate) / time);
      ASSERT_LE(now.rate * layout.speed, robot().lateral_acceleration * slack);
      ASSERT_LE(now.rate, yaw_speed * slack);
      ASSERT_LE(std::abs(acceleration), robot().yaw_acceleration * slack);
      ASSERT_LE(std::abs(acceleration - before), yaw_jerk * fine.step * slack + noise);
    }
  });
}

TEST_P(TurnsInSteps, TakeTheTimesOfTheTablesAtEachSpeed) {
  LABMOUSE_SKIP_SANITIZED();
  if (robot().grip > 0.0) return;  // its speed changes in curves
  for_each_turn([](const Course&, const Layout& layout, const std::vector<DrivenTurn>& turns) {
    for (const DrivenTurn& turn : turns) {
      EXPECT_EQ(turn.speed, turn.end_speed);
      EXPECT_NEAR(turn.time, layout.moments.back().seconds * layout.speed / turn.speed * 1e6, 0.6) << turn.speed;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(
    Robots, TurnsInSteps,
    testing::Values(builtin("beginner"), builtin("classic"), builtin("half"), builtin("kerise"), small_robot(),
                    large_robot(), fan_robot(), jerk_robot(), large_jerk_robot(), grip_robot(), small_grip_robot(),
                    unstopped_robot(), square_robot(), slow_robot(), strong_robot(), slow_to_turn(), smooth_robot(),
                    slow_on_diagonals(), robot_of_speeds<1>(), robot_of_speeds<8>(),
                    with_profile(large_robot(), TurnProfile::sine), with_profile(slow_to_turn(), TurnProfile::sine),
                    with_profile(large_jerk_robot(), TurnProfile::sine),
                    with_profile(small_robot(), TurnProfile::cubic), with_profile(smooth_robot(), TurnProfile::cubic)),
    PrintRobot());

}  // namespace
}  // namespace labmouse
