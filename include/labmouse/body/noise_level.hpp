// The scale of a robot's noise.
#pragma once

#include <array>

#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// Factors of the hardware's noise: 1 as measured, 0 for none.
struct NoiseLevel {
  double all = 1.0;
  std::array<double, noise_groups> groups = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  /// Factor of the deviations of those numbers that are drawn once a contest for the mouse itself: the variation
  /// between mice and days.
  double variation = 1.0;

  double of(NoiseGroup group) const { return all * groups[static_cast<std::size_t>(group)]; }
};

}  // namespace labmouse
