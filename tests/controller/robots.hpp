// The built-in robots that have bodies.
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
inline const DriveModel& kerise() {
  static const DriveModel model = model_of("kerise");
  return model;
}
inline const DriveModel& classic() {
  static const DriveModel model = model_of("classic");
  return model;
}
inline const DriveModel& beginner() {
  static const DriveModel model = model_of("beginner");
  return model;
}

}  // namespace labmouse::test
