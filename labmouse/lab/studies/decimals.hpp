// The number of decimals that sweeps and ranges allow.
#pragma once

#include <cstddef>
#include <string_view>

namespace labmouse {

/// Largest number of decimals in a number of a sweep or a range.
inline constexpr std::size_t most_decimals = 6;

inline bool has_few_decimals(std::string_view number) {
  const auto point = number.find('.');
  return point == std::string_view::npos || number.size() - point - 1 <= most_decimals;
}

}  // namespace labmouse
