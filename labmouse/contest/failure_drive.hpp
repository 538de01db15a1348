// The driver in the failure model: it takes the times of the world in seconds, and draws failures at random.
#pragma once

#include <cstdint>
#include <span>

#include "labmouse/body/robot_sample.hpp"
#include "labmouse/chance/rng.hpp"
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
  void know_open(const WallSet& walls) override { walls_.know_open(clock(), walls); }
  void look_about() override;
  bool make(const Action& part, bool replanned) override;
  bool run(const DriveRoute& route) override;
  void set_pace(double pace) override;

  const Knowledge& known() const override { return walls_.known(); }
  Sighting seen(const Pose& pose) const override { return walls_.sighting(pose); }
  BelievedWalls* weighed() override { return walls_.weighs() ? &walls_ : nullptr; }
  std::optional<RunEnd> crash() const override { return crash_; }

 private:
  /// Outcome of a manoeuvre: complete, or a crash after a part of its time.
  struct ManoeuvreOutcome {
    std::optional<RunEnd> crash = std::nullopt;
    double part = 1.0;
  };

  std::size_t random_class(std::span<const double> shares);
  /// The class in which a random number from 0 to 1 falls.
  static std::size_t class_at(double number, std::span<const double> shares);
  ManoeuvreOutcome drive(Manoeuvre manoeuvre, bool way_is_open);
  bool crash_at(MazeTime time, RunEnd cause);
  /// Sets the clock to that time, or to the time limit. Returns whether time is left.
  bool reach(MazeTime time);
  bool is_open(const Action& part) const;
  /// Rates of contests in which walls are as bright as in this one.
  const FailureRatesByBrightness& rates() const;
  Evidence read_wall(Heading side, bool ahead, double clear);

  MazeTime handling_;
  double usual_pace_;
  BelievedWalls walls_;
  std::uint64_t seed_;
  Rng rng_;
  const FailureRates& rates_;
  RobotSample sample_;
  double variation_;
  double variation_share_;  ///< uniform draw of this contest that chooses between two measured variations
  const RatesAtVariation* at_variation_ = nullptr;
  std::size_t position_error_ = 0;  ///< level of the present localization error
  WallSet read_;                    ///< walls read at least once
  std::optional<RunEnd> crash_;
};

}  // namespace labmouse
