// The moves that a mouse has seen, each from its beginning to its end.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "labmouse/grid/cell.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// Straight moves of up to `longest` cells, known from one reading each. Of a corridor that two readings have shown,
/// one half each, no move from one half into the other is known here, although all its passages are open: so it is with
/// programs that note what can be reached from where, and not walls. Takes all its memory when made.
class SightedMoves {
 public:
  SightedMoves(Size size, int longest);

  /// Learns the moves along the corridors of one reading, in both directions.
  void learn(Pose pose, const Sighting& seen);

  /// The longest known move from a cell in a direction; all shorter ones are known as well.
  int longest(Cell from, Heading direction) const {
    return known_[static_cast<std::size_t>(size_.index(from))][static_cast<unsigned>(direction)];
  }

 private:
  void learn_corridor(Cell from, Heading direction, int cells);
  void widen(Cell from, Heading direction, int cells);

  Size size_;
  int longest_;
  std::vector<std::array<std::uint8_t, 4>> known_;
};

}  // namespace labmouse
