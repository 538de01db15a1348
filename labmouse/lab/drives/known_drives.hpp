// Many drives along known ways: how often a controller crashes and wrong walls, under which noise and with which
// corrections.
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

/// One line of what is compared: a name, and what is driven under it.
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
  std::vector<LoggedTick>* log = nullptr;  ///< of the only drive, where it is to be logged
};

/// All drives of a case, in mazes in which there is a way.
struct DriveTally {
  std::string name;
  double variation = 0.0;  ///< by which what a contest draws of the mouse is multiplied
  bool stopped = false;    ///< before all of its drives were done
  int mazes = 0;
  int mazes_without_crash = 0;
  double worst_share = 0.0;  ///< of drives that crashed, in the worst maze
  std::string worst_maze;
  int runs = 0;
  int crashed = 0;
  Interval interval;  ///< of the share of these, over mazes
  std::int64_t cells = 0, ticks = 0, grazes = 0;
  WayErrors truth, estimate;
  WallReadings side, front;
  std::vector<double> most_aside;  ///< of the drives that did not crash, in order
};

struct DriveHooks {
  /// Called after each drive with the number of all, from any thread but never from two at once. A maze without a
  /// route counts as driven.
  std::function<void(std::size_t all)> finished;
  const std::atomic<bool>* stop = nullptr;  ///< once it is true no other drive begins
};

/// Drives all of them; each drive has a seed of its own, the same in each case.
std::vector<DriveTally> drive_known_ways(const DriveOrder& order, std::span<const NamedMaze> mazes,
                                         std::span<const DriveCase> cases, const DriveHooks& hooks = {});

/// Whether drives are missing, because they were stopped.
bool is_stopped(std::span<const DriveTally> tallies);

/// The conditions with each noise group alone; and with each choice of corrections.
std::vector<DriveCase> cases_by_group(const PhysicalConditions& conditions);
std::vector<DriveCase> cases_by_correction(const PhysicalConditions& conditions);

std::string table_of(std::span<const DriveTally> tallies, const DriveOrder& order);
std::string json_of(std::span<const DriveTally> tallies, const DriveOrder& order);

}  // namespace labmouse
