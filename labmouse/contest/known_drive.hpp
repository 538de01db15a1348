// A mouse that knows the maze drives from the start to the goal in the physical world: how sure its controller is,
// apart from any strategy.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "labmouse/body/plant.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/hardware/sense.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// By the moves of a search, over the least time of these; or by the fastest route.
enum class KnownWay : std::uint8_t { search, fast };

/// Sums of squares over ticks of how far something is from where it should be: along the way, aside of it, and in
/// direction.
struct WayErrors {
  double along = 0.0;      ///< mm²
  double aside = 0.0;      ///< mm²
  double direction = 0.0;  ///< rad²

  WayErrors& operator+=(const WayErrors& other);
};

/// Readings of walls, and how many of them were wrong.
struct WallReadings {
  std::int64_t all = 0;
  std::int64_t wrong = 0;

  WallReadings& operator+=(const WallReadings& other);
};

struct KnownDrive {
  bool crashed = false;
  int cells = 0;  ///< moves that were driven whole, of a search
  std::int64_t ticks = 0;
  int grazes = 0;
  WayErrors truth;           ///< of the true mouse
  WayErrors estimate;        ///< of where the mouse believes to be
  double most_aside = 0.0;   ///< mm, of the true mouse
  WallReadings side, front;  ///< at the edges of a search
};

/// A tick as a log has it: what the mouse read, what it had its motors do from then on, and how it truly moved when it
/// read that.
struct LoggedTick {
  Sense sense;
  Drive drive;
  BodyMotion motion;
};

/// One drive; nothing where no way leads to a goal. The robot must be one that can drive there. A log, where there is
/// one, gets all ticks of it up to a crash; the mouse then stands for half a second before it drives, as mice do whose
/// gyro is calibrated.
std::optional<KnownDrive> drive_known_way(const Maze& maze, const DriveModel& model,
                                          const PhysicalConditions& conditions, KnownWay way, std::uint64_t seed,
                                          std::vector<LoggedTick>* log = nullptr);

/// How many moves of a search lead there; 0 where none do.
int moves_of_known_way(const Maze& maze, const DriveModel& model);

}  // namespace labmouse
