// How much of its noise a mouse has.
#pragma once

#include <array>

#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// Factors of the noise that the hardware has: 1 as it was measured, 0 none.
struct NoiseLevel {
  double all = 1.0;
  std::array<double, noise_groups> groups = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  /// Factor of what a contest draws of the mouse itself: how far mice and days are apart.
  double variation = 1.0;

  double of(NoiseGroup group) const { return all * groups[static_cast<std::size_t>(group)]; }
};

}  // namespace labmouse
