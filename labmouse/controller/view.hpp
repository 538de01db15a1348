// What a beam should meet, by where a mouse believes to be: the face of a line of walls.
#pragma once

#include <array>

#include "labmouse/controller/estimator.hpp"
#include "labmouse/grid/cell.hpp"
#include "labmouse/grid/heading.hpp"
#include "labmouse/hardware/hardware.hpp"

namespace labmouse {

/// The line of walls on one side of a row or column of cells, as beams meet it.
struct WallLine {
  Position out;       ///< one mm towards it
  Position on;        ///< one mm along it
  double face = 0.0;  ///< mm along `out` at which its face lies
};

/// That on a side of a cell of so many mm, whose length is measured along an axis across the side.
WallLine line_on(Cell cell, Heading side, Heading axis, double size);

/// Where a beam meets a line.
struct View {
  double distance = 0.0;  ///< mm from the sensor
  double along = 0.0;     ///< mm on the line
  double cosine = 1.0;    ///< of its incidence
};

/// How a view changes with x, y and the angle of a mouse.
struct ViewSlopes {
  std::array<double, 3> distance{};  ///< of the distance that a reading stands for
  std::array<double, 3> along{};
};

/// The beams of a mouse as it knows them.
class Views {
 public:
  Views(const Infrared& infrared, double cell);

  /// A beam against a line; false where it does not come towards it.
  bool see(std::size_t beam, const Position& position, const Direction& ahead, const WallLine& line, View& view) const;
  ViewSlopes slopes(std::size_t beam, const Direction& ahead, const WallLine& line, const View& view) const;
  /// Whether a beam looks to a side rather than ahead, and whether that is the left one.
  bool looks_aside(std::size_t beam) const { return aside_[beam]; }
  bool looks_left(std::size_t beam) const { return infrared_.beams[beam].angle > 0.0; }
  /// What a whole wall should read there, in counts, and how far a wall is that reads so much at that incidence.
  double level_of(std::size_t beam, const View& view) const;
  double distance_of(std::size_t beam, double level, const View& view) const;

 private:
  Position way_of(std::size_t beam, const Direction& ahead) const;

  const Infrared& infrared_;
  std::array<Direction, beam_count> directions_{};
  std::array<double, beam_count> gains_{};  ///< counts at no distance
  std::array<bool, beam_count> aside_{};
};

/// One mm in a heading.
Position way_in(Heading heading);
inline double dot(const Position& a, const Position& b) { return a.x * b.x + a.y * b.y; }

}  // namespace labmouse
