// A body and its controller in a maze.
#pragma once

#include <functional>

#include "labmouse/controller/controller.hpp"
#include "tests/body/body_in_a_maze.hpp"

namespace labmouse::test {

class Driven {
 public:
  Driven(const Maze& maze, const DriveModel& model, const ErrorScale& level = no_errors, std::uint64_t seed = 1,
         const ControllerChoice& choice = {})
      : cell_(model.tables.cell),
        body_(maze, cell_, *model.robot.hardware, level, seed),
        controller_(model, *model.robot.hardware, maze.size(), gains_for(*model.robot.hardware, cell_), choice) {
    put({maze.start(), maze.start_heading()});
  }

  void put(const Pose& pose) {
    body_.put(pose.cell, pose.heading);
    controller_.put(pose);
    pending_ = false;
  }
  /// Until the controller has arrived; false after a crash. Each tick is shown to whoever looks.
  bool drive_on(const std::function<void()>& look = {}) {
    for (;;) {
      if (!pending_) duties_ = controller_.tick(body_.sense());
      pending_ = true;
      if (controller_.arrived()) return true;
      pending_ = false;
      ++ticks_;
      if (body_.step(duties_) == Touch::crash) return false;
      if (look) look();
    }
  }
  bool search(const Action& step) {
    controller_.search(step);
    return drive_on();
  }

  Position middle_of(Cell cell) const { return {(cell.x + 0.5) * cell_, (cell.y + 0.5) * cell_}; }
  /// Of the estimate: where it believes to be, less where it is.
  Position error() const { return controller_.estimate().position - body_.motion().position; }
  double angle_error() const {
    const Direction &believed = controller_.estimate().ahead, &truth = body_.motion().ahead;
    return believed.sine * truth.cosine - believed.cosine * truth.sine;
  }
  Body& body() { return body_; }
  Controller& controller() { return controller_; }
  const Maze& maze() const { return body_.maze; }
  int ticks() const { return ticks_; }

 private:
  double cell_;
  BodyInAMaze body_;
  Controller controller_;
  Drive duties_;
  bool pending_ = false;
  int ticks_ = 0;
};

}  // namespace labmouse::test
