// The geometry of infrared beams, for the simulation and for the controller.
#pragma once

#include <cmath>

#include "labmouse/functions/angles.hpp"
#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// Half the thickness of walls and posts in mm, for a cell of that side in mm: by the rules of all contests, walls are
/// a fifteenth of a cell thick.
constexpr double half_wall_of(double cell) { return cell / 30.0; }

/// Whether a beam looks to a side rather than ahead.
inline bool looks_aside(const Beam& beam) {
  const Direction direction = direction_of(beam.angle);
  return std::abs(direction.sine) > direction.cosine;
}

/// The distance in mm that a beam goes to a wall from the middle of a cell: to the side wall, or to the front wall if
/// it looks ahead.
inline double calibrated_distance(const Beam& beam, double cell) {
  const double face = cell / 2.0 - half_wall_of(cell);
  const Direction direction = direction_of(beam.angle);
  return looks_aside(beam) ? (face - std::abs(beam.aside)) / std::abs(direction.sine)
                           : (face - beam.ahead) / direction.cosine;
}

/// The share of its light that a wall returns, by the cosine of the angle of incidence: all of it near a right angle,
/// less where it is slanted.
constexpr double returned_at(double cosine) {
  constexpr double almost_right = 0.9;
  return cosine < almost_right ? cosine / almost_right : 1.0;
}

/// The variance of a reading, of which that level is expected, by what differs between walls, sensors and rooms; in
/// counts squared.
constexpr double reading_variance(const Variation& variation, double level) {
  const auto square = [](double number) { return number * number; };
  return square(level) *
             (square(variation.reflectance) + square(variation.maze_reflectance) + square(variation.infrared_gain)) +
         square(variation.ambient);
}

}  // namespace labmouse
