// What an external mouse may take before it is ended.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace labmouse {

/// Limits of one external mouse in one contest. Those of memory, processes and what is written are for it and all that
/// it started.
struct ExternalLimits {
  /// From its start to its first word, in real time; an interpreter may have much to load.
  std::chrono::milliseconds start{10'000};
  /// From a question to its answer, or between two lines of an external mouse that asks itself: the external mouse's
  /// own processor time, so that a busy machine does not make it late. That of other processes that it starts is not
  /// counted.
  std::chrono::milliseconds decision{1'000};
  /// The same in real time, for those that wait or sleep.
  std::chrono::milliseconds silence{30'000};
  /// The whole contest, in real time.
  std::chrono::milliseconds contest{60'000};
  /// Processor time, in seconds.
  int processor_seconds = 120;
  /// Memory in bytes: what all of them hold, and what each of them may ask for.
  std::uint64_t memory = std::uint64_t{4} << 30U;
  /// Processes at one time, at most 4096.
  int processes = 64;
  /// Bytes written to files and pipes; no file of its own may be longer either.
  std::uint64_t written = std::uint64_t{1} << 30U;
  /// Bytes of one line of its output.
  std::size_t longest_line = 4096;
  /// Bytes of replies that it may leave unread.
  std::size_t most_unread = std::size_t{64} << 20U;
  /// Bytes of its standard error that are kept: the last ones.
  std::size_t kept_errors = 4096;
};

}  // namespace labmouse
