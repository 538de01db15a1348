// Measures failure rates in the physical world. Contests are run. For each manoeuvre, the localization errors at its
// beginning and end are counted, and crashes; for each wall reading, its evidence and whether it was wrong.
//
// Counts are by the localization error at the beginning of the manoeuvre and by how bright walls look, because these
// cause most of the failures: a mouse that knows its position rarely crashes, and detects walls of the usual
// brightness.
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

/// Adds a contest to the counts at its pace. Its trace must have a point every few ticks, with the estimated position.
/// Manoeuvres after the goal of a speed run, or unfinished at the end of the time, are not counted.
void count_failures(const PhysicalRecord& record, const Maze& maze, double cell, const RobotSample& sample,
                    FailureTally& tally);

struct FailureOrder {
  std::shared_ptr<const DriveModel> model;
  DriveRules rules;
  PhysicalConditions conditions;  ///< except variation and pace, which are those below
  std::vector<double> variations;
  std::vector<double> paces = {1.0};  ///< each with all variations
  int runs = 1;                       ///< contests of each mouse in each maze, under each variation
  std::uint64_t seed = 1;
  int jobs = 0;  ///< threads; 0: all processors
};

struct FailureHooks {
  /// Called after each contest with the total number of contests, from any thread but never from two at once.
  std::function<void(std::size_t all)> finished;
  /// Once it is true no other contest begins, and those under way end at their next decision and do not count.
  const std::atomic<bool>* stop = nullptr;
};

struct MeasuredRates {
  std::vector<FailureTally> tallies;  ///< one for each pace and variation, in increasing order
  bool stopped = false;               ///< before all contests were done
  /// The tallies of each maze, for the intervals of the shares: contests in one maze are not independent. Where there
  /// are none, contests count as independent.
  std::vector<std::vector<FailureTally>> by_maze = {};
};

/// Runs all contests of mice that decide by Strategy; each has a seed of its own, the same under each variation and the
/// same as in a race of that seed.
MeasuredRates measure_rates(const FailureOrder& order, std::span<const Contestant> mice,
                            std::span<const NamedMaze> mazes, const FailureHooks& hooks = {});

std::string table_of(const MeasuredRates& measured, const FailureOrder& order);
/// With the interval of each share.
std::string json_of(const MeasuredRates& measured, const FailureOrder& order, std::span<const Contestant> mice,
                    std::size_t mazes);
/// The counts alone, as read_rates() reads them: the content of a file for the failure model. Counts that were stopped
/// early are marked, and read_rates() refuses them.
std::string write_rates(const MeasuredRates& measured, const FailureOrder& order, std::span<const Contestant> mice,
                        std::size_t mazes);

}  // namespace labmouse
