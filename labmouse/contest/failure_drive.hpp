// The moving part of a contest in the failure model: times of the world in seconds, and dice.
#pragma once

#include <cstdint>
#include <span>

#include "labmouse/chance/dice.hpp"
#include "labmouse/contest/failure_rates.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/timed_driver.hpp"

namespace labmouse {

class FailureDriver final : public TimedDriver {
 public:
  /// All must outlive it.
  FailureDriver(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions,
                const FailureRates& failure_rates, std::uint64_t seed, MazeTime time_limit, PhysicalRecord& record);

  bool errs() const override { return true; }
  void put_at_start() override;
  void carry_to_start() override;
  void look_about() override;
  bool make(const Action& part, bool replanned) override;
  bool run(const DriveRoute& route) override;
  void set_pace(double pace) override;

  const Knowledge& known() const override { return walls_.known(); }
  Sighting seen(const Pose& pose) const override { return walls_.sighting(pose); }
  BelievedWalls* weighed() override { return walls_.weighs() ? &walls_ : nullptr; }
  std::optional<RunEnd> crash() const override { return crash_; }

 private:
  /// How a manoeuvre went: all of it, or the part of its time after which the mouse crashed.
  struct ManoeuvreOutcome {
    std::optional<RunEnd> crash = std::nullopt;
    double part = 1.0;
  };

  std::size_t one_of(std::span<const double> shares);
  ManoeuvreOutcome drive(Manoeuvre manoeuvre, bool way_is_open);
  bool crash_at(MazeTime time, RunEnd cause);
  /// Whether there is time left by then; the clock stands at its end where there is not.
  bool reach(MazeTime time);
  bool is_open(const Action& part) const;
  Evidence read_wall(Heading side, bool ahead, double clear);

  MazeTime handling_;
  double usual_pace_;
  BelievedWalls walls_;
  Dice dice_;
  const FailureRates& rates_;
  double noise_;
  Draws draws_ = Draws::sound;
  double noise_share_;  ///< of this contest: which of two noises that were counted it is held under
  const FailureRatesByDraw* odds_ = nullptr;
  std::size_t position_error_ = 0;  ///< its level
  WallSet read_;                    ///< at least once
  std::optional<RunEnd> crash_;
};

}  // namespace labmouse
