// What a process and all that it started hold together.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>

#include "labmouse/external/limits.hpp"

namespace labmouse {

/// The sums over a tree of processes, as far as the system tells.
struct Holdings {
  int processes = 0;
  /// Bytes that each has for itself, or shares with others that count them too.
  std::uint64_t memory = 0;
  /// Bytes written to files and pipes, by those that have ended, too.
  std::uint64_t written = 0;
  /// It ended with these processes: there are more than are counted.
  bool is_full = false;
};

/// The processes that descend from `root`, which itself counts only for what it and the ended ones wrote. Stops after
/// `most` of them. Allocates nothing and takes no lock. `shares`: memory in common is divided among those that have it,
/// which takes the system a thousand times as long.
Holdings survey(pid_t root, int most, bool shares);

/// What a tree of processes did with its time, as far as the system tells.
struct TreeTime {
  /// Processor time, of those that have ended, too.
  std::chrono::nanoseconds worked{};
  /// What of it was the work of processes that have ended: how long those waited nobody knows.
  std::chrono::nanoseconds worked_before{};
  /// How long its threads, those that have not ended, were ready to run and no processor was free.
  std::chrono::nanoseconds waited{};
  /// Whether one of them is at work now, or ready, or waits for a disk.
  bool is_busy = false;
};

/// The sums over the processes that descend from `root`, which itself does not count. Allocates nothing.
TreeTime time_of_tree(pid_t root);

/// How long the calling thread was ready to run and no processor was free.
std::chrono::nanoseconds waited_for_processor();

/// Ends the processes that descend from `root`, up to 4096 of them, parents first: one that was told to end has no more
/// children. Those of parents that ended meanwhile may be left; they come to be children of who takes them. False where
/// one of them is of another user and may not be ended, or where the system does not tell who they are.
bool kill_descendants(pid_t root);

/// The limit that the tree has passed.
enum class TreeLimit : int { none, processes, memory, written };

/// Looks at the tree now and then, and the more seldom the longer a look takes.
class TreeWatch {
 public:
  TreeWatch(pid_t root, const ExternalLimits& limits) : root_(root), limits_(limits) {}

  TreeLimit look();
  /// How long to wait for the next look, in milliseconds.
  int pause() const { return pause_; }

 private:
  pid_t root_;
  const ExternalLimits& limits_;
  int pause_ = quick;

  static constexpr int quick = 20, slow = 250;
};

}  // namespace labmouse
