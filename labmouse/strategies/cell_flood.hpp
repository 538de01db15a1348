// Flood fill cell by cell: the base of flood-block and flood-explore.
//
// Search run: distances in cells to one goal cell, over all walls not known to be closed. Each step goes one cell, to
// the neighbour with the lowest distance; ties go to the first in the tie order. If that neighbour is behind, the mouse
// makes a quarter turn instead, because no sensor looks there. The goal is found when a step ends in that cell; other
// cells of the goal do not count.
// Speed run: distances in cells to the same cell, over the map of map(). All straight moves in which each cell is one
// nearer to the goal are listed, directions in the tie order, shorter ones first; the last one is made. So the last
// direction of the order wins, with its longest move.
#pragma once

#include <vector>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/tie_order.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// Floods cell by cell. Derived strategies decide what to do between goal and reset, and on which map to race.
class CellFlood : public Explorer {
 public:
  CellFlood(const Briefing& briefing, TieOrder ties);

 protected:
  /// One action of the search run once the goal is found.
  virtual Action after_goal() = 0;
  /// The passages of the speed run: a subset of the known ones that contains the way to the goal.
  virtual WallSet map() const = 0;

  /// One step of the search run towards a cell to which a possible route leads.
  Action step_towards(Cell target);
  /// Distances in cells from the mouse, over all walls not known to be closed.
  const DistanceField& reachable();

 private:
  Action explore() final;
  Action race() final;
  void flood(const WallSet& passages, Cell from);
  bool goal_can_be_reached();
  int longest_descent(const WallSet& passages, Heading direction) const;

  TieOrder ties_;
  DistanceField distance_;
  /// Goal cells that may be reachable. The mouse floods to the last one, so the order is reversed: the westernmost
  /// column last, and in it the northernmost cell last.
  std::vector<Cell> goals_;
  bool goal_found_ = false;
};

/// The passages of which both cells are in the set: a map on which all other cells are closed off.
WallSet passages_among(const CellSet& cells, const WallSet& passages);

/// The parameter `ties`. Its default (west, south, east, north) reproduces the scores of the first report.
inline constexpr Parameter cell_flood_ties =
    Parameter::choice("ties", "wsen", TieOrder::all,
                      "Order of the directions, by compass (such as nesw) or as the mouse faces (such as alrb); the "
                      "speed run prefers the last.");

}  // namespace labmouse
