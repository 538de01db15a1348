// The map of the robots in the third capstone report (docs/research/reports.md): for each cell, the cells that one move
// leads to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "labmouse/mouse/hashed_cells.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// Straight moves of up to `longest` cells, each known from a single reading. If two readings have shown one half of a
/// corridor each, no move between the halves is known, although all passages are open.
///
/// The cells are in the order of a hash table, and the neighbours of each in that of a hash set. As in the report's
/// program, each connection replaces the set by a copy with the cell added, even if it was in already. Takes all its
/// memory when made.
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
  std::size_t most_;  ///< most cells of a set
  HashedCells map_;
  HashedCells set_;              ///< the copy that is being made
  std::vector<Cell> connected_;  ///< `most_` places for each cell
  std::vector<std::uint8_t> counts_;
  std::vector<bool> settled_;  ///< by cell: whether copying its set again would keep the order
};

}  // namespace labmouse
