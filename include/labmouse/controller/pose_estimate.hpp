// Estimated pose of a mouse with its covariance: all that an estimator passes to the other parts of a controller.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/functions/angles.hpp"
#include "labmouse/functions/position.hpp"

namespace labmouse {

struct PoseEstimate {
  Position position;
  Direction ahead;       ///< where it points
  double slip = 0.0;     ///< angle from `ahead` to the direction of motion, rad to the left
  double speed = 0.0;    ///< mm/s
  double turning = 0.0;  ///< rad/s to the left
  /// Of x, y (in mm) and the angle (in rad). Only the upper triangle is used.
  std::array<std::array<double, 3>, 3> covariance{};

  /// Whether all numbers are within a million of their units, and the direction has length 1.
  bool is_valid() const {
    constexpr double most = 1e6, exact = 1e-3;
    const auto within = [](double number) { return number >= -most && number <= most; };
    bool all = within(position.x) && within(position.y) && within(slip) && within(speed) && within(turning) &&
               std::abs(ahead.sine * ahead.sine + ahead.cosine * ahead.cosine - 1.0) <= exact;
    for (const auto& row : covariance)
      for (const double number : row) all = all && within(number);
    return all;
  }
  /// Direction of motion.
  Direction way() const { return turned_by(ahead, slip); }
  /// Variance of the sum of x, y and the angle with these weights.
  double variance_of(double x, double y, double angle) const {
    const auto& p = covariance;
    return std::max(0.0, x * (x * p[0][0] + 2.0 * (y * p[0][1] + angle * p[0][2])) +
                             y * (y * p[1][1] + 2.0 * angle * p[1][2]) + angle * angle * p[2][2]);
  }
};

}  // namespace labmouse
