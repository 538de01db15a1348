// Robots for tests.
#pragma once

#include "labmouse/mouse/drive/robot.hpp"

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

}  // namespace labmouse
