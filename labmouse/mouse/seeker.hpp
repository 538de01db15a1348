// What mice have in common that seek out cells: they have seen a cell, have not stood in it, and go there.
#pragma once

#include <vector>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/hashed_cells.hpp"
#include "labmouse/mouse/search_tree.hpp"
#include "labmouse/mouse/sighted_moves.hpp"

namespace labmouse {

/// A mouse that goes to an unvisited cell, and from there to the next, until a step ends in a goal. A mind derives
/// from it and says what a cell costs; the cheapest is next. The rest is the robot of the third report:
///
/// - A cell is visited where a step ends in it; passing through is no visit.
/// - A move is known when it was seen as a whole (SightedMoves), in both runs.
/// - A route is planned once and followed to its end, whatever is seen on the way.
/// - Equally cheap cells are taken as a map of Python 3.5 lists them (HashedCells).
///
/// A cell into which a mouse moves was seen before, in all four directions, but for the wall behind it at the start.
/// Where no unvisited cell is left to see, that wall is what is left: the mouse goes and looks at it, if a route to the
/// goal could lead through it.
class Seeker : public Explorer {
 public:
  /// The order decides which of several shortest routes is taken; on each, the nearest cells are found first.
  Seeker(const Briefing& briefing, TieOrder ties);

 protected:
  /// What the mind gives a seen, unvisited cell: the least is next.
  virtual int cost(Cell cell) const = 0;

  /// The shortest known routes from where the mouse chooses.
  const SearchTree& routes() const { return routes_; }

 private:
  Action explore() final;
  Action race() final;

  void look();
  void plan_to_cheapest();
  void plan_to_goal();
  void plan_to(Cell target);
  Action follow();

  SightedMoves moves_;
  HashedCells seen_cells_;
  SearchTree routes_;
  std::vector<Cell> plan_;  ///< where the moves end, the last first
  DistanceField optimistic_;
};

}  // namespace labmouse
