// How much of its noise a mouse has.
#pragma once

#include <array>

#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// Factors of the noise that the hardware has: 1 as it was measured, 0 none.
struct NoiseLevel {
  double all = 1.0;
  std::array<double, noise_groups> groups = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  /// How alike the contests of one mouse are not: each draws a factor e^(spread N) for all of its noise.
  double spread = 0.0;

  double of(NoiseGroup group) const { return all * groups[static_cast<std::size_t>(group)]; }
};

}  // namespace labmouse
