// The lattice on which routes in seconds are searched: half cells, eight directions, and which turns fit where.
//
// A point is the middle of a cell (both coordinates odd) or of a wall (one is odd). Points that can be passed are bits
// of words, along all four kinds of lines: columns, rows, and rising and falling diagonals. So the length of a corridor
// is a count of ones, and which turns fit is found for a whole line at a time by shifts and ANDs of its neighbours.
//
// A node is a point with a direction. The nodes of one direction lie in memory line by line, each line in that
// direction, so that the next node ahead is the next in memory:  node = direction * plane + line * points + position.
//
//   direction           line                       position (the second: points - that)
//   0 north, 4 south    (x - 1) / 2                y
//   2 east,  6 west     (y - 1) / 2                x
//   1 NE,    5 SW       ((x - y) mod points) / 2   y
//   7 NW,    3 SE       ((x + y) mod points) / 2   y
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/robot/node.hpp"
#include "labmouse/mouse/robot/turn.hpp"

namespace labmouse::drive {

/// A turn that can begin at a node, as a bit of a byte. The middle of a cell has these eight. On an edge S90 takes the
/// places of F90. A diagonal has the other three (below), each to the only side that is possible.
enum class Bit : std::uint8_t {
  f90_left,
  f90_right,
  f45_left,
  f45_right,
  f135_left,
  f135_right,
  f180_left,
  f180_right
};
inline constexpr unsigned diagonal_v90 = 0, diagonal_out45 = 1, diagonal_out135 = 2;

/// The turn that a bit stands for.
constexpr Turn turn_of(unsigned bit, bool diagonal, bool edge) {
  constexpr std::array<Turn, 3> diagonals = {Turn::v90, Turn::out45, Turn::out135};
  constexpr std::array<Turn, 4> centres = {Turn::f90, Turn::f45, Turn::f135, Turn::f180};
  if (diagonal) return diagonals[bit];
  return edge ? Turn::s90 : centres[bit / 2];
}

/// The step of one unit in a direction, in half cells.
constexpr HalfPoint unit(int direction) {
  constexpr std::array<HalfPoint, 8> units = {{{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};
  return units[static_cast<unsigned>(direction) & 7U];
}

/// The lattice of a maze up to 16 cells wide and high (Word is 32 bits) or 32 (64 bits).
template <class Word>
class Lattice {
 public:
  static constexpr int points = 8 * static_cast<int>(sizeof(Word));
  static constexpr int lines = points / 2;
  static constexpr int plane = lines * points;
  static constexpr int nodes = 8 * plane;

  /// Reads the open walls of a maze of that size.
  void build(Size size, const WallSet& passages);

  static int node(HalfPoint point, int direction) {
    const int along = (direction & 3) == 2 ? point.x : point.y;
    return direction * plane + (line_of(point, direction) >> 1) * points +
           (goes_up(direction) ? along : points - along);
  }
  static HalfPoint point(int node) {
    const int direction = node / plane, odd = 2 * (node / points % lines) + 1;
    const int along = goes_up(direction) ? node % points : points - node % points;
    switch (direction & 3) {
      case 0:
        return {odd, along};
      case 1:
        return {(along + odd) & (points - 1), along};
      case 2:
        return {along, odd};
      default:
        return {(odd - along) & (points - 1), along};
    }
  }
  static int direction(int node) { return node / plane; }
  /// The same point in the opposite direction.
  static int opposite(int node) {
    const int position = node & (points - 1);
    return ((node - position) ^ 4 * plane) + points - position;
  }

  /// Number of points ahead of a node before the first that cannot be passed.
  int run(int node) const { return std::countr_one(static_cast<Word>((lines_[node / points] >> node % points) >> 1)); }
  /// Whether a point of the maze, including its border, can be passed.
  bool passable(HalfPoint point) const { return point.y < points && (columns_[point.x + margin] >> point.y & 1U) != 0; }

  /// The turns that can begin at the nodes of a line: words by bit, and all bits together.
  const Word* turns(int node) const { return turns_[node / points].data(); }
  Word any_turn(int node) const { return any_turn_[node / points]; }

  /// The turns that can begin at a node.
  unsigned turns_at(int node) const;

  /// The nodes that turns lead to: that of the turn of a bit is at [8 * node + bit], whether walls are open or not. The
  /// table is the same for all mazes (64 or 256 KiB), so keep it.
  static std::vector<std::uint16_t> leaps();
  /// Whether the turn of a bit leads to the left.
  static bool leads_left(unsigned bit, int direction, bool even) {
    if (direction % 2 == 0) return bit % 2 == 0;
    // On a wall between north and south (an even position of all diagonals) NE and SW turn right.
    return (direction == 1 || direction == 5) != even;
  }

 private:
  static constexpr int margin = 4;

  /// Whether the coordinate that positions count grows in a direction.
  static constexpr bool goes_up(int direction) { return direction < 3 || direction == 7; }

  static int line_of(HalfPoint point, int direction) {
    switch (direction & 3) {
      case 0:
        return point.x;
      case 1:
        return (point.x - point.y) & (points - 1);
      case 2:
        return point.y;
      default:
        return (point.x + point.y) & (points - 1);
    }
  }
  static int leap(int node, unsigned bit);
  void find_turns_along(int direction, const Word* words);
  void find_turns_across(int direction, const Word* words);

  /// Passable points, line by line, with empty lines on both sides.
  Word rows_[points + 2 * margin]{};
  Word columns_[points + 2 * margin]{};
  /// By direction and line, in that direction.
  Word lines_[8 * lines]{};
  std::array<Word, 8> turns_[8 * lines]{};
  Word any_turn_[8 * lines]{};
};

/// The tables of Lattice::leaps() for both sizes of words, as far as mazes up to a size need them.
struct Leaps {
  explicit Leaps(Size largest);
  template <class Word>
  const std::uint16_t* of() const {
    return sizeof(Word) == sizeof(std::uint32_t) ? small.data() : large.data();
  }

  std::vector<std::uint16_t> small, large;
};

/// Whether a maze takes words of 32 bits.
inline bool is_small(Size size) { return size.width <= 16 && size.height <= 16; }

extern template class Lattice<std::uint32_t>;
extern template class Lattice<std::uint64_t>;

}  // namespace labmouse::drive
