// The map of the third report's robots: from each cell the cells that one move leads to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "labmouse/mouse/hashed_cells.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// Straight moves of up to `longest` cells, known from one reading each. Of a corridor that two readings have shown,
/// one half each, no move from one half into the other is known here, although all its passages are open.
///
/// The map has the cells in the order of a table, and for each a set of others in the order of its own: a set is never
/// changed, each connection of a reading replaces it by a copy with the cell added, also where it was there already.
/// Takes all its memory when made.
class ConnectedCells {
 public:
  ConnectedCells(Size size, int longest, CellOrder order);

  /// Connects the cells of the corridors to the left, ahead and to the right, in both directions.
  void learn(Pose pose, const Sighting& seen);

  /// The cells that one known move leads to, in the order of their set. None for a cell that is not in the map.
  std::span<const Cell> of(Cell cell) const {
    const auto index = static_cast<std::size_t>(size_.index(cell));
    return {connected_.data() + index * most_, counts_[index]};
  }
  /// The cells of the map.
  const HashedCells& cells() const { return map_; }

 private:
  void connect(Cell from, Cell to);

  Size size_;
  int longest_;
  std::size_t most_;  ///< cells of a set
  HashedCells map_;
  HashedCells set_;              ///< the copy that is being made
  std::vector<Cell> connected_;  ///< `most_` places for each cell
  std::vector<std::uint8_t> counts_;
  std::vector<bool> settled_;  ///< of a cell: whether another copy of its set would list it in the same order
};

}  // namespace labmouse
