// Numbers as sweeps and ranges take them.
#pragma once

#include <cstddef>
#include <string_view>

namespace labmouse {

/// How many decimals a number of a sweep or a range may have.
inline constexpr std::size_t most_decimals = 6;

inline bool has_few_decimals(std::string_view number) {
  const auto point = number.find('.');
  return point == std::string_view::npos || number.size() - point - 1 <= most_decimals;
}

}  // namespace labmouse
