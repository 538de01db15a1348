// The moving part of a contest in the fallible world: times of the world in seconds, and dice.
#pragma once

#include <cstdint>
#include <span>

#include "labmouse/chance/dice.hpp"
#include "labmouse/contest/contest_driver.hpp"
#include "labmouse/contest/hazards.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

class FallibleDriver final : public ContestDriver {
 public:
  /// All must outlive it.
  FallibleDriver(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions,
                 const Hazards& hazards, std::uint64_t seed, MazeTime time_limit, PhysicalRecord& record);

  void put_at_start() override;
  void look_about() override;
  bool make(const Action& part, bool replanned) override;
  bool run(const DriveRoute& route) override;
  void wait(MazeTime time) override { clock_ += time; }
  void set_pace(double pace) override;

  const SearchPlace& place() const override { return place_; }
  BelievedWalls& walls() override { return walls_; }
  MazeTime clock() const override { return clock_; }
  bool out_of_time() const override { return clock_ >= time_limit_; }
  bool crashed() const override { return crashed_; }
  RunEnd cause() const override { return cause_; }

 private:
  /// How a manoeuvre went: all of it, or the part of its time after which the mouse crashed.
  struct Went {
    bool crashed = false;
    RunEnd cause = RunEnd::strayed;
    double part = 1.0;
  };

  MazeTime slowed(MazeTime time) const { return at_pace(time, pace_); }
  std::size_t one_of(std::span<const double> shares);
  Went drive(Manoeuvre manoeuvre, bool way_is_open);
  bool crash(RunEnd cause, MazeTime time);
  /// Whether there is time left by then; the clock stands at its end where there is not.
  bool reach(MazeTime time);
  bool is_open(const Action& part) const;
  void advance(const Action& part, MazeTime begin, MazeTime end);
  Evidence read_wall(Heading side, bool ahead, double clear);

  const Maze& maze_;
  const DriveModel& model_;
  MazeTime time_limit_;
  PhysicalRecord& record_;
  BelievedWalls walls_;
  Dice dice_;
  const Hazards& hazards_;
  double noise_;
  Luck luck_ = Luck::sound;
  double noise_share_;  ///< of this contest: which of two noises that were counted it is held under
  const HazardsByLuck* odds_ = nullptr;
  double pace_ = 1.0;
  SearchPlace place_;
  std::size_t astray_ = 0;  ///< its level
  WallSet read_;            ///< at least once
  MazeTime clock_ = 0;
  bool crashed_ = false;
  RunEnd cause_ = RunEnd::strayed;
};

}  // namespace labmouse
