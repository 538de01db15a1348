// Many programs written for mms on many mazes.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "labmouse/guests/mms/run.hpp"
#include "labmouse/lab/bounds/mms_bound.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/text/last_lines.hpp"

namespace labmouse {

struct MmsRaceOrder {
  MmsOptions options;
  /// Of the intervals; the world of mms has no chance of its own.
  std::uint64_t seed = 1;
  /// Programs that run side by side; 0 takes as many as there are processors.
  int jobs = 0;
  /// Whether a record is made of each run, for MmsRaceHooks::finished.
  bool records = false;
};

/// One run and how it went. `mouse` and `maze` are positions in the race's lists.
struct MmsResult {
  std::size_t mouse = 0;
  std::size_t maze = 0;
  bool done = false;  ///< false where the race was stopped before its end
  /// Without its canvas, and with the ends of its log and its errors only (see kept_log): many runs have to fit into
  /// memory.
  MmsRun run;
};

/// How many sentences of a run's log a race keeps: the first ones.
inline constexpr std::size_t kept_log = 3;

struct MmsRace {
  MmsRaceOrder order;
  std::vector<MmsMouse> mice;      ///< in the order of their names
  std::vector<NamedMaze> mazes;    ///< in the order of their names
  std::vector<MmsBound> bounds;    ///< of each maze
  std::vector<MmsResult> results;  ///< by mouse and maze
  bool stopped = false;            ///< before all runs were done
};

/// What a race tells while it goes on.
struct MmsRaceHooks {
  /// Called after each run with its record (empty where none was asked for), from any thread but never from two at
  /// once.
  std::function<void(const MmsRace&, const MmsResult&, const std::string& record)> finished;
  /// Once it is true no other run begins, and those under way are ended and left out.
  const std::atomic<bool>* stop = nullptr;
};

/// Hosts every mouse once in every maze.
MmsRace hold_mms_race(std::vector<MmsMouse> mice, std::vector<NamedMaze> mazes, const MmsRaceOrder& order,
                      const MmsRaceHooks& hooks = {});

}  // namespace labmouse
