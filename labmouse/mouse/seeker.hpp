// What mice have in common that seek out cells: they have seen a cell, have not visited it, and go there.
#pragma once

#include <optional>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/search_tree.hpp"

namespace labmouse {

/// A mouse that walks from one unvisited cell to the next until it has entered a goal, chooses its target anew at each
/// step, and takes the shortest known route to it. A mind derives from it and writes choose().
///
/// Where no such cell is left and no goal is entered, what is left may be a wall that was never in sight, such as the
/// one behind it at the start, or a goal that it has passed without ending a step there. Then it follows the shortest
/// route that could exist, and gives up where there is none.
class Seeker : public Explorer {
 public:
  /// The order decides which of several shortest routes is taken.
  Seeker(const Briefing& briefing, TieOrder ties);

 protected:
  /// The cell to go to, another than the present one: routes() reaches it. Nothing where there is none. Called once a
  /// step.
  virtual std::optional<Cell> choose() = 0;

  /// The shortest known routes from where the mouse stands.
  const SearchTree& routes() const { return routes_; }
  const TieOrder& ties() const { return ties_; }

 private:
  Action explore() final;

  TieOrder ties_;
  SearchTree routes_;
  DistanceField optimistic_;
};

}  // namespace labmouse
