#include "labmouse/lab/mice_files/file_limits.hpp"

#include <cmath>

namespace labmouse {
namespace {

void set_seconds(const std::optional<double>& seconds, std::chrono::milliseconds& limit) {
  constexpr double milliseconds = 1000.0;
  if (seconds) limit = std::chrono::milliseconds(std::llround(milliseconds * *seconds));
}

void set_mebibytes(const std::optional<int>& mib, std::uint64_t& limit) {
  constexpr int mib_bits = 20;
  if (mib) limit = static_cast<std::uint64_t>(*mib) << mib_bits;
}

}  // namespace

ExternalLimits FileLimits::over(ExternalLimits limits) const {
  set_seconds(start, limits.start);
  set_seconds(decision, limits.decision);
  set_seconds(silence, limits.silence);
  set_seconds(contest, limits.contest);
  set_mebibytes(memory, limits.memory);
  set_mebibytes(written, limits.written);
  limits.processes = processes.value_or(limits.processes);
  limits.processor_seconds = processor_seconds.value_or(limits.processor_seconds);
  return limits;
}

}  // namespace labmouse
