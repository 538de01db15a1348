// References for a mouse's score between it and the bound: what it could have had, had it known afterwards what it
// knew. They are no bounds: another mouse may score less. docs/explanation/statistics-and-bounds.md describes them.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The lowest score that a walk was good for: the minimum, over its steps after a goal was entered, of the score had
/// the mouse reset there and run the shortest route over the walls known open at that moment. What it would have seen
/// in that run counts for nothing; its own end counts with what it did score, so the result is not above its score.
/// Stops that the budget does not allow are left out, and a contest without any counts the rules' failure score.
double best_stop(const RunRecord& record, const Maze& maze, const Rules& rules);

/// `count` times the mouse with each of its whole and real parameters shifted by up to a quarter of its value, at least
/// by up to a hundredth of its declared range, evenly and within that range; flags, choices and lists stay. Variants
/// that come out equal, also to the mouse itself, stand once or not at all. Empty for a mouse without such parameters.
std::vector<Contestant> perturbed(const Contestant& mouse, int count, std::uint64_t seed);

struct HindsightOrder {
  Rules rules;
  /// Its world is always that of steps, under these rules.
  RaceOrder race;
  /// Perturbed variants or, for a mouse that is stochastic, further seeds; 0 for none.
  int others = 64;
};

/// One maze with a route. Means over the runs for a mouse that is stochastic; a failed contest counts the failure
/// score.
struct MazeHindsight {
  std::string maze;
  Bound bound;
  double score = 0.0;
  double best_stop = 0.0;
  /// The lowest score among the mouse's own contests and those of the others.
  std::optional<double> best_other;
  std::string best_mouse;       ///< the SPEC that scored it; empty where there are no others
  std::uint64_t best_seed = 0;  ///< with this seed
};

struct Hindsight {
  HindsightOrder order;
  std::string mouse;           ///< its SPEC
  bool is_stochastic = false;  ///< then the others are further seeds
  bool has_others = false;     ///< dice or numbers to perturb, and asked for
  std::vector<MazeHindsight> mazes;
  std::vector<std::string> routeless;  ///< mazes whose goal cannot be reached
  bool stopped = false;                ///< before all mazes were done; the one under way is left out
  std::string error;                   ///< why the mouse was refused; then nothing was raced
  std::string never_started;           ///< a line where its program did not start in the last maze, which ended it
};

/// What it tells while it goes on.
struct HindsightHooks {
  /// Called after each contest with the number of all, from any thread but never from two at once.
  std::function<void(std::size_t all)> finished;
  const std::atomic<bool>* stop = nullptr;
};

/// Races the mouse and the others in each maze. The mouse's own contests have the seeds that they have in a race.
Hindsight look_back(std::string_view spec, const std::vector<NamedMaze>& mazes, const HindsightOrder& order,
                    const HindsightHooks& hooks = {});

/// Means over the mazes; all of them 0 where there is none.
struct HindsightMeans {
  double bound = 0.0, score = 0.0, best_stop = 0.0;
  std::optional<double> best_other;
};
HindsightMeans means_of(const Hindsight& hindsight);

/// A table for a terminal, with notes below.
std::string table_of(const Hindsight& hindsight, bool colours);

/// The same for programs.
std::string json_of(const Hindsight& hindsight);

}  // namespace labmouse
