// Races one mouse at many values of one parameter, or with robots of many values, to show how its score depends on it.
// See docs/how-to/tune.md and docs/how-to/compare-two-variants.md for the results.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/numbers/interval.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/standings/mouse_pair.hpp"
#include "labmouse/lab/worlds/robot_variants.hpp"

namespace labmouse {

/// The parameter and the values of `NAME=LOW:HIGH:STEP` or `NAME=VALUE,VALUE,...`, or an error.
struct SweptValues {
  std::string parameter;
  /// As text. Values of a range are exact decimals: 0:1:0.1 has 0.3 and 1, without rounding errors.
  std::vector<std::string> values;
  std::string error;
};

/// Largest number of values in a sweep.
inline constexpr int most_values = 1000;

SweptValues read_swept_values(std::string_view text);

/// The result of the mouse at one value, over all contests in mazes with a route.
struct SweepPoint {
  std::string value;  ///< as in a SPEC, in its canonical form
  int runs = 0;
  int failures = 0;
  /// Mean score, where a failed contest counts as the world's limit score; nothing where no maze has a route.
  std::optional<double> mean;
  /// Confidence interval over mazes, or over runs where only one maze has a route; nothing for a single number.
  std::optional<Interval> interval;
  /// Mean score of the finished contests; nothing without any.
  std::optional<double> finished_mean = std::nullopt;
  /// Of a sweep of robots: the scores minus those with the first value, maze by maze. Nothing at the first value.
  std::optional<MousePair> against_first = std::nullopt;
};

/// The results of a sweep.
struct Sweep {
  std::string mouse;  ///< the SPEC without the parameter; for an external mouse the SPEC as given
  std::string robot;  ///< whose numbers are swept; empty if it is the mouse's parameter
  std::string parameter;
  std::string meaning;             ///< meaning of the parameter; empty for that of an external mouse
  RaceOrder order;                 ///< its world has the robot as it is
  std::vector<std::string> mazes;  ///< names of those with a route
  int routeless = 0;               ///< mazes without one
  std::size_t values = 0;          ///< number of requested values
  std::vector<SweepPoint> points;  ///< in the order of the values; fewer where the sweep was stopped
  std::string never_started;       ///< a line for each value at which a program never started
  std::string error;               ///< why the mouse or a value is invalid; then nothing was raced
};

/// Callbacks of a sweep.
struct SweepHooks {
  /// Called after each contest with the number of all contests; from any thread, but one at a time.
  std::function<void(std::size_t all)> finished;
  /// Read before each contest. Once it is true, no other begins, and the unfinished value is left out.
  const std::atomic<bool>* stop = nullptr;
};

/// Races the mouse of the SPEC at each value, always on the same mazes with the same seeds. The world must accept all
/// these mice.
Sweep hold_sweep(std::string_view spec, const SweptValues& chosen, const std::vector<NamedMaze>& mazes,
                 const RaceOrder& order, const SweepHooks& hooks = {}, const ExternalOptions& external_mice = {});

/// Races the mouse with each robot, always on the same mazes with the same seeds. The order's world must accept it.
Sweep hold_robot_sweep(const Contestant& mouse, const RobotVariants& robots, const std::vector<NamedMaze>& mazes,
                       const RaceOrder& order, const SweepHooks& hooks = {});

/// A table for a terminal, with notes below.
std::string table_of(const Sweep& sweep, bool colours);

/// JSON: docs/reference/results.md lists its fields.
std::string json_of(const Sweep& sweep);

/// CSV: a header and a line for each value.
std::string csv_of(const Sweep& sweep);

/// An SVG picture of the mean and its interval against the value.
std::string picture_of(const Sweep& sweep);

}  // namespace labmouse
