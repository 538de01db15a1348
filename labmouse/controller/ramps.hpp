// Trapezoidal speed profile over a distance or an angle: constant acceleration, constant speed, constant braking.
#pragma once

#include <array>

namespace labmouse {

struct RampLimits {
  double speed = 0.0;  ///< mm/s or rad/s
  double acceleration = 0.0;
  double braking = 0.0;
};

class Ramps {
 public:
  Ramps() = default;
  /// The fastest profile over a length of 0 or more, from one speed to another. If the limits do not allow the final
  /// speed, it ends at the nearest speed that they allow.
  Ramps(double length, double from, double to, const RampLimits& limits);
  /// At one speed.
  Ramps(double length, double speed);

  double seconds() const;
  double length_at(double seconds) const;
  double speed_at(double seconds) const;

 private:
  struct Phase {
    double seconds = 0.0;
    double speed = 0.0;  ///< at its beginning
    double acceleration = 0.0;
  };
  std::array<Phase, 3> phases_{};
};

}  // namespace labmouse
