// The scale of a contest's errors: noise, and variation between mice, mazes and days.
#pragma once

#include <array>

#include "labmouse/functions/named_number.hpp"
#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// Factors of the hardware's Noise and Variation: 1 as the robot's file states them, 0 for none.
struct ErrorScale {
  double noise = 1.0;      ///< factor of Noise, at least 0
  double variation = 1.0;  ///< factor of Variation, at least 0
  /// Further factors of both, by ErrorCause.
  std::array<double, error_causes> causes = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};

  /// The factor of the noise of a cause.
  /// @param cause one of the causes.
  /// @return at least 0; 0: this cause adds no noise.
  double noise_of(ErrorCause cause) const { return noise * causes[static_cast<std::size_t>(cause)]; }
  /// The factor of the variation of a cause.
  /// @param cause one of the causes.
  /// @return at least 0; 0: this cause does not vary.
  double variation_of(ErrorCause cause) const { return variation * causes[static_cast<std::size_t>(cause)]; }
};

/// No noise and no variation.
inline constexpr ErrorScale no_errors = {.noise = 0.0, .variation = 0.0};

/// Scales of the variation that have a name.
/// docs/explanation/physical-model.md#calibration says how the scales were chosen.
inline constexpr std::array variation_levels = {NamedNumber{"lab", 0.0}, NamedNumber{"practice", 0.5},
                                                NamedNumber{"contest", 1.0}, NamedNumber{"bad-day", 1.2}};

}  // namespace labmouse
