// How long a guest may take for an answer: at work in its own time, and silent in that of the wall.
#pragma once

#include <chrono>
#include <string>

#include "labmouse/guests/process.hpp"

namespace labmouse {

/// The time between two signs of life of a guest. Those that answer at once cost nothing: only once a guest has been
/// silent for a moment its work begins to be counted, from there on.
class Patience {
 public:
  using Clock = GuestProcess::Clock;

  /// It may be silent for so long, and work for so long meanwhile; both from now on.
  Patience(Clock::duration silence, std::chrono::nanoseconds work)
      : silence_(silence), work_(work), begin_(Clock::now()) {}

  /// Waits for output, and gives up with `timeout` when either is over, or at the end of the contest.
  GuestEvent wait(GuestProcess& process, Clock::time_point contest_end);

  /// Whether it has worked for longer than it may; to be asked when its answer is there, too.
  bool is_overworked(GuestProcess& process);
  /// How long it worked when it was looked at last.
  std::chrono::nanoseconds worked() const { return worked_; }

  Clock::duration silence() const { return silence_; }
  std::chrono::nanoseconds work() const { return work_; }

 private:
  Clock::duration silence_;
  std::chrono::nanoseconds work_;
  Clock::time_point begin_;
  bool counts_ = false;  ///< whether its work is counted
  std::chrono::nanoseconds before_{}, worked_{};
};

/// "0.4 s".
std::string seconds_text(Patience::Clock::duration time);

}  // namespace labmouse
