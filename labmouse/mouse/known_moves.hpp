// What a mouse can do where it stands, as far as it knows.
#pragma once

#include <array>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/route.hpp"

namespace labmouse {

/// The straight moves from a cell through the given passages, up to a longest: by heading from north clockwise, in each
/// heading the shortest first.
class KnownMoves {
 public:
  KnownMoves(const WallSet& passages, Cell from, int longest) {
    for (const Heading direction : all_headings) {
      Cell cell = from;
      for (int cells = 1; cells <= longest && passages.contains(wall_at(cell, direction)); ++cells) {
        moves_[static_cast<unsigned>(count_++)] = {direction, cells};
        cell = neighbour(cell, direction);
      }
    }
  }

  int count() const { return count_; }
  bool empty() const { return count_ == 0; }
  const Move& operator[](int index) const { return moves_[static_cast<unsigned>(index)]; }
  const Move* begin() const { return moves_.data(); }
  const Move* end() const { return moves_.data() + count_; }

 private:
  std::array<Move, 4 * Motion::max_longest> moves_;
  int count_ = 0;
};

}  // namespace labmouse
