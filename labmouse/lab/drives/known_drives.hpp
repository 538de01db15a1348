// Tests the controller on known routes: rates of crashes, tracking errors and wall detection errors. Compares causes
// of errors, and corrections of the estimated pose by sensed walls.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "labmouse/contest/known_drive.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/numbers/interval.hpp"

namespace labmouse {

/// One row of the comparison: a name and its conditions.
struct DriveCase {
  std::string name;
  PhysicalConditions conditions;
};

struct DriveOrder {
  std::shared_ptr<const DriveModel> model;
  KnownWay way = KnownWay::search;
  int runs = 20;  ///< in each maze
  std::uint64_t seed = 1;
  int jobs = 0;                            ///< threads; 0: all processors
  std::vector<LoggedTick>* log = nullptr;  ///< receives the log if not null; only for a single drive
};

/// Results of all drives of a case, in mazes with a route.
struct DriveTally {
  std::string name;
  bool stopped = false;  ///< whether it was stopped before all drives were done
  int mazes = 0;
  int mazes_without_crash = 0;
  double worst_share = 0.0;  ///< share of drives that crashed in the worst maze
  std::string worst_maze;
  int runs = 0;
  int crashed = 0;
  Interval interval;  ///< 95 % interval of the share that crashed, over mazes
  std::int64_t cells = 0, ticks = 0, grazes = 0;
  WayErrors truth, estimate;
  WallReadings side, front;
  std::vector<double> most_aside;  ///< largest lateral errors in mm of the drives without a crash, sorted
};

struct DriveHooks {
  /// Called after each drive with the total number of drives, from any thread but never from two at once. A maze
  /// without a route counts as driven.
  std::function<void(std::size_t all)> finished;
  const std::atomic<bool>* stop = nullptr;  ///< if true, no further drive begins
};

/// Runs all drives. Each drive has its own seed, which is the same in each case.
std::vector<DriveTally> drive_known_ways(const DriveOrder& order, std::span<const NamedMaze> mazes,
                                         std::span<const DriveCase> cases, const DriveHooks& hooks = {});

/// Whether drives are missing, because they were stopped.
bool is_stopped(std::span<const DriveTally> tallies);

/// The conditions with all errors, then with each cause of errors alone.
std::vector<DriveCase> cases_by_cause(const PhysicalConditions& conditions);
/// The conditions with all corrections; with side walls only; with wall edges and walls ahead only; and with none.
std::vector<DriveCase> cases_by_correction(const PhysicalConditions& conditions);

std::string table_of(std::span<const DriveTally> tallies, const DriveOrder& order);
std::string json_of(std::span<const DriveTally> tallies, const DriveOrder& order);

}  // namespace labmouse
