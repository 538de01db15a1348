// The geometry of infrared beams, for the simulation and for the controller.
#pragma once

#include <algorithm>
#include <cmath>

#include "labmouse/functions/angles.hpp"
#include "labmouse/functions/exponential.hpp"
#include "labmouse/functions/whole.hpp"
#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// Half the thickness of walls and posts in mm, for a cell of that side in mm: by the rules of all contests, walls are
/// a fifteenth of a cell thick.
constexpr double half_wall_of(double cell) { return cell / 30.0; }

/// Where a sensor looks, relative to the mouse.
enum class BeamSide { ahead, left, right };

/// A beam of 45 degrees and more looks to a side; 0.7854 rad are 45 degrees as well as 0.785.
inline BeamSide side_of(const Beam& beam) {
  constexpr double almost = 0.999;
  const Direction direction = direction_of(beam.angle);
  if (std::abs(direction.sine) < almost * direction.cosine) return BeamSide::ahead;
  return direction.sine > 0.0 ? BeamSide::left : BeamSide::right;
}

/// How far a sensor sits from the middle of the axle towards the side at which it looks, in mm; for one that looks
/// aside.
inline double out_of(const Beam& beam) { return side_of(beam) == BeamSide::left ? beam.aside : -beam.aside; }

/// The distance in mm that a beam goes to a wall from the middle of a cell: to the side wall, or to the front wall if
/// it looks ahead.
inline double calibrated_distance(const Beam& beam, double cell) {
  const double face = cell / 2.0 - half_wall_of(cell);
  const Direction direction = direction_of(beam.angle);
  if (side_of(beam) == BeamSide::ahead) return (face - beam.ahead) / direction.cosine;
  return (face - out_of(beam)) / std::abs(direction.sine);
}

/// How a ToF sensor is mounted in the direction of the side at which it looks, for a mouse that is in line with the
/// walls.
struct RangerMount {
  BeamSide side = BeamSide::ahead;
  double depth = 0.0;   ///< mm from the middle of the axle towards that side
  double cosine = 1.0;  ///< of the angle between the beam and that direction
  double along = 0.0;   ///< mm ahead, and the cosine of the angle between the beam and ahead
  double along_cosine = 1.0;
};

inline RangerMount mount_of(const Ranger& ranger) {
  const Beam& beam = ranger.beam;
  const Direction direction = direction_of(beam.angle);
  const BeamSide side = side_of(beam);
  const bool ahead = side == BeamSide::ahead;
  return {side, ahead ? beam.ahead : out_of(beam), ahead ? direction.cosine : std::abs(direction.sine), beam.ahead,
          direction.cosine};
}

/// How the reading of an infrared sensor falls with the distance to a wall at a right angle, without its limit.
class InfraredCurve {
 public:
  InfraredCurve() = default;
  InfraredCurve(const Infrared& sensor, double cell) : fall_(sensor.fall < 1.0 ? 0.0 : sensor.fall) {
    const double calibrated = calibrated_distance(sensor.beam, cell);
    constexpr double most = 100.0;
    gain_ = sensor.gain * (is_exponential() ? exp_of(std::clamp(calibrated / fall_, -most, most)) : square(calibrated));
  }

  /// Counts at that distance, in mm, of a wall that returns such a share of the light.
  double level(double distance, double returned = 1.0) const {
    const double gain = gain_ * returned;
    return is_exponential() ? gain * fading(distance / fall_) : gain / square(std::max(nearest, distance));
  }
  /// The distance in mm at which it reads so much.
  double distance(double level, double returned = 1.0) const {
    const double share = gain_ * returned / level;
    return is_exponential() ? fall_ * log_of(share) : std::sqrt(share);
  }
  /// The distance in mm over which the reading falls to 1/e, about that distance.
  double fall(double distance) const { return is_exponential() ? fall_ : std::max(nearest, distance) / 2.0; }

 private:
  static constexpr double nearest = 1.0;  ///< mm; nearer, an inverse square has no meaning

  bool is_exponential() const { return fall_ > 0.0; }

  double gain_ = 0.0;  ///< counts at distance 0, or counts times mm²
  double fall_ = 0.0;  ///< 0: inverse square
};

/// The share of its light that a wall returns, by the cosine of the angle of incidence: all of it near a right angle,
/// less where it is slanted.
constexpr double returned_at(double cosine) {
  constexpr double almost_right = 0.9;
  return cosine < almost_right ? cosine / almost_right : 1.0;
}

/// The variance of a reading, of which that level is expected, by what differs between walls, sensors and rooms; in
/// counts squared.
constexpr double reading_variance(const Variation& variation, double level) {
  return square(level) *
             (square(variation.reflectance) + square(variation.maze_reflectance) + square(variation.infrared_gain)) +
         square(variation.ambient);
}

}  // namespace labmouse
