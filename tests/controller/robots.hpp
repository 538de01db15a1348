// The built-in robots that have hardware.
#pragma once

#include <string>

#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse::test {

inline DriveModel model_of(const std::string& robot) {
  DriveModel model = find_robot(robot).model;
  share_route_tables(model);
  return model;
}

/// That robot, but what differs is small, as for one mouse in one maze: the logs are of such.
inline DriveModel well_known(const std::string& robot) {
  DriveModel model = model_of(robot);
  const double size = model.tables.cell / 90.0;
  model.robot.hardware->variation = {.motor_gain = 0.1,
                                     .stiffness = 0.2,
                                     .grip = 0.1,
                                     .encoder_scale = 0.01,
                                     .gyro_scale = 0.005,
                                     .infrared_gain = 0.03,
                                     .reflectance = 0.05,
                                     .floor_steps = 0.04,
                                     .floor_turn = 0.0105,
                                     .floor_shift = 0.5 * size,
                                     .placement = size,
                                     .placement_turn = 0.0175};
  return model;
}
inline const DriveModel& kerise() {
  static const DriveModel model = well_known("kerise");
  return model;
}
inline const DriveModel& classic() {
  static const DriveModel model = well_known("classic");
  return model;
}
/// With turns of free shape, in which the speed changes.
inline const DriveModel& free_classic() {
  static const DriveModel model = [] {
    Robot robot = well_known("classic").robot;
    robot.profile = TurnProfile::free;
    robot.grip = 10'000.0;
    DriveModel made = make_drive_model(robot);
    share_route_tables(made);
    return made;
  }();
  return model;
}
inline const DriveModel& beginner() {
  static const DriveModel model = well_known("beginner");
  return model;
}

}  // namespace labmouse::test
