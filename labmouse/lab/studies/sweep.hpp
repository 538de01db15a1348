// One mouse at many values of one parameter: how much does its score depend on it? docs/how-to/tune.md describes the
// results.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/numbers/interval.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// What `NAME=LOW:HIGH:STEP` or `NAME=VALUE,VALUE,...` says, or the reason why a text is neither.
struct Variation {
  std::string parameter;
  /// As text; the values of a range are exact decimals: 0:1:0.1 has 0.3 and 1, and nothing beside them.
  std::vector<std::string> values;
  std::string error;
};

/// A sweep has at most so many values.
inline constexpr int most_values = 1000;

Variation read_variation(std::string_view text);

/// How the mouse did at one value, over all contests in mazes with a route.
struct SweepPoint {
  std::string value;  ///< as in a SPEC, in its one spelling
  int runs = 0;
  int failures = 0;
  /// Of the scores, a failed contest counted as the limit score of the world; nothing where no maze has a route.
  std::optional<double> mean;
  /// Over mazes; where only one maze has a route, over its runs; nothing where that is one number, too.
  std::optional<Interval> interval;
  /// Of the scores of finished contests alone; nothing without any.
  std::optional<double> finished_mean = std::nullopt;
};

struct Sweep {
  std::string mouse;  ///< the SPEC without the parameter; of an external mouse, as it is
  std::string parameter;
  std::string meaning;  ///< of the parameter; empty for that of an external mouse
  RaceOrder order;
  std::vector<std::string> mazes;  ///< names of those with a route
  int routeless = 0;               ///< mazes without one
  std::size_t values = 0;          ///< that were asked for
  std::vector<SweepPoint> points;  ///< in the order of the values; fewer where the sweep was stopped
  std::string never_started;       ///< a line for each value at which a program did not start in any contest
  std::string error;               ///< why the mouse or a value was refused; then nothing was raced
};

/// What a sweep tells while it goes on.
struct SweepHooks {
  /// Called after each contest with the number of all, from any thread but never from two at once.
  std::function<void(std::size_t all)> finished;
  /// Asked before each contest; once it is true no other begins, and the value that was under way is left out.
  const std::atomic<bool>* stop = nullptr;
};

/// Races the mouse of the SPEC at each value, each time on the same mazes with the same seeds. The world must refuse
/// none of these mice.
Sweep hold_sweep(std::string_view spec, const Variation& variation, const std::vector<NamedMaze>& mazes,
                 const RaceOrder& order, const SweepHooks& hooks = {}, const ExternalOptions& external_mice = {});

/// A table for a terminal, with notes below.
std::string table_of(const Sweep& sweep, bool colours);

/// One line a value, with a header.
std::string csv_of(const Sweep& sweep);

/// The mean with its interval against the value, as an SVG picture.
std::string picture_of(const Sweep& sweep);

}  // namespace labmouse
