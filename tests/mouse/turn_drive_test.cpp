// How turns are driven by robots whose tyres share their grip between curves and speed.
#include "labmouse/mouse/robot/turn_drive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;

/// The curvature of a path by differences of its direction, rad/mm.
double curvature_at(const TurnShape& shape, double distance) {
  constexpr double reach = 1e-3;
  const double from = std::max(0.0, distance - reach), to = std::min(shape.length, distance + reach);
  return (shape.at(shape.lead_in + to).angle - shape.at(shape.lead_in + from).angle) / (to - from);
}

class GripOf : public testing::TestWithParam<Robot> {};

INSTANTIATE_TEST_SUITE_P(Robots, GripOf,
                         testing::Values(grip_robot(), small_grip_robot(),
                                         with_profile(grip_robot(), TurnProfile::cubic),
                                         with_profile(small_grip_robot(), TurnProfile::sine),
                                         with_profile(grip_robot(), TurnProfile::free),
                                         with_profile(small_grip_robot(), TurnProfile::free)),
                         [](const auto& robot) { return robot.param.name; });

TEST_P(GripOf, ItsTyresIsNeverAskedForMore) {
  const Robot& robot = GetParam();
  const DriveModel model = make_drive_model(robot);
  ASSERT_EQ(model.error, "");
  int changing = 0;
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    const DrivenTurn& turn = model.tables.turns[i];
    const TurnShape& shape = model.shapes[i];
    const double top = std::find_if(model.tables.turns.begin(), model.tables.turns.end(), [&](const DrivenTurn& other) {
                         return other.turn == turn.turn;
                       })->speed;
    const auto drive = turn_drive(shape, turn.speed, turn.end_speed, top, robot);
    ASSERT_TRUE(drive);
    changing += turn.speed != turn.end_speed ? 1 : 0;
    EXPECT_NEAR(drive->speeds.front(), turn.speed, 1e-6);
    EXPECT_NEAR(drive->speeds.back(), turn.end_speed, 1e-6);
    const double step = shape.length / TurnDrive::steps;
    double seconds = 0.0, yaw_rate = 0.0;
    for (std::size_t k = 0; k < TurnDrive::steps; ++k) {
      const double from = drive->speeds[k], to = drive->speeds[k + 1];
      const double forward = (to * to - from * from) / (2.0 * step), time = 2.0 * step / (from + to);
      const double middle = curvature_at(shape, (static_cast<double>(k) + 0.5) * step);
      const double lateral = (from * from + to * to) / 2.0 * middle;
      ASSERT_LE(std::sqrt(forward * forward + lateral * lateral), robot.grip * 1.001);
      ASSERT_LE(std::abs(lateral), robot.lateral_acceleration * 1.001);
      ASSERT_LE(forward, robot.acceleration * 1.001);
      ASSERT_GE(forward, -robot.braking * 1.001);
      const double after = to * curvature_at(shape, static_cast<double>(k + 1) * step);
      ASSERT_LE(std::abs(after - yaw_rate) / time, robot.yaw_acceleration * 1.01);
      yaw_rate = after;
      seconds += time;
    }
    EXPECT_NEAR(turn.time, seconds * 1e6, 1.0);
    // A turn of free shape may be slower within than at both ends.
    if (robot.profile != TurnProfile::free) {
      EXPECT_LE(turn.time, shape.length / std::min(turn.speed, turn.end_speed) * 1e6 + 1.0);
    }
  }
  EXPECT_GT(changing, 20);
}

TEST(Grip, IsAtLeastEveryOtherAcceleration) {
  Robot robot = grip_robot();
  robot.grip = 9'900.0;
  EXPECT_THAT(make_drive_model(robot).error, Says("grip", "9900 mm/s", "10000 mm/s"));
  robot = grip_robot();
  robot.yaw_jerk = 9000.0;
  EXPECT_THAT(make_drive_model(robot).error, Says("yaw jerk", "grip"));
}

TEST(Grip, ThatTheCurveTakesWholeChangesNoSpeedInItsArc) {
  Robot robot = large_robot();
  robot.grip = robot.lateral_acceleration;
  const DriveModel model = make_drive_model(robot);
  ASSERT_EQ(model.error, "");
  // At its own speed from beginning to end a turn takes as long as without.
  const DriveModel without = make_drive_model(large_robot());
  EXPECT_NEAR(model.tables.turns.front().time, without.tables.turns.front().time, 1.0);
}

}  // namespace
}  // namespace labmouse
