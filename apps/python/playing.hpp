// Contests in steps of mice in Python, played where a race can leave them alone: in threads of their own, or in other
// processes. What a mouse did there is played again where the race is, unless that has its record. Other worlds ask a
// mouse decision by decision: live_strategy.hpp.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/strategy.hpp"
#include "python_mind.hpp"

namespace labmouse::python {

/// Kind, rotation, movement and reason, from one process to another of the same build.
using PackedAction = std::array<std::int32_t, 4>;

/// What a mouse did in a contest. One that was interrupted may have no actions.
struct Played {
  std::vector<PackedAction> actions;
  std::string last_words;
  bool started = true;
  double microseconds = 0.0;             ///< that its decisions took
  std::optional<RunRecord> record = {};  ///< of a contest in steps that came to its end in this process
};

/// What a mouse did whose process died, and why.
Played death(std::string words);

/// A contest on its way, for the thread that plays it and one that watches.
class Playing {
 public:
  /// From any thread: the mouse decides no more.
  void stop() { stop_ = true; }
  const std::atomic<bool>& stopped() const { return stop_; }

  void add(const Action& action, double microseconds);
  void end(std::string last_words, bool started);
  void keep(RunRecord record);
  /// Once: what was played so far.
  Played take();

 private:
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  Played played_;
};

/// Plays a contest in steps in this thread.
RunRecord play_in_steps(const std::shared_ptr<const MouseMaker>& maker, const Maze& maze, const Rules& rules,
                        std::uint64_t seed, Playing& playing);

/// Plays a contest in a thread of its own, and waits for its end. Once `stop`, which may be null, is true, the mouse
/// hears of it as Python's code hears of Ctrl-C; where it takes no notice, it is left behind in its thread: so `play`
/// must hold all that it needs. Not with the interpreter's lock.
Played play_apart(std::function<void(Playing&)> play, const std::atomic<bool>* stop);

/// A mind that does again what was played.
std::unique_ptr<Strategy> make_played_mind(Size size, Played played);

}  // namespace labmouse::python
