// Points and ways in the plane of a maze.
#pragma once

namespace labmouse {

/// A point or a way in mm: x counts eastwards, y northwards, a point's from the south-western corner of the maze.
struct Position {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(const Position&, const Position&) = default;
  friend constexpr Position operator+(const Position& a, const Position& b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Position operator-(const Position& a, const Position& b) { return {a.x - b.x, a.y - b.y}; }
};

}  // namespace labmouse
