// The half-cell grid of mms, for mice that move by half cells and turn by 45 degrees.
//
//      y
//      2 o---|---o
//      1 |   +   |
//      0 o---|---o
//        0   1   2  x
//
// The diagram shows cell (0,0) and its walls. Both coordinates odd: the centre of a cell. One of them even: the middle
// of a wall. Both even: a post, where no mouse goes.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <string_view>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// A direction on the half grid. The values count eighths of a turn clockwise from north.
enum class Compass : std::uint8_t { north, north_east, east, south_east, south, south_west, west, north_west };

constexpr std::string_view name_of(Compass heading) {
  constexpr std::array<std::string_view, 8> names = {"north", "north-east", "east", "south-east",
                                                     "south", "south-west", "west", "north-west"};
  return names[static_cast<unsigned>(heading)];
}

/// The direction after `eighths` clockwise turns of 45 degrees (negative: counter-clockwise).
constexpr Compass turned(Compass heading, int eighths) {
  return static_cast<Compass>((static_cast<unsigned>(heading) + static_cast<unsigned>(eighths)) & 7U);
}
/// The heading of a direction; of a diagonal, the next one anticlockwise.
constexpr Heading heading_of(Compass direction) { return static_cast<Heading>(static_cast<unsigned>(direction) / 2); }
constexpr bool is_diagonal(Compass heading) { return (static_cast<unsigned>(heading) & 1U) != 0; }

/// A place on the half grid, in half cells from the south-west corner: 0 to twice the width, 0 to twice the height.
struct HalfPlace {
  int x = 1;
  int y = 1;

  friend constexpr bool operator==(HalfPlace, HalfPlace) = default;
};

/// Place and heading of an mms mouse. In mms it starts at the centre of (0,0), heading north, whatever the maze file
/// says.
struct HalfPose {
  HalfPlace place;
  Compass heading = Compass::north;

  friend constexpr bool operator==(const HalfPose&, const HalfPose&) = default;
};

/// The place one half step away: half a cell, or from one wall to the next where the direction is diagonal.
constexpr HalfPlace half_step(HalfPlace place, Compass direction) {
  constexpr std::array<int, 8> dx = {0, 1, 1, 1, 0, -1, -1, -1};
  constexpr std::array<int, 8> dy = {1, 1, 0, -1, -1, -1, 0, 1};
  const auto side = static_cast<unsigned>(direction);
  return {place.x + dx[side], place.y + dy[side]};
}

/// The cell that a place belongs to: on a wall, the cell to its east or north.
constexpr Cell cell_of(HalfPlace place) { return {place.x / 2, place.y / 2}; }

/// Whether half a step from a place, which must lie inside of the border, leads into a wall or a post.
/// @param is_open Whether a side of a cell is open, as Maze::is_open() has it.
template <class IsOpen>
bool blocked_by(IsOpen is_open, HalfPlace place, Compass direction) {
  const HalfPlace next = half_step(place, direction);
  assert(next.x >= 0 && next.y >= 0);
  const bool on_column = next.x % 2 == 0, on_row = next.y % 2 == 0;
  if (on_column && on_row) return true;
  if (!on_column && !on_row) return false;
  return !is_open(cell_of(next), on_column ? Heading::west : Heading::south);
}
inline bool blocked(const Maze& maze, HalfPlace place, Compass direction) {
  return blocked_by([&](Cell cell, Heading side) { return maze.is_open(cell, side); }, place, direction);
}

/// The goals of mms: the centre cells, whatever the maze file marks.
inline CellSet mms_goals(Size size) { return centre_of(size); }

/// The maze with the fixed start and goals of mms.
inline Maze as_in_mms(const Maze& maze) {
  return maze.with_start({0, 0}, Heading::north).with_goals(mms_goals(maze.size()));
}

}  // namespace labmouse
