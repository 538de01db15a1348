// The driver without errors: it takes the times of the model, and reads all walls correctly.
#pragma once

#include "labmouse/contest/timed_driver.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

/// A move that has begun is completed even beyond the time limit.
class IdealDriver final : public TimedDriver {
 public:
  /// All must outlive it.
  IdealDriver(const Maze& maze, const DriveModel& model, MazeTime time_limit, DriveRecord& record);

  bool errs() const override { return false; }
  void carry_to_start() override { put_at_start(); }
  void know_open(const WallSet& walls) override;
  void look_about() override { arrive(); }
  bool make(const Action& part, bool replanned) override;
  bool run(const DriveRoute& route) override;
  void set_pace(double) override {}

  const Knowledge& known() const override { return known_; }
  Sighting seen(const Pose& pose) const override;
  BelievedWalls* weighed() override { return nullptr; }
  std::optional<RunEnd> crash() const override { return std::nullopt; }

 private:
  void arrive() override;

  Knowledge known_;
};

}  // namespace labmouse
