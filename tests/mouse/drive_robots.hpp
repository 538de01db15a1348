// Robots for tests.
#pragma once

#include <array>
#include <string>

#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {

/// Much as the parameters of a library of 2021, in cells of 90 mm.
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

/// A robot whose yaw jerk and yaw speed are limited, with the paths of its turns given.
inline Robot jerk_robot() {
  Robot robot = small_robot();
  robot.name = "jerk";
  robot.lateral_acceleration = 5000.0;
  robot.yaw_acceleration = 113.097;
  robot.yaw_speed = 9.42478;
  robot.yaw_jerk = 3769.91;
  robot.clearance = 30.9;
  robot.search_speed = 265.0;
  constexpr std::array given = {411.636, 422.783, 353.609, 24.0, 289.908, 265.749};
  for (std::size_t turn = 0; turn < given.size(); ++turn) robot.layouts[turn].given = given[turn];
  return robot;
}

/// The same limits on larger cells, where its turns are fitted.
inline Robot large_jerk_robot() {
  Robot robot = large_robot();
  robot.name = "large_jerk";
  robot.yaw_speed = 7.0;
  robot.yaw_jerk = 9000.0;
  return robot;
}

/// With the yaw rate of its turns rising in another way.
inline Robot with_profile(Robot robot, TurnProfile profile) {
  robot.name += "_" + std::string(name_of(profile));
  robot.profile = profile;
  return robot;
}

/// A robot as it was before there was a choice: two speeds of each turn, and any speed in the goal.
inline Robot robot_of_the_past(Robot robot) {
  robot.speeds = 2;
  robot.stop = Stop::beyond;
  return robot;
}

/// With so many speeds of each turn.
template <int Speeds>
Robot robot_of_speeds() {
  Robot robot = large_robot();
  robot.name = "speeds_" + std::to_string(Speeds);
  robot.speeds = Speeds;
  return robot;
}

/// One whose tyres hold a little more than it needs in curves, so that its speed changes in them.
inline Robot grip_robot() {
  Robot robot = large_robot();
  robot.name = "grip";
  robot.grip = 11'000.0;
  return robot;
}

/// The same one in small cells, with weak brakes and as many speeds as there may be.
inline Robot small_grip_robot() {
  Robot robot = small_robot();
  robot.name = "small_grip";
  robot.grip = 6000.0;
  robot.braking = 2500.0;
  robot.speeds = most_speeds;
  return robot;
}

/// One of a tenth of g, in everything.
inline Robot weak_robot() {
  Robot robot = large_robot();
  robot.name = "weak";
  robot.acceleration = robot.braking = robot.acceleration_diagonal = robot.braking_diagonal = 981.0;
  robot.lateral_acceleration = 981.0;
  robot.yaw_acceleration = 60.0;
  robot.search_speed = 200.0;
  return robot;
}

/// One that leaves out some turns.
inline Robot choosy_robot() {
  Robot robot = small_robot();
  robot.name = "choosy";
  for (const Turn turn : {Turn::f45, Turn::v90, Turn::f180}) robot.layouts[static_cast<unsigned>(turn)].driven = false;
  return robot;
}

/// One that ends its runs at any speed.
inline Robot unstopped_robot() {
  Robot robot = fan_robot();
  robot.name = "unstopped";
  robot.stop = Stop::beyond;
  return robot;
}

/// One that drives no diagonals.
inline Robot square_robot() {
  Robot robot = large_robot();
  robot.name = "square";
  robot.diagonals = false;
  return robot;
}

/// The slowest one there is, without 180.
inline Robot slow_robot() {
  Robot robot = large_robot();
  robot.name = "slow";
  robot.speed = robot.speed_diagonal = robot.search_speed = 50.0;
  robot.lateral_acceleration = 500.0;
  robot.layouts[static_cast<unsigned>(Turn::f180)].driven = false;
  return robot;
}

/// One that holds eight g: from rest it does not reach the speed of its slowest turn by the first wall.
inline Robot strong_robot() {
  Robot robot = fan_robot();
  robot.name = "strong";
  robot.lateral_acceleration = 8.0 * 9810.0;
  robot.yaw_acceleration = 5000.0;
  robot.speed = robot.speed_diagonal = 7000.0;
  robot.acceleration = robot.braking = robot.acceleration_diagonal = robot.braking_diagonal = 10'000.0;
  return robot;
}

/// One that is slow to begin a turn: its small ones have no arc, and it comes near the wall ahead in 180.
inline Robot slow_to_turn() {
  Robot robot = fan_robot();
  robot.name = "slow_to_turn";
  robot.yaw_acceleration = 200.0;
  return robot;
}

/// One whose yaw acceleration falls again before it is as large as it may be.
inline Robot smooth_robot() {
  Robot robot = fan_robot();
  robot.name = "smooth";
  robot.yaw_acceleration = 300.0;
  robot.yaw_jerk = 6000.0;
  return robot;
}

/// One that is slower on diagonals than in its turns.
inline Robot slow_on_diagonals() {
  Robot robot = large_robot();
  robot.name = "slow_on_diagonals";
  robot.speed_diagonal = 700.0;
  return robot;
}

/// One that brakes less than it accelerates: backwards it is another robot.
inline Robot weak_brakes() {
  Robot robot = fan_robot();
  robot.name = "weak_brakes";
  robot.braking = robot.acceleration / 3.0;
  robot.braking_diagonal = robot.acceleration_diagonal / 2.0;
  return robot;
}

}  // namespace labmouse
