// How often a mouse planned anew, by its own count.
#pragma once

#include <cstdint>

#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// What a mouse counted as its plans, or 0.
inline std::int64_t plans_of(const Strategy& mouse) {
  for (const Counter& counter : mouse.counters())
    if (counter.name == "replanned") return counter.value;
  return 0;
}

}  // namespace labmouse
