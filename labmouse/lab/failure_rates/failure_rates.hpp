// What goes wrong in the physical world, and at what: contests are run, and of each manoeuvre it is counted how far
// the mouse was from where it believed to be, how far it was afterwards, and whether it crashed; and of each reading of
// a wall whether it was wrong.
//
// Counts are by how far the mouse was lost as the manoeuvre began, because that is what makes the next one go wrong:
// a mouse that knows where it is neither wrong walls nor crashes.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/lab/failure_rates/failure_tally.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Counts what happened in a contest, at that usual pace, whose mouse told where it believed to be, with a point of the
/// trace every few ticks. What a mouse does behind the goal of a speed run counts nowhere, and neither does what it did
/// when the time was over.
void count_failures(const PhysicalRecord& record, const Maze& maze, double cell, double pace, FailureCounts& counts);

struct FailureOrder {
  std::shared_ptr<const DriveModel> model;
  DriveRules rules;
  PhysicalConditions conditions;  ///< but for their noise
  std::vector<double> noises;
  std::vector<double> paces = {1.0};  ///< all noises at each
  int runs = 1;                       ///< contests of each mouse in each maze, under each noise
  std::uint64_t seed = 1;
  int jobs = 0;  ///< threads; 0: all processors
};

struct FailureHooks {
  /// Called after each contest with the number of all, from any thread but never from two at once.
  std::function<void(std::size_t all)> finished;
  /// Once it is true no other contest begins, and those under way end at their next decision and do not count.
  const std::atomic<bool>* stop = nullptr;
};

struct MeasuredRates {
  std::vector<FailureTally> tallies;  ///< one for each pace and noise, in increasing order
  bool stopped = false;               ///< before all contests were done
  /// The tallies of each maze, for the intervals of the shares: contests in one maze are not independent. Where there
  /// are none, contests count as independent.
  std::vector<std::vector<FailureTally>> by_maze = {};
};

/// Runs all contests of mice that decide by Strategy; each has a seed of its own, the same under each noise and the
/// same as in a race of that seed.
MeasuredRates measure_rates(const FailureOrder& order, std::span<const Contestant> mice,
                            std::span<const NamedMaze> mazes, const FailureHooks& hooks = {});

std::string table_of(const MeasuredRates& measured, const FailureOrder& order);
/// With the interval of each share.
std::string json_of(const MeasuredRates& measured, const FailureOrder& order, std::span<const Contestant> mice,
                    std::size_t mazes);
/// The counts alone, as read_rates() reads them: kept in a file they make a world. Counts that were stopped early are
/// marked, and read_rates() refuses them.
std::string write_rates(const MeasuredRates& measured, const FailureOrder& order, std::span<const Contestant> mice,
                        std::size_t mazes);

}  // namespace labmouse
