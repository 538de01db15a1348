// Drives a known maze from the start to the goal in the physical world, to test the controller without a strategy.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "labmouse/contest/logged_tick.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// The way: by search moves with the least total time, or by the fastest route.
enum class KnownWay : std::uint8_t { search, fast };

/// Sums over ticks of squared deviations from the target: longitudinal, lateral, and in direction of motion.
struct WayErrors {
  double along = 0.0;      ///< mm²
  double aside = 0.0;      ///< mm²
  double direction = 0.0;  ///< rad²

  WayErrors& operator+=(const WayErrors& other);
};

/// Wall readings, and wall detection errors among them.
struct WallReadings {
  std::int64_t all = 0;
  std::int64_t wrong = 0;

  WallReadings& operator+=(const WallReadings& other);
};

struct KnownDrive {
  bool crashed = false;
  int cells = 0;  ///< completed search moves
  std::int64_t ticks = 0;
  int grazes = 0;
  WayErrors truth;           ///< of the true mouse
  WayErrors estimate;        ///< of the estimated pose
  double most_aside = 0.0;   ///< largest lateral deviation of the true mouse, mm
  WallReadings side, front;  ///< at the edges of a search
};

/// Makes one drive; nullopt if no way leads to a goal. The robot must pass why_not_physical(). A log gets all ticks up
/// to a crash; with a log the mouse first stands for half a second, as for the calibration of a gyro.
std::optional<KnownDrive> drive_known_way(const Maze& maze, const DriveModel& model,
                                          const PhysicalConditions& conditions, KnownWay way, std::uint64_t seed,
                                          std::vector<LoggedTick>* log = nullptr);

/// Number of search moves to the goal; 0 if there is no way.
int moves_of_known_way(const Maze& maze, const DriveModel& model);

}  // namespace labmouse
