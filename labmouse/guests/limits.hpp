// What a guest may take before it is ended.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace labmouse {

/// Limits of one guest in one contest. They hold off accidents, not malice: a guest runs with the rights of its user.
struct GuestLimits {
  /// From its start to its first word, in real time; an interpreter may have much to load.
  std::chrono::milliseconds start{10'000};
  /// From a question to its answer, or between two lines of a guest that asks itself: the guest's own processor time,
  /// so that a busy machine does not make it late. That of other processes that it starts is not counted.
  std::chrono::milliseconds decision{1'000};
  /// The same in real time, for those that wait or sleep.
  std::chrono::milliseconds silence{30'000};
  /// The whole contest, in real time.
  std::chrono::milliseconds contest{60'000};
  /// Processor time, in seconds.
  int processor_seconds = 120;
  /// Memory that each of its processes may write to, in bytes.
  std::uint64_t memory = std::uint64_t{4} << 30U;
  /// Bytes of one line of its output.
  std::size_t longest_line = 4096;
  /// Bytes of replies that it may leave unread.
  std::size_t most_unread = std::size_t{64} << 20U;
  /// Bytes of its standard error that are kept: the last ones.
  std::size_t kept_errors = 4096;
};

}  // namespace labmouse
