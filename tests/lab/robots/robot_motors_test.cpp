// The motors of built-in robots against what their logs and authors say.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "labmouse/body/plant.hpp"
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

}  // namespace
}  // namespace labmouse
