// The nodes of a route that a mouse drives in seconds.
//
// A route passes centres of cells and middles of walls, and at each of them it has a direction: one of the four
// headings, or at the middle of a wall one of the diagonals between two of them. So sixteen nodes belong to a cell,
// four to each heading of it:
//
//          o---r---o      c  centre: in the middle of the cell, heading north
//          |  lxr  |      x  edge: on the wall between the cell and its northern neighbour, heading north
//          |   c   |      l  left: on that wall, heading north-west: it will cross the western side of the neighbour
//          o---o---o      r  right: on that wall, heading north-east
//
// A node on a wall exists only if that wall is open, and a diagonal one only if the wall that it will cross is open,
// too.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "labmouse/grid/heading.hpp"

namespace labmouse {

/// The longest side of a maze in the worlds in seconds, in cells: that of the half-size contest.
inline constexpr int max_drive_side = 32;

/// Where in its cell a node is; see above.
enum class Place : std::uint8_t { centre, edge, left, right };

/// All places, in the order of the enumeration.
inline constexpr std::array all_places = {Place::centre, Place::edge, Place::left, Place::right};

/// The name of a place in records.
/// @param place one of the four.
/// @return that of the enumerator; in static memory.
constexpr std::string_view name_of(Place place) {
  constexpr std::array<std::string_view, 4> names = {"centre", "edge", "left", "right"};
  return names[static_cast<unsigned>(place)];
}

/// A place and a direction in a maze; see above.
struct DriveNode {
  Cell cell;
  Heading heading = Heading::north;
  Place place = Place::centre;

  friend constexpr bool operator==(const DriveNode&, const DriveNode&) = default;

  /// Whether its direction is that of a diagonal.
  constexpr bool diagonal() const { return place == Place::left || place == Place::right; }
  /// The heading in which a diagonal node crosses its second wall, the one after that on which it lies.
  /// @pre diagonal()
  constexpr Heading second() const { return place == Place::left ? left_of(heading) : right_of(heading); }
};

/// A point in half cells from the south-west corner: the centre of (0,0) is (1,1), the wall north of it (1,2).
struct HalfPoint {
  int x = 0;
  int y = 0;

  friend constexpr bool operator==(const HalfPoint&, const HalfPoint&) = default;
};

/// The point of a node, whatever its direction.
/// @param node of any maze.
/// @return in half cells.
constexpr HalfPoint half_point(const DriveNode& node) {
  const HalfPoint centre = {2 * node.cell.x + 1, 2 * node.cell.y + 1};
  if (node.place == Place::centre) return centre;
  const Cell ahead = neighbour(Cell{0, 0}, node.heading);
  return {centre.x + ahead.x, centre.y + ahead.y};
}

/// The direction of a node.
/// @param node of any maze.
/// @return eighths of a turn clockwise from north, 0 to 7; odd for diagonals.
constexpr int eighths(const DriveNode& node) {
  const int straight = eighths(node.heading);
  return node.place == Place::left ? (straight + 7) % 8 : node.place == Place::right ? straight + 1 : straight;
}

/// The same place in the opposite direction: a node of the same way driven backwards.
/// @param node of any maze.
/// @return reversed() of it is the node again.
constexpr DriveNode reversed(const DriveNode& node) {
  switch (node.place) {
    case Place::centre:
      return {node.cell, opposite(node.heading), Place::centre};
    case Place::edge:
      return {neighbour(node.cell, node.heading), opposite(node.heading), Place::edge};
    default:
      break;
  }
  // Backwards, a diagonal first crosses the same wall from the other side, and then the side by which the forward
  // diagonal had entered the first cell. That side is on the left if the forward node is a left one.
  const bool left = node.place == Place::left;
  return {neighbour(node.cell, node.heading), opposite(node.heading), left ? Place::left : Place::right};
}

}  // namespace labmouse
