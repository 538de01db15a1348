#include "labmouse/lab/text/time_left.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace labmouse {

std::optional<double> seconds_left(std::size_t done, std::size_t all, double elapsed_seconds) {
  if (done == 0 || elapsed_seconds < 1.0) return std::nullopt;
  const std::size_t rest = all - std::min(done, all);
  return elapsed_seconds * static_cast<double>(rest) / static_cast<double>(done);
}

std::string duration_text(double seconds) {
  constexpr std::int64_t minute = 60, hour = 60 * minute, day = 24 * hour;
  constexpr double longest = 1000.0 * static_cast<double>(day);
  const auto whole = std::llround(std::clamp(seconds, 0.0, longest));
  if (whole < minute) return fmt::format("{} s", whole);
  if (whole < hour) return fmt::format("{} min {:02} s", whole / minute, whole % minute);
  const auto minutes = (whole + minute / 2) / minute;
  if (minutes < day / minute) return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
  const auto hours = (whole + hour / 2) / hour;
  return fmt::format("{} d {:02} h", hours / 24, hours % 24);
}

}  // namespace labmouse
