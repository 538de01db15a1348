// Where a beam goes, as both its maker and its mouse know.
#pragma once

#include <cmath>

#include "labmouse/functions/angles.hpp"
#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// Half the thickness of walls and posts in cells of that many mm: the rules of all contests have a fifteenth of a
/// cell.
constexpr double half_wall_of(double cell) { return cell / 30.0; }

/// Whether it looks to a side rather than ahead.
inline bool looks_aside(const Beam& beam) {
  const Direction direction = direction_of(beam.angle);
  return std::abs(direction.sine) > direction.cosine;
}

/// How far a beam goes to a wall in the middle of a cell: the side wall, or for beams that look ahead the front wall.
inline double calibrated_distance(const Beam& beam, double cell) {
  const double face = cell / 2.0 - half_wall_of(cell);
  const Direction direction = direction_of(beam.angle);
  return looks_aside(beam) ? (face - std::abs(beam.aside)) / std::abs(direction.sine)
                           : (face - beam.ahead) / direction.cosine;
}

/// What share of its light comes back where a beam meets a wall, by the cosine of its incidence: all of it almost at a
/// right angle, less where it is slanted.
constexpr double returned_at(double cosine) {
  constexpr double almost_right = 0.9;
  return cosine < almost_right ? cosine / almost_right : 1.0;
}

}  // namespace labmouse
