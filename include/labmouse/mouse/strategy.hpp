// The interface of every mouse.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/reasons.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// A number that a strategy keeps about its own work, for records: "nodes found".
struct Counter {
  std::string_view name;
  std::int64_t value = 0;
};

/// What a strategy reports of itself after a contest. Its texts and counters belong to the strategy.
struct StrategyReport {
  /// Under names that never change.
  std::span<const Counter> counters = {};
  /// Text for the user. The first line says where it gave up, or what went wrong. For an external mouse the last lines
  /// of its standard error follow.
  std::string_view last_words = {};
  /// The time of its decisions in microseconds, if it measures that itself. A mouse in another process does, without
  /// the time of communication.
  std::optional<double> microseconds = std::nullopt;
  /// False for an external mouse whose program did not start, or ended before its greeting.
  bool started = true;
};

/// Decides what a mouse does. It never calls back, so one object can run in a loop, a browser frame or an interrupt.
class Strategy {
 public:
  virtual ~Strategy() = default;

  /// Decides on the next action. Called until the contest ends.
  /// @param seen the reading in the present pose, in cells.
  /// @return a step, a reset, or a forfeit, which ends the contest. Which steps a world has is in motion.hpp and
  ///   search_motion.hpp.
  virtual Action decide(const Sighting& seen) = 0;

  /// The walls that the mouse knows, for viewers and tests.
  virtual const Knowledge& knowledge() const = 0;

  /// Its report, called after its last decision, maybe several times.
  virtual StrategyReport report() { return {}; }

  /// The reasons of the last decision; null if it made no new choice, or if its briefing does not ask for reasons.
  virtual const Reasons* reasons() const { return nullptr; }
};

}  // namespace labmouse
