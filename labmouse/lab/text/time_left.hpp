// How much longer some work will take, from the part that is done.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace labmouse {

/// Seconds left, if the rest goes as fast as what is done; nothing as long as too little is done to say: less than a
/// second or nothing at all.
std::optional<double> seconds_left(std::size_t done, std::size_t all, double elapsed_seconds);

/// "12 s", "3 min 20 s", "2 h 05 min", "3 d 04 h": two units, rounded to the smaller one.
std::string duration_text(double seconds);

}  // namespace labmouse
