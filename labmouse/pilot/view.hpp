// What a beam should meet, by where a mouse believes to be: the face of a line of walls.
#pragma once

#include <array>

#include "labmouse/grid/cell.hpp"
#include "labmouse/grid/heading.hpp"
#include "labmouse/hardware/hardware.hpp"
#include "labmouse/pilot/estimator.hpp"

namespace labmouse {

/// Where a beam meets the line on one side of a row or column of cells.
struct View {
  double distance = 0.0;                ///< mm from the sensor
  double along = 0.0;                   ///< mm on that line, in the direction of `axis`
  std::array<double, 3> distance_by{};  ///< how both change with x, y and the angle
  std::array<double, 3> along_by{};
  double cosine = 1.0;  ///< of its incidence
};

/// The beams of a mouse as it knows them.
class Views {
 public:
  Views(const Infrared& infrared, double cell);

  /// A beam against the line on that side of a cell, whose length is measured along an axis across it. False where the
  /// beam does not come towards it.
  bool see(std::size_t beam, const Position& position, const Direction& ahead, Cell cell, Heading side, Heading axis,
           View& view) const;
  /// Whether a beam looks to a side rather than ahead, and whether that is the left one.
  bool looks_aside(std::size_t beam) const { return aside_[beam]; }
  bool looks_left(std::size_t beam) const { return infrared_.beams[beam].angle > 0.0; }
  /// What a whole wall at that distance should read, in counts, and how far a wall is that reads so much.
  double level_at(std::size_t beam, double distance) const;
  double distance_of(std::size_t beam, double level) const;

 private:
  const Infrared& infrared_;
  double cell_;
  std::array<Direction, beam_count> directions_{};
  std::array<double, beam_count> calibrated_{};
  std::array<bool, beam_count> aside_{};
};

/// One mm in a heading.
Position way_in(Heading heading);
inline double dot(const Position& a, const Position& b) { return a.x * b.x + a.y * b.y; }

/// Where the faces of walls and the middles of lines lie: the number of the line on a side of a cell, times the cell.
double line_at(Cell cell, Heading side, double size);

}  // namespace labmouse
