// Many mice on many mazes in the world of seconds.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/contest/drive_score.hpp"
#include "labmouse/lab/bounds/drive_bound.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"

namespace labmouse {

struct DriveRaceOrder {
  DriveRules rules;
  std::shared_ptr<const DriveModel> model;  ///< without an error
  /// Contests of each mouse that throws dice in each maze; the others need one.
  int runs = 20;
  std::uint64_t seed = 1;
  /// Threads; 0 takes as many as there are processors. Results do not depend on it.
  int jobs = 0;
};

/// One contest and how it went. `mouse` and `maze` are positions in the race's lists.
struct DriveResult {
  std::size_t mouse = 0;
  std::size_t maze = 0;
  int run = 0;
  std::uint64_t seed = 0;
  bool done = false;  ///< false where the race was stopped before
  DriveScore score;
  ForfeitReason reason = ForfeitReason::none;
  MazeTime search = 0;           ///< in the maze before the first fast run; all of the time where there is none
  std::optional<MazeTime> best;  ///< the fastest run that counts, from rest to the centre
  bool proven = false;           ///< whether no faster route than the known one could exist before the last fast run
  int starts = 0;                ///< runs from the start
  int decisions = 0;
  int replanned = 0;
};

struct DriveRace {
  DriveRaceOrder order;
  std::vector<Contestant> mice;      ///< in the order of their names
  std::vector<NamedMaze> mazes;      ///< in the order of their names
  std::vector<DriveBound> bounds;    ///< of each maze
  std::vector<DriveResult> results;  ///< by mouse, maze and run
  bool stopped = false;              ///< before all contests were done
};

/// What a race tells while it goes on.
struct DriveRaceHooks {
  /// Called after each contest, from any thread but never from two at once.
  std::function<void(const DriveRace&, const DriveResult&, const DriveRecord&)> finished;
  /// Asked before each contest; once it is true no other begins.
  const std::atomic<bool>* stop = nullptr;
};

/// Races every mouse, all of which must drive, on every maze, all of which must be at most 32×32.
DriveRace hold_drive_race(std::vector<Contestant> mice, std::vector<NamedMaze> mazes, const DriveRaceOrder& order,
                          const DriveRaceHooks& hooks = {});

/// How many contests such a race has.
std::size_t drive_contests_of(const std::vector<Contestant>& mice, std::size_t mazes, const DriveRaceOrder& order);

/// Every mouse of the roster that drives, with its defaults.
std::vector<Contestant> all_drivers();

/// The record of a contest as a file.
DriveRecordFile drive_record_file_of(const DriveRace& race, const DriveResult& result, const DriveRecord& record);

}  // namespace labmouse
