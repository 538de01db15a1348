// Points and vectors in the plane of a maze.
#pragma once

#include <array>

namespace labmouse {

/// A point or a vector in mm: x eastwards, y northwards. Points are measured from the south-western corner of the maze.
struct Position {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(const Position&, const Position&) = default;
  /// The sum of two vectors, or a point moved by a vector, in mm.
  friend constexpr Position operator+(const Position& a, const Position& b) { return {a.x + b.x, a.y + b.y}; }
  /// The difference of two vectors, or the vector from point b to point a, in mm.
  friend constexpr Position operator-(const Position& a, const Position& b) { return {a.x - b.x, a.y - b.y}; }
};

/// The unit vector of one of the eight directions.
/// @param eighths eighths of a turn clockwise from north, of either sign.
/// @return without unit: (0,1) for north; exact along the axes.
constexpr Position way_of_eighths(int eighths) {
  constexpr double half = 0.70710678118654752440;  // square root of 1/2
  constexpr std::array<double, 8> sines = {0.0, half, 1.0, half, 0.0, -half, -1.0, -half};
  return {sines[static_cast<unsigned>(eighths) % 8U], sines[static_cast<unsigned>(eighths + 2) % 8U]};
}

}  // namespace labmouse
