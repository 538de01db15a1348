// How long a mouse may take: counted in its own time, which passes no faster on a busy machine.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "labmouse/external/process.hpp"

namespace labmouse {

/// The time of a mouse: processor time of it and all that it started, and the time in which none of them worked, was
/// ready to work or waited for a disk. It begins with the object.
class OwnTime {
 public:
  using Clock = ExternalProcess::Clock;

  explicit OwnTime(ExternalProcess& process) : last_(look(process)), begin_(last_.tree.worked) {}

  /// To be called several times a second.
  void advance(ExternalProcess& process);
  std::chrono::nanoseconds idle() const { return idle_; }
  /// Time of which nobody knows whether it was the mouse's own: it waited for a disk, or for something that the system
  /// does not tell.
  std::chrono::nanoseconds unknown() const { return unknown_; }
  std::chrono::nanoseconds passed() const { return idle_ + last_.tree.worked - begin_; }

 private:
  struct Look {
    Clock::time_point at;
    TreeTime tree;
    std::chrono::nanoseconds host_waited{};  ///< of us, who may have looked late
  };
  static Look look(ExternalProcess& process) { return {Clock::now(), process.tree_time(), waited_for_processor()}; }

  Look last_;
  std::chrono::nanoseconds begin_, idle_{}, unknown_{};
};

/// The time of a mouse over all of a contest. Short waits cost nothing but a look at the clock.
class ContestClock {
 public:
  using Clock = ExternalProcess::Clock;

  explicit ContestClock(Clock::duration limit)
      : limit_(limit), next_look_(Clock::now() + pause(Clock::duration(0))), host_waited_(waited_for_processor()) {}

  bool is_over(ExternalProcess& process);
  /// Whether it is over although nobody knows whether the mouse was slow.
  bool is_judged() const { return is_judged_; }
  /// The mouse was waited for, and was idle for some of that time as far as that was looked at.
  void add(Clock::duration waited, std::chrono::nanoseconds idle, std::chrono::nanoseconds unknown);

 private:
  Clock::duration pause(Clock::duration passed) const;
  Clock::duration passed(const TreeTime& tree) const;

  Clock::duration limit_, waited_{};
  std::chrono::nanoseconds idle_{}, unknown_{};
  Clock::time_point next_look_;
  std::chrono::nanoseconds host_waited_;
  bool is_over_ = false, is_judged_ = true;
};

/// The time between two signs of life of a mouse. Those that answer at once cost nothing: only once one has been silent
/// for a moment its time begins to be counted, from there on.
class Patience {
 public:
  using Clock = ExternalProcess::Clock;

  /// It may take so much of its own time, and its first process so much processor time; both from now on.
  Patience(Clock::duration silence, std::chrono::nanoseconds work);

  /// Waits for output, and gives up with `timeout` when either is over, or the contest.
  ExternalEvent wait(ExternalProcess& process, ContestClock& contest);

  /// Whether it has worked for longer than it may; to be asked when its answer is there, too.
  bool is_overworked(ExternalProcess& process);
  /// How long it worked when it was looked at last.
  std::chrono::nanoseconds worked() const { return worked_; }
  /// False where a timeout came although nobody knows whether the mouse was slow.
  bool is_judged() const;

 private:
  bool is_over() const;
  /// Counts its time up to now.
  void look(ExternalProcess& process, ContestClock& contest);
  Clock::duration pause() const;

  Clock::duration silence_;
  std::chrono::nanoseconds work_;
  Clock::time_point next_look_;
  std::optional<OwnTime> time_;  ///< once it was silent for a moment
  std::chrono::nanoseconds before_{}, worked_{};
};

/// "0.4 s".
std::string seconds_text(Patience::Clock::duration time);

}  // namespace labmouse
