// Where an exploring mouse could go, and what it would see there.
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

/// The cells that the mouse comes to over passages that it knows.
class Views {
 public:
  /// Takes all memory that it will need. Briefing and knowledge must live as long.
  Views(const Briefing& briefing, const Knowledge& knowledge)
      : sight_(briefing.sight),
        goals_(briefing.goals),
        knowledge_(knowledge),
        travel_(briefing.size, briefing.motion) {}

  /// Finds the ways from where the mouse stands.
  void plan(Cell from) { travel_.fill(knowledge_.open(), CellSet::of(from)); }

  /// The cell nearest to the mouse that looks at an unseen wall along known passages.
  Viewpoint viewpoint(Wall wall) const;
  /// How many unseen walls, not taken for closed, end the known corridors about a cell; at most four.
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
