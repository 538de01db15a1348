// What an infrared beam should meet by the estimated pose: the face of a line of walls.
#pragma once

#include <array>
#include <vector>

#include "labmouse/controller/estimator.hpp"
#include "labmouse/grid/cell.hpp"
#include "labmouse/grid/heading.hpp"
#include "labmouse/hardware/beam.hpp"

namespace labmouse {

/// The line of walls on one side of a row or column of cells, as beams meet it.
struct WallLine {
  Position out;       ///< unit vector towards it
  Position on;        ///< unit vector along it
  double face = 0.0;  ///< coordinate of its face along `out`, mm
};

/// The wall line on a side of a cell of `size` mm. `axis` is the direction along the line.
WallLine line_on(Cell cell, Heading side, Heading axis, double size);

/// Where a beam meets a line.
struct View {
  double distance = 0.0;  ///< mm from the sensor
  double along = 0.0;     ///< mm along the line
  double cosine = 1.0;    ///< of the angle of incidence
};

/// Derivatives of a view by x, y and the angle of the mouse.
struct ViewSlopes {
  std::array<double, 3> distance{};  ///< of the distance inferred from the reading
  std::array<double, 3> along{};
};

/// The controller's model of the infrared sensors.
class Views {
 public:
  Views(const std::vector<Infrared>& sensors, double cell);

  /// Computes where a sensor's beam meets a line; false if it does not, or too obliquely.
  bool see(std::size_t sensor, const Position& position, const Direction& ahead, const WallLine& line,
           View& view) const;
  ViewSlopes slopes(std::size_t sensor, const Direction& ahead, const WallLine& line, const View& view) const;
  BeamSide side(std::size_t sensor) const { return sensors_[sensor].side; }
  /// The cosine of a beam's angle of incidence where the mouse is in line with the walls.
  double cosine_in_line(std::size_t sensor) const;
  /// How much the evidence of a sensor counts: all sensors of a side see how bright its wall is, so more than two
  /// count as two.
  double share_of(std::size_t sensor) const;
  /// How many sensors look to that side.
  int count_of(BeamSide side) const;
  /// Expected reading of a whole wall, in counts, and the inverse: the distance (mm) of a wall with that reading.
  double level_of(std::size_t sensor, const View& view) const;
  double distance_of(std::size_t sensor, double level, const View& view) const;
  /// See InfraredCurve.
  double fall_of(std::size_t sensor, const View& view) const { return sensors_[sensor].curve.fall(view.distance); }

 private:
  struct Mounted {
    Beam beam;
    Direction direction;  ///< relative to ahead
    BeamSide side = BeamSide::ahead;
    InfraredCurve curve;
    double most = 0.0;  ///< counts
  };

  Position way_of(std::size_t sensor, const Direction& ahead) const;

  std::vector<Mounted> sensors_;
};

/// The side of a cell at which a sensor looks, of a mouse with that heading.
Heading side_in(Heading heading, BeamSide side);
/// Unit vector of a heading.
Position way_in(Heading heading);
inline double dot(const Position& a, const Position& b) { return a.x * b.x + a.y * b.y; }

}  // namespace labmouse
