// Searches for better values of several parameters of a mouse at once. Each candidate races on the same mazes with the
// same seeds. See docs/how-to/tune.md for the results.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/numbers/evolution.hpp"
#include "labmouse/lab/numbers/interval.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/studies/parameter_range.hpp"

namespace labmouse {

/// The quantity to minimise, as a mean over the mazes with a route.
enum class Objective : std::uint8_t {
  score,  ///< mean of the scores, where a failed contest counts as the world's limit score
  ratio,  ///< mean of these scores, each divided by the maze's bound
};

/// The settings of a search.
struct TuneOrder {
  RaceOrder race;
  int evaluations = 0;  ///< largest number of evaluated candidates, including the mouse as given; at least 1
  int population = 0;   ///< candidates in each generation; 0: the default of CMA-ES
  double step = 0.2;    ///< initial step size, as a share of each range
  Objective objective = Objective::score;
};

/// One candidate and its result.
struct Evaluation {
  int generation = 0;               ///< 0 for the mouse as given
  double step = 0.0;                ///< step size of its generation; 0 for the mouse as given
  std::string mouse;                ///< its SPEC
  std::vector<std::string> values;  ///< of the tuned parameters, as in the SPEC
  double value = 0.0;               ///< the objective; infinite where no maze has a value in `by_maze`
  int failures = 0;                 ///< contests that did not finish, in mazes with a route
  /// The values whose mean is the objective, by the position of the maze; nothing where no contest counts.
  std::vector<std::optional<double>> by_maze;
};

/// The results of a search.
struct Tune {
  TuneOrder order;
  std::vector<ParameterRange> ranges;
  std::size_t mazes = 0;                ///< with a route
  int routeless = 0;                    ///< mazes without one
  std::vector<Evaluation> evaluations;  ///< in their order, the mouse as given first
  bool stopped = false;                 ///< stopped before all evaluations were done
  std::string error;                    ///< why nothing was raced; empty if something was
};

/// Callbacks of a search.
struct TuneHooks {
  /// Called after each contest with the expected number of all contests; from any thread, but one at a time.
  std::function<void(std::size_t all)> finished;
  /// Called after each generation.
  std::function<void(const Tune&)> generation;
  /// Read before each contest. Once it is true, no other begins. Candidates with unfinished contests are left out.
  const std::atomic<bool>* stop = nullptr;
};

/// Searches from the values in the SPEC, moved into their ranges. A candidate that was raced before counts as an
/// evaluation but is not raced again. The last generation may be smaller.
Tune hold_tune(std::string_view spec, const std::vector<ParameterRange>& ranges, const std::vector<NamedMaze>& mazes,
               const TuneOrder& order, const TuneHooks& hooks = {});

/// The evaluation with the lowest value; the first one among equals. `tune` must have evaluations.
const Evaluation& best_of(const Tune& tune);

/// The best candidate against the mouse as given, maze by maze: value of the best minus value of the given one.
struct Gain {
  double mean = 0.0;
  std::optional<Interval> interval;  ///< over the mazes; nothing for a single one
  int better = 0, equal = 0, worse = 0;
};
Gain gain_of(const Tune& tune);

/// A report for a terminal; its last line is the SPEC of the best.
std::string table_of(const Tune& tune, bool colours);

/// CSV: a header and a line for each evaluation.
std::string csv_of(const Tune& tune);

/// An SVG picture of the mean and the best of each generation against the number of evaluations.
std::string picture_of(const Tune& tune);

}  // namespace labmouse
