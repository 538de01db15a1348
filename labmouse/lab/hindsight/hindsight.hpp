// Reference values between a mouse's score and the bound: what it could have scored, had it known at the start what it
// knew at the end. They are not bounds: another mouse may score less. docs/explanation/statistics-and-bounds.md
// describes them.
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

/// The lowest score that this search run allowed: the minimum over its steps after a goal was entered. For each, the
/// mouse resets there and runs the shortest route over the walls then known to be open. Walls seen during that run are
/// ignored. The score of the record is a candidate, too, so the result is never above it. Resets beyond the step budget
/// are left out. A contest without a score and without such a reset gives the failure score.
double best_stop(const RunRecord& record, const Maze& maze, const Rules& rules);

/// Up to `count` variants of the mouse. In each, every numeric parameter is shifted at random, except those for the
/// world of seconds. The shift is uniform, up to a quarter of the value or a hundredth of the range, whichever is more;
/// the result is kept within the range. Other parameters stay. Duplicates, and variants equal to the mouse, are left
/// out. Empty for a mouse without such parameters.
std::vector<Contestant> perturbed(const Contestant& mouse, int count, std::uint64_t seed);

struct HindsightOrder {
  Rules rules;
  /// Its world is ignored: it is always that of steps with `rules`.
  RaceOrder race;
  /// Number of perturbed variants or, for a stochastic mouse, of further seeds.
  int others = 64;
};

/// Results in one maze with a route. For a stochastic mouse they are means over the runs; a failed contest counts as
/// the failure score.
struct MazeHindsight {
  std::string maze;
  Bound bound;
  double score = 0.0;
  double best_stop = 0.0;
  /// The lowest score among the mouse's own contests and those of the others.
  std::optional<double> best_other;
  std::string best_mouse;       ///< the SPEC that scored it; empty where there are no others
  std::uint64_t best_seed = 0;  ///< the seed with which it scored that
};

struct Hindsight {
  HindsightOrder order;
  std::string mouse;           ///< its SPEC
  bool is_stochastic = false;  ///< the others are then further seeds
  bool has_others = false;     ///< whether others were requested, and the mouse is stochastic or has numeric parameters
  std::vector<MazeHindsight> mazes;
  std::vector<std::string> routeless;  ///< mazes whose goal cannot be reached
  bool stopped = false;                ///< whether it was stopped early; the maze in progress is left out
  std::string error;                   ///< why the mouse was refused, so that there are no contests
  std::string never_started;  ///< message if its program did not start in the last maze; the rest was then not run
};

/// Progress and interruption.
struct HindsightHooks {
  /// Called after each contest with the total number of contests, from any thread but never from two at once.
  std::function<void(std::size_t all)> finished;
  const std::atomic<bool>* stop = nullptr;
};

/// Races the mouse and the others in each maze. The mouse's own contests have the same seeds as in a race.
Hindsight look_back(std::string_view spec, const std::vector<NamedMaze>& mazes, const HindsightOrder& order,
                    const HindsightHooks& hooks = {});

/// Means over the mazes; 0 without mazes.
struct HindsightMeans {
  double bound = 0.0, score = 0.0, best_stop = 0.0;
  std::optional<double> best_other;
};
HindsightMeans means_of(const Hindsight& hindsight);

/// A table for a terminal, with notes below.
std::string table_of(const Hindsight& hindsight, bool colours);

/// The same as JSON.
std::string json_of(const Hindsight& hindsight);

}  // namespace labmouse
