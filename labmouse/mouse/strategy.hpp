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
  /// For people: in the first line where it gave up, or what went wrong; then, of an external mouse, the last lines of
  /// its standard error.
  std::string_view last_words = {};
  /// The time of its decisions, if it measures that itself: a mouse in another process does, without the way there and
  /// back.
  std::optional<double> microseconds = std::nullopt;
  /// False of an external mouse whose program did not start, or ended before it greeted.
  bool started = true;
};

/// Decides what a mouse does. It is called and never calls, so one object serves a loop, a browser frame and an
/// interrupt.
class Strategy {
 public:
  virtual ~Strategy() = default;

  /// The next action, given the reading in the present pose. Called until the contest ends.
  virtual Action decide(const Sighting& seen) = 0;

  /// What the mouse knows, for viewers and tests.
  virtual const Knowledge& knowledge() const = 0;

  /// What it reports of itself: asked when it decides no more, and maybe again.
  virtual StrategyReport report() { return {}; }

  /// The reasons of the last decision; null unless it chose anew and its briefing asks for reasons.
  virtual const Reasons* reasons() const { return nullptr; }
};

}  // namespace labmouse
