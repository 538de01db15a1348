// The four headings, turns between them, and the neighbours of a cell.
//
//            north (y + 1)
//               |
//   west -------+------- east (x + 1)
//               |
//             south
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "labmouse/grid/cell.hpp"

namespace labmouse {

/// A direction in the maze. The values count quarter turns clockwise from north.
enum class Heading : std::uint8_t { north, east, south, west };

/// All headings, clockwise from north.
inline constexpr std::array all_headings = {Heading::north, Heading::east, Heading::south, Heading::west};

/// The heading after a turn.
/// @param heading before the turn.
/// @param quarters clockwise quarter turns, of any size; negative: counter-clockwise.
constexpr Heading turned(Heading heading, int quarters) {
  return static_cast<Heading>((static_cast<unsigned>(heading) + static_cast<unsigned>(quarters)) & 3U);
}
/// The heading after a quarter turn to the left.
/// @param heading before the turn.
constexpr Heading left_of(Heading heading) { return turned(heading, -1); }
/// The heading after a quarter turn to the right.
/// @param heading before the turn.
constexpr Heading right_of(Heading heading) { return turned(heading, 1); }
/// The heading after a half turn.
/// @param heading before the turn.
constexpr Heading opposite(Heading heading) { return turned(heading, 2); }

/// Clockwise quarter turns that lead from one heading to another.
/// @param from the heading before them.
/// @param to the heading after them.
/// @return 0 to 3.
constexpr int quarters_between(Heading from, Heading to) {
  return static_cast<int>((static_cast<unsigned>(to) - static_cast<unsigned>(from)) & 3U);
}

/// The heading as an angle.
/// @param heading one of the four.
/// @return eighths of a turn clockwise from north: 0, 2, 4 or 6.
constexpr int eighths(Heading heading) { return 2 * static_cast<int>(heading); }

/// Change of x and y from a cell to its neighbour, indexed by heading.
inline constexpr std::array<int, 4> steps_east = {0, 1, 0, -1}, steps_north = {1, 0, -1, 0};

/// The cell that lies in a heading; it may lie outside of the maze.
/// @param cell the one to count from.
/// @param heading where the other one lies.
/// @param count so many cells away; negative: behind. It must stay between -128 and 127 in x and y.
constexpr Cell neighbour(Cell cell, Heading heading, int count = 1) {
  const auto side = static_cast<unsigned>(heading);
  return {cell.x + steps_east[side] * count, cell.y + steps_north[side] * count};
}

/// The name of a heading.
/// @param heading one of the four.
/// @return "north", "east", "south" or "west"; in static memory.
constexpr std::string_view name_of(Heading heading) {
  constexpr std::array<std::string_view, 4> names = {"north", "east", "south", "west"};
  return names[static_cast<unsigned>(heading)];
}

}  // namespace labmouse
