// Many mice on many mazes.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "labmouse/contest/coverage.hpp"
#include "labmouse/contest/missteps.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mice/specs.hpp"

namespace labmouse {

struct RaceOrder {
  Rules rules;
  /// Contests of each mouse that throws dice in each maze; the others need one.
  int runs = 20;
  std::uint64_t seed = 1;
  /// Threads; 0 takes as many as there are processors. Results do not depend on it.
  int jobs = 0;
};

/// One contest and how it went. `mouse` and `maze` are positions in the race's lists.
struct ContestResult {
  std::size_t mouse = 0;
  std::size_t maze = 0;
  int run = 0;
  std::uint64_t seed = 0;
  bool done = false;    ///< false where the race was stopped before
  bool started = true;  ///< false where a guest's program did not, see Strategy::started
  Score score;
  Coverage coverage;
  /// Steps that were not performed as the mouse asked for them.
  Missteps missteps;
  ForfeitReason reason = ForfeitReason::none;
  int decisions = 0;
  /// What the mouse had to say; empty for most.
  std::string last_words;
  /// What the mouse counted, by name; empty for most.
  std::vector<Count> counts;
  /// Time spent in the mouse's decisions, in microseconds: the one figure that differs from race to race.
  double microseconds = 0.0;
};

struct Race {
  RaceOrder order;
  std::vector<Contestant> mice;        ///< in the order of their names
  std::vector<NamedMaze> mazes;        ///< in the order of their names
  std::vector<Bound> bounds;           ///< of each maze
  std::vector<CellSet> reachable;      ///< the cells that can be reached in each maze
  std::vector<ContestResult> results;  ///< by mouse, maze and run
  bool stopped = false;                ///< before all contests were done
};

/// What a race tells while it goes on.
struct RaceHooks {
  /// Called after each contest, from any thread but never from two at once.
  std::function<void(const Race&, const ContestResult&, const RunRecord&)> finished;
  /// Asked before each contest; once it is true no other begins.
  const std::atomic<bool>* stop = nullptr;
};

/// Races every contestant on every maze.
Race hold_race(std::vector<Contestant> mice, std::vector<NamedMaze> mazes, const RaceOrder& order,
               const RaceHooks& hooks = {});

/// How many contests such a race has.
std::size_t contests_of(const std::vector<Contestant>& mice, std::size_t mazes, const RaceOrder& order);

}  // namespace labmouse
