// Where a path leads whose direction is known at each distance.
#pragma once

#include <array>

#include "labmouse/functions/angles.hpp"

namespace labmouse {

/// Moves a point along a path between two distances within which the angle is one smooth function. Gauss-Legendre
/// quadrature with eight points: exact to rounding for up to half a circle.
/// @param angle_at the direction of the path at a distance, in rad to the left.
/// @param point with members `ahead` and `aside`, in the unit of the distances.
template <class AngleAt, class Point>
void move_along(const AngleAt& angle_at, double from, double to, Point& point) {
  struct Sample {
    double place, weight;
  };
  constexpr std::array<Sample, 4> samples = {{{0.1834346424956498, 0.3626837833783620},
                                              {0.5255324099163290, 0.3137066458778873},
                                              {0.7966664774136267, 0.2223810344533745},
                                              {0.9602898564975363, 0.1012285362903763}}};
  const double middle = (from + to) / 2.0, reach = (to - from) / 2.0;
  for (const Sample& sample : samples)
    for (const double side : {-1.0, 1.0}) {
      const Direction direction = direction_of(angle_at(middle + side * sample.place * reach));
      point.ahead += sample.weight * reach * direction.cosine;
      point.aside += sample.weight * reach * direction.sine;
    }
}

}  // namespace labmouse
