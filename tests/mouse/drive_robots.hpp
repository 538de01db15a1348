// Robots for tests.
#pragma once

#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// The published parameters of a library of 2021, in cells of 90 mm.
inline Robot published_robot() {
  Robot robot;
  robot.name = "published";
  robot.cell = 90.0;
  robot.speed = 1500.0;
  robot.acceleration = robot.braking = 4200.0;
  robot.speed_diagonal = 1200.0;
  robot.acceleration_diagonal = robot.braking_diagonal = 3600.0;
  robot.fixed = FixedTimes{420.0, 257'000, 375'000, 465'000, 563'000, 388'000, 280'000};
  robot.search = {300'000, 237'000, 3'000'000, 1'500'000, 300'000};
  return robot;
}

/// A robot of the half-size contest, whose turns follow from its limits.
inline Robot small_robot() {
  Robot robot = published_robot();
  robot.name = "small";
  robot.fixed.reset();
  robot.lateral_acceleration = 3800.0;
  robot.yaw_acceleration = 300.0;
  robot.clearance = 18.0;
  robot.run_up = 24.0;
  robot.search = {};
  robot.search_speed = 300.0;
  robot.pivot_speed = 10.0;
  robot.pivot_acceleration = 100.0;
  return robot;
}

/// A robot of the classic contest.
inline Robot large_robot() {
  Robot robot = small_robot();
  robot.name = "large";
  robot.cell = 180.0;
  robot.speed = 3000.0;
  robot.speed_diagonal = 2500.0;
  robot.acceleration = robot.braking = robot.acceleration_diagonal = robot.braking_diagonal = 10'000.0;
  robot.lateral_acceleration = 10'000.0;
  robot.clearance = 45.0;
  robot.run_up = 50.0;
  robot.search_speed = 500.0;
  return robot;
}

/// The same one with a fan that presses it to the ground.
inline Robot fan_robot() {
  Robot robot = large_robot();
  robot.name = "fan";
  robot.lateral_acceleration = 30'000.0;
  robot.yaw_acceleration = 1200.0;
  robot.acceleration = robot.braking = robot.acceleration_diagonal = robot.braking_diagonal = 25'000.0;
  return robot;
}

}  // namespace labmouse
