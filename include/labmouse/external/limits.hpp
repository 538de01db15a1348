// Limits of an external mouse; it is ended if it exceeds one.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace labmouse {

/// Limits of one external mouse in one contest. Those of memory, processes and written bytes are for it and all its
/// descendants together.
struct ExternalLimits {
  /// From its start to its first line, in its own time (patience.hpp); an interpreter may take long to load.
  std::chrono::milliseconds start{10'000};
  /// Processor time from a question to its answer, or between two lines of an mms program. It does not depend on the
  /// load of the machine. Time of processes that it starts is not counted.
  std::chrono::milliseconds decision{1'000};
  /// The same in its own time, for programs that wait or sleep.
  std::chrono::milliseconds silence{30'000};
  /// The whole contest, in its own time.
  std::chrono::milliseconds contest{60'000};
  /// Processor time, in seconds.
  int processor_seconds = 120;
  /// Memory in bytes that all of them hold together.
  std::uint64_t memory = std::uint64_t{4} << 30U;
  /// Processes at one time, at most 4096.
  int processes = 64;
  /// Bytes written to files and pipes; also the largest size of one file.
  std::uint64_t written = std::uint64_t{1} << 30U;
  /// Longest line of its output, bytes.
  std::size_t longest_line = 4096;
  /// Largest number of unread reply bytes.
  std::size_t most_unread = std::size_t{64} << 20U;
  /// Bytes of its standard error that are kept: the last ones.
  std::size_t kept_errors = 4096;
};

}  // namespace labmouse
