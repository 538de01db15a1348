// A search for better values of several parameters of a mouse at once: each candidate races on the same mazes with the
// same seeds. docs/how-to/tune.md describes the results.
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

/// What is made as low as possible: the mean over the mazes with a route of
enum class Objective : std::uint8_t {
  score,  ///< the score, a failed contest counted as the limit score of the world
  ratio,  ///< the same over the maze's bound
};

struct TuneOrder {
  RaceOrder race;
  int evaluations = 0;  ///< candidates in all, the mouse as given among them; at least 1
  int population = 0;   ///< candidates a generation; 0 takes the method's usual number
  double step = 0.2;    ///< the first step size, as a share of each range
  Objective objective = Objective::score;
};

/// One candidate and how it did.
struct Evaluation {
  int generation = 0;               ///< 0 for the mouse as given
  double step = 0.0;                ///< step size of its generation; 0 for the mouse as given
  std::string mouse;                ///< its SPEC
  std::vector<std::string> values;  ///< of the tuned parameters, as in the SPEC
  double value = 0.0;               ///< the objective; infinite where no contest counts
  int failures = 0;                 ///< contests that did not end in the goal, in mazes with a route
  /// What the objective is the mean of, by the position of the maze; nothing where no contest counts in it.
  std::vector<std::optional<double>> by_maze;
};

struct Tune {
  TuneOrder order;
  std::vector<ParameterRange> ranges;
  std::size_t mazes = 0;                ///< with a route
  int routeless = 0;                    ///< mazes without one
  std::vector<Evaluation> evaluations;  ///< in their order, the mouse as given first
  bool stopped = false;                 ///< before all evaluations were done
  std::string error;                    ///< why nothing was raced
};

/// What a search tells while it goes on.
struct TuneHooks {
  /// Called after each contest with the number of all that are to be expected, from any thread but never from two at
  /// once.
  std::function<void(std::size_t all)> finished;
  /// Called after each generation.
  std::function<void(const Tune&)> generation;
  /// Asked before each contest; once it is true no other begins. Candidates whose contests are not all done are left
  /// out.
  const std::atomic<bool>* stop = nullptr;
};

/// Searches from the values that the SPEC says, each at the nearest in its range. A candidate that was raced before
/// counts as an evaluation and is not raced again. The last generation may be smaller than the others.
Tune hold_tune(std::string_view spec, const std::vector<ParameterRange>& ranges, const std::vector<NamedMaze>& mazes,
               const TuneOrder& order, const TuneHooks& hooks = {});

/// The lowest of a search that has evaluations, the first among equals.
const Evaluation& best_of(const Tune& tune);

/// The best against the mouse as given, maze by maze, best minus given.
struct Gain {
  double mean = 0.0;
  std::optional<Interval> interval;  ///< over the mazes; nothing for a single one
  int better = 0, equal = 0, worse = 0;
};
Gain gain_of(const Tune& tune);

/// A report for a terminal; its last line is the SPEC of the best.
std::string table_of(const Tune& tune, bool colours);

/// One line an evaluation, with a header.
std::string csv_of(const Tune& tune);

/// Mean and best of each generation against the evaluations, as an SVG picture.
std::string picture_of(const Tune& tune);

}  // namespace labmouse
