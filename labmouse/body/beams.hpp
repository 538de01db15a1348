// The readings of infrared beams and of a ToF sensor, from walls and posts.
//
// Method: a beam meets one line of the grid after the other. On each its spot of light has a Gaussian profile along the
// line. The share of it on walls and posts is returned; the rest goes on to the next line.
//
// Source of the exponential law (see Infrared in hardware.hpp) and its numbers: reflector and wall logs of a half-size
// mouse (kerikun11/micromouse-kerise-v4), docs/explanation/physical-model.md.
#pragma once

#include <vector>

#include "labmouse/body/field.hpp"
#include "labmouse/body/robot_sample.hpp"
#include "labmouse/functions/angles.hpp"
#include "labmouse/hardware/beam.hpp"
#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// Where a beam begins, and its direction.
struct Ray {
  Position from;
  Direction direction;
};

class Beams {
 public:
  /// All must outlive it.
  Beams(const Field& field, const Sensors& sensors, const RobotSample& robot_sample);

  /// The level of an infrared sensor in counts, before noise, of a mouse in that position and direction.
  double level(std::size_t sensor, const Position& position, const Direction& ahead) const;
  /// The distance from a ToF sensor to the first wall or post that it looks at, in mm; 0 if nothing is within its
  /// reach.
  double range(std::size_t sensor, const Position& position, const Direction& ahead) const;

 private:
  /// A line that a ray meets.
  struct Crossing {
    double distance = 0.0;    ///< from the ray's beginning
    double cosine = 0.0;      ///< of the angle of incidence
    int column = 0, row = 0;  ///< the cell that it comes from
    Heading side{};           ///< the side of that cell that it meets
    double along = 0.0;       ///< on that side, from the post at its western or southern end
    double low = 0.0;         ///< where that post is, and the one at the other end less a cell: 0 if in place
    double high = 0.0;
  };

  template <class Visit>
  void for_each_crossing(const Ray& ray, Visit visit) const;
  double share_of(const Crossing& crossing, double per_footprint) const;
  void displace(Crossing& crossing, bool upright, int step) const;

  const Field& field_;
  const Sensors& sensors_;
  const RobotSample& robot_sample_;
  struct Emitter {
    Direction direction;  ///< relative to ahead
    InfraredCurve curve;
    double factor = 1.0;         ///< of its gain
    double reach = 0.0;          ///< mm; a wall farther away returns less than half a count
    double per_footprint = 1.0;  ///< 1/mm
  };
  std::vector<Emitter> emitters_;   ///< of the infrared sensors
  std::vector<Direction> rangers_;  ///< of the ToF sensors, relative to ahead
};

}  // namespace labmouse
