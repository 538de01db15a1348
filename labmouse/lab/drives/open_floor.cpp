#include "labmouse/lab/drives/open_floor.hpp"

#include "labmouse/hardware/sense.hpp"

namespace labmouse {

OpenFloor::OpenFloor(const Hardware& hardware, double cell, double stronger)
    : hardware_(hardware),
      maze_(MazeDraft({1, 1}, MazeDraft::Inside::open)),
      field_(maze_, cell),
      robot_sample_(hardware, no_errors, maze_.size(), 0),
      plant_(field_, hardware, robot_sample_, 0),
      control_(gains_each_tick(hardware, cell), hardware.motors) {
  robot_sample_.motor = {1.0 - stronger / 2.0, 1.0 + stronger / 2.0};
  plant_.put({cell / 2.0, cell / 2.0}, 0.0);
  note();
}

void OpenFloor::push(const Drive& drive) {
  plant_.step(drive);
  way_ += plant_.motion().speed * tick_seconds;
  note();
}

void OpenFloor::follow(const Command& command) {
  const BodyMotion& motion = plant_.motion();
  push(control_.control(command, motion.speed, motion.yaw, hardware_.motors.volts * plant_.voltage()));
}

void OpenFloor::note() {
  ways_.push_back(way_);
  angles_.push_back(plant_.motion().angle);
}

}  // namespace labmouse
