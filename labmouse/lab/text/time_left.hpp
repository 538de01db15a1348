// Estimates the remaining time of some work.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace labmouse {

/// Seconds left if the rest takes as long as the finished part. Nothing where too little is known: in the first second,
/// or before anything is done.
std::optional<double> seconds_left(std::size_t done, std::size_t all, double elapsed_seconds);

/// "12 s", "3 min 20 s", "2 h 05 min", "3 d 04 h": two units, rounded to the smaller one.
std::string duration_text(double seconds);

}  // namespace labmouse
