// Limits of external mice that a file sets, and that override those of the command line.
#pragma once

#include <optional>

#include "labmouse/external/limits.hpp"

namespace labmouse {

/// The limits in a table `limits`; empty ones are not set there.
struct FileLimits {
  std::optional<double> start, decision, silence, contest;  ///< in seconds
  std::optional<int> memory, written;                       ///< in MiB
  std::optional<int> processes, processor_seconds;

  /// The limits given, overridden by those that the file sets.
  ExternalLimits over(ExternalLimits limits) const;
};

}  // namespace labmouse
