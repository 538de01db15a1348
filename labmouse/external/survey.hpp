// Measures the resources and times of a process tree, from /proc.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>

#include "labmouse/external/limits.hpp"

namespace labmouse {

/// Sums over a process tree, as far as the system reports them.
struct Holdings {
  int processes = 0;
  /// Bytes of private and shared memory; without `shares`, shared memory counts in each process.
  std::uint64_t memory = 0;
  /// Bytes written to files and pipes, including those of ended processes.
  std::uint64_t written = 0;
  /// There are more processes than were counted.
  bool is_full = false;
};

/// Measures the descendants of `root`, which itself counts only for what it and ended processes wrote. Stops after
/// `most` processes. Allocates nothing and takes no lock. `shares`: divides shared memory among its users, which takes
/// the system a thousand times as long.
Holdings survey(pid_t root, int most, bool shares);

/// Times of a process tree, as far as the system reports them.
struct TreeTime {
  /// Processor time, including that of ended processes.
  std::chrono::nanoseconds worked{};
  /// The part of it from ended processes, whose waiting time is unknown.
  std::chrono::nanoseconds worked_before{};
  /// Time in which its living threads were ready to run, but had no processor.
  std::chrono::nanoseconds waited{};
  /// Whether a thread is running, ready, or waiting for a disk now.
  bool is_busy = false;
};

/// The sums over the processes that descend from `root`, which itself does not count. Allocates nothing.
TreeTime time_of_tree(pid_t root);

/// Time in which the calling thread was ready to run, but had no processor.
std::chrono::nanoseconds waited_for_processor();

/// Kills the descendants of `root`, up to 4096, parents first, so that killed ones start no more children. Orphans of
/// parents that ended meanwhile may be left; they become children of the subreaper. False if a process must not be
/// killed because it belongs to another user, or if the system does not list them.
bool kill_descendants(pid_t root);

/// A limit of a process tree.
enum class TreeLimit : int { none, processes, memory, written };

/// Checks the limits of a process tree. After a slow check, the next pause is longer.
class TreeWatch {
 public:
  TreeWatch(pid_t root, const ExternalLimits& limits) : root_(root), limits_(limits) {}

  TreeLimit look();
  /// Pause before the next check, ms.
  int pause() const { return pause_; }

 private:
  pid_t root_;
  const ExternalLimits& limits_;
  int pause_ = quick;

  static constexpr int quick = 20, slow = 250;
};

}  // namespace labmouse
