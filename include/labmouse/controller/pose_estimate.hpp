// Estimated pose of a mouse with its covariance: all that an estimator passes to the other parts of a controller.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/functions/angles.hpp"
#include "labmouse/functions/position.hpp"

namespace labmouse {

/// The estimated pose and motion of a mouse at one moment.
struct PoseEstimate {
  Position position;     ///< of the middle of the axle, mm
  Direction ahead;       ///< where it points: angle from east to the left
  double slip = 0.0;     ///< angle from `ahead` to the direction of motion, rad to the left
  double speed = 0.0;    ///< mm/s
  double turning = 0.0;  ///< rad/s to the left
  /// Of x, y (in mm) and the angle (in rad): 3×3. Only the upper triangle is used.
  std::array<std::array<double, 3>, 3> covariance{};

  /// Whether all numbers are within a million of their units, the slip within 1 rad, and the direction has length 1.
  /// False for NaN.
  bool is_valid() const {
    constexpr double most = 1e6, most_slip = 1.0, exact = 1e-3;
    const auto within = [](double number) { return number >= -most && number <= most; };
    bool all = within(position.x) && within(position.y) && std::abs(slip) <= most_slip && within(speed) &&
               within(turning) && std::abs(ahead.sine * ahead.sine + ahead.cosine * ahead.cosine - 1.0) <= exact;
    for (const auto& row : covariance)
      for (const double number : row) all = all && within(number);
    return all;
  }
  /// Direction of motion; exact for a slip up to 1/3 rad.
  Direction way() const { return turned_by(ahead, slip); }
  /// Variance of the sum of x, y and the angle with these weights.
  /// @param x weight of x, per mm.
  /// @param y weight of y, per mm.
  /// @param angle weight of the angle, per rad.
  /// @return in the square of the sum's unit; at least 0.
  double variance_of(double x, double y, double angle) const {
    const auto& p = covariance;
    return std::max(0.0, x * (x * p[0][0] + 2.0 * (y * p[0][1] + angle * p[0][2])) +
                             y * (y * p[1][1] + 2.0 * angle * p[1][2]) + angle * angle * p[2][2]);
  }
};

}  // namespace labmouse
