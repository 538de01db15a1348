// Time limits of external mice, in a time that excludes waits for a busy machine.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "labmouse/external/process.hpp"

namespace labmouse {

/// Own time of a mouse since construction: processor time of its process tree, plus the time in which no process of it
/// ran, was ready to run or waited for a disk.
class OwnTime {
 public:
  using Clock = ExternalProcess::Clock;

  explicit OwnTime(ExternalProcess& process) : last_(look(process)), begin_(last_.tree.worked) {}

  /// Updates the time; call it several times a second.
  void advance(ExternalProcess& process);
  std::chrono::nanoseconds idle() const { return idle_; }
  /// Time that cannot be classified as its own or not: waits for a disk, or for unknown causes.
  std::chrono::nanoseconds unknown() const { return unknown_; }
  std::chrono::nanoseconds passed() const { return idle_ + last_.tree.worked - begin_; }

 private:
  struct Look {
    Clock::time_point at;
    TreeTime tree;
    std::chrono::nanoseconds host_waited{};  ///< wait of the calling thread for a processor
  };
  static Look look(ExternalProcess& process) { return {Clock::now(), process.tree_time(), waited_for_processor()}; }

  Look last_;
  std::chrono::nanoseconds begin_, idle_{}, unknown_{};
};

/// Own time of a mouse over a whole contest. Short waits only read the clock.
class ContestClock {
 public:
  using Clock = ExternalProcess::Clock;

  explicit ContestClock(Clock::duration limit)
      : limit_(limit), next_look_(Clock::now() + pause(Clock::duration(0))), host_waited_(waited_for_processor()) {}

  bool is_over(ExternalProcess& process);
  /// False if it is over without a decision whether the mouse was slow.
  bool is_judged() const { return is_judged_; }
  /// Adds a wait for the mouse, with the idle and the unclassified time measured in it.
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

/// Time limit for the next line of a mouse. A fast answer costs no measurement: own time is measured only after a first
/// short silence.
class Patience {
 public:
  using Clock = ExternalProcess::Clock;

  /// Limits, from now on: own time of the mouse, and processor time of its first process.
  Patience(Clock::duration silence, std::chrono::nanoseconds work);

  /// Waits for output. Returns `timeout` if one of the limits or that of the contest is reached.
  ExternalEvent wait(ExternalProcess& process, ContestClock& contest);

  /// Whether it exceeded the processor time; to be checked after an answer, too.
  bool is_overworked(ExternalProcess& process);
  /// False if a timeout came without a decision whether the mouse was slow.
  bool is_judged() const;

 private:
  bool is_over() const;
  /// Measures its time up to now.
  void look(ExternalProcess& process, ContestClock& contest);
  Clock::duration pause() const;

  Clock::duration silence_;
  std::chrono::nanoseconds work_;
  Clock::time_point next_look_;
  std::optional<OwnTime> time_;  ///< set after a first short silence
  std::chrono::nanoseconds before_{}, worked_{};
};

/// "0.4 s".
std::string seconds_text(Patience::Clock::duration time);

}  // namespace labmouse
