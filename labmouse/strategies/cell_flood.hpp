// Flood fill cell by cell: what flood-block and flood-explore have in common.
//
// Exploration: distances in cells to one goal cell, over all walls not known to be closed; one cell a step to the
// neighbour that is least far, and among equals to the first in the tie order. Where that neighbour lies behind, a
// quarter turn takes the place of the move, because no sensor looks there. The goal is found where a step ends in that
// one cell; to pass through another cell of the goal ends nothing.
// Speed run: distances in cells to the same cell, over the map that the mouse has made of its knowledge. All straight
// moves are listed, the directions in the tie order, in each the shortest first; the last on the list whose every cell
// is one nearer to the goal is made. So the directions count here in the opposite order, and the longest move in the
// chosen one is taken.
#pragma once

#include <vector>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/tie_order.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// A mouse that floods cell by cell; what it does between goal and reset, and which map it races on, is the strategy's
/// own.
class CellFlood : public Explorer {
 public:
  CellFlood(const Briefing& briefing, TieOrder ties);

 protected:
  /// One action of the search run once the goal is found.
  virtual Action after_goal() = 0;
  /// The passages of the speed run: some of the known ones, those of the way to the goal among them.
  virtual WallSet map() const = 0;

  /// One step of the search run towards a cell that a route that could exist leads to.
  Action step_towards(Cell target);
  /// The cells that routes that could exist lead to, as distances in cells from where the mouse stands.
  const DistanceField& reachable();

 private:
  Action explore() final;
  Action race() final;
  void flood(const WallSet& passages, Cell from);
  bool goal_can_be_reached();
  int longest_descent(const WallSet& passages, Heading direction) const;

  TieOrder ties_;
  DistanceField distance_;
  /// The goal's cells that may still be reached, column by column from the west, from north to south in each; the mouse
  /// floods to the last of the vector, so they stand there in reverse.
  std::vector<Cell> goals_;
  bool goal_found_ = false;
};

/// The passages of which both cells are in the set: a map on which all other cells are closed off.
WallSet passages_among(const CellSet& cells, const WallSet& passages);

/// The tie order that reproduces the report: west, south, east, north.
inline constexpr Parameter cell_flood_ties =
    Parameter::choice("ties", "wsen", TieOrder::all,
                      "Order of the directions, by compass (such as nesw) or as the mouse faces (such as alrb); the "
                      "speed run prefers the last.");

}  // namespace labmouse
