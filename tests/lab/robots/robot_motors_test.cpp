// The motors of built-in robots against what their logs and authors say; and variation under its former names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "labmouse/body/plant.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {
namespace {

constexpr double pi = 3.14159265358979;

/// Speed and yaw rate after one and a half seconds under these duties, without noise.
BodyMotion steady(const std::string& robot, double left, double right) {
  const Robot built = find_robot(robot).model.robot;
  const Maze maze = empty_generator.make({.size = {64, 64}});
  const Field field(maze, built.cell);
  const RobotSample sample(*built.hardware, no_errors, maze.size(), 1);
  Plant plant(field, *built.hardware, sample, 1);
  plant.put({32.0 * built.cell, 32.0 * built.cell}, 0.0);
  for (int tick = 0; tick < 1500; ++tick) plant.step({static_cast<float>(left), static_cast<float>(right)});
  return plant.motion();
}

TEST(RobotMotors, OfKeriseNeedTheDutyOfItsLogs) {
  // Logs of 2021 (kerikun11, v4c) hold 600 mm/s with a duty of 0.106 to 0.122. The fit over all speeds is a little
  // slower.
  EXPECT_LT(steady("kerise", 0.100, 0.100).speed, 600.0);
  EXPECT_GT(steady("kerise", 0.155, 0.155).speed, 600.0);
  EXPECT_GT(steady("kerise", 0.02, 0.02).speed, 0.0) << "the logs show no dead zone";
}

TEST(RobotMotors, OfTheBeginnerTurnAtFullDutyAsItsAuthorMeasured) {
  // 775 degrees a second for each volt, one motor forwards and the other backwards, at 7 V.
  const double measured = 775.0 * 7.0 * pi / 180.0;
  const BodyMotion turning = steady("beginner", -1.0, 1.0);
  EXPECT_NEAR(turning.turning, measured, 0.15 * measured);
  // So fast do its wheels run, over half of its track.
  EXPECT_NEAR(turning.turning * 37.95, steady("beginner", 1.0, 1.0).speed, 0.15 * 3300.0);
}

/// Files of earlier versions have the first numbers of [variation] in [noise], and none of the others.
TEST(RobotVariation, IsReadByItsFormerNames) {
  const std::string text = R"(
[noise]
gyro_bias = 0.002
ripple = 0.1
ripple_length = 12.57
encoder = 0.015
gyro = 0.003
gyro_walk = 0.0003
acceleration = 350
infrared = 3
infrared_share = 0.005
infrared_memory = 0.4
ranger_rest = 1.4
ranger = 3
shaking = 0.38
shaking_speed = 300
shaking_pitch = 16
shaking_loss = 0.25
)";
  const auto builtin = std::find_if(builtin_robots().begin(), builtin_robots().end(),
                                    [](const BuiltinRobot& robot) { return robot.name == "kerise"; });
  ASSERT_NE(builtin, builtin_robots().end());
  const std::string whole(builtin->text), before = whole.substr(0, whole.find("[noise]"));
  const std::string former = R"(motor_gain = 0.1
slip_stiffness = 0.2
grip = 0.11
encoder_scale = 0.01
gyro_scale = 0.005
infrared_gain = 0.03
reflectance = 0.05
floor_steps = 0.04
floor_turn = 0.0105
floor_shift = 0.5
placement = 1
placement_turn = 0.0175
)";
  const RobotResult earlier = read_robot(before + text + former, "mine"),
                    now = read_robot(before + text + "[variation]\n" + former, "mine");
  ASSERT_TRUE(earlier.robot) << earlier.problems.front().reason;
  ASSERT_TRUE(now.robot) << now.problems.front().reason;
  EXPECT_EQ(*earlier.robot->hardware, *now.robot->hardware);
  EXPECT_EQ(earlier.robot->hardware->variation.grip, 0.11);
  EXPECT_EQ(earlier.robot->hardware->variation.dust, 0.0);
  const RobotResult none = read_robot(before + text, "mine");
  EXPECT_FALSE(none.robot);
  const RobotResult both = read_robot(before + text + "grip = 0.2\n[variation]\n" + former, "mine");
  ASSERT_EQ(both.problems.size(), 1U);
  EXPECT_NE(both.problems.front().reason.find("'noise.grip'"), std::string::npos);
  EXPECT_NE(both.problems.front().reason.find("'variation.grip'"), std::string::npos);
}

}  // namespace
}  // namespace labmouse
