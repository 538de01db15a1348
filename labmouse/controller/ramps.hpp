// A way or an angle that is driven with even acceleration, at an even speed, and with even braking.
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
  /// Over a length of 0 or more, from one speed to another, as fast as the limits allow. Where they do not allow it, it
  /// ends at the speed that is reached.
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
