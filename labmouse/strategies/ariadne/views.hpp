// Finds the cells that a mouse can reach over known passages, and the unseen walls visible from there.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/wall_prices.hpp"

namespace labmouse::ariadne {

/// A cell that the mouse can go to, and the cost of the way there in the motion's unit.
struct Viewpoint {
  Cell cell;
  int travel = unreachable;
};

/// Reachable cells and what can be seen from them.
class Views {
 public:
  /// Allocates all memory. Briefing and knowledge must outlive it.
  Views(const Briefing& briefing, const Knowledge& knowledge)
      : sight_(briefing.sight),
        goals_(briefing.goals),
        knowledge_(knowledge),
        travel_(briefing.size, briefing.motion) {}

  /// Computes the ways from a cell.
  void plan(Cell from) { travel_.fill(knowledge_.open(), CellSet::of(from)); }

  /// The nearest cell from which an unseen wall is visible along known passages.
  Viewpoint viewpoint(Wall wall) const;
  /// Number of unseen walls, at most four, that end the known corridors around a cell and do not count as closed.
  int unseen_from(Cell from, const WallPrices& prices) const;
  /// The nearest goal cell that it can go to.
  std::optional<Viewpoint> nearest_goal() const;

  /// Calls visit(Wall) for each unseen wall beside a cell that it can go to, row by row.
  template <class Visit>
  void for_each_unseen(Visit visit) const {
    const CellSet reached = travel_.reached();
    const WallSet& possible = knowledge_.possible();
    const WallSet& open = knowledge_.open();
    for (int y = 0; y < knowledge_.size().height; ++y) {
      const std::uint64_t here = reached.row(y), above = y + 1 < max_side ? reached.row(y + 1) : 0;
      std::uint64_t north = possible.north().row(y) & ~open.north().row(y) & (here | above);
      std::uint64_t east = possible.east().row(y) & ~open.east().row(y) & (here | here >> 1);
      for (; north != 0; north &= north - 1) visit(Wall{{std::countr_zero(north), y}, Heading::north});
      for (; east != 0; east &= east - 1) visit(Wall{{std::countr_zero(east), y}, Heading::east});
    }
  }

 private:
  int sight_;
  const CellSet& goals_;
  const Knowledge& knowledge_;
  DistanceField travel_;
};

}  // namespace labmouse::ariadne
