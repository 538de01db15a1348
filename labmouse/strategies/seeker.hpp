// Base of manhattan and frontier, which go to cells that they have seen but not visited.
#pragma once

#include <optional>

#include "labmouse/strategies/move_mapper.hpp"

namespace labmouse {

/// Goes to the cheapest unvisited cell of its map by a shortest route, without replanning on the way, then chooses
/// again. Derived strategies define the cost of a cell.
///
/// The mouse sees all four sides of each cell it moves into; only the wall behind it at the start stays unseen. If no
/// unvisited cell is left, it goes to look at that wall, if a route to the goal could lead through it.
class Seeker : public MoveMapper {
 public:
  Seeker(const Briefing& briefing, const Settings& settings)
      : MoveMapper(briefing, settings), optimistic_(briefing.size, briefing.motion) {}

 protected:
  /// Cost of a reachable unvisited cell; the cheapest is next.
  virtual int cost(const SearchTree& routes, Cell cell) const = 0;

 private:
  Action choose() final {
    if (!is_underway()) plan_to_cheapest();
    if (is_underway()) return follow();
    optimistic_.fill(knowledge().possible(), briefing().goals);
    return optimistic_step(optimistic_);
  }

  void plan_to_cheapest() {
    const SearchTree& routes = find_routes();
    std::optional<Cell> cheapest;
    map().cells().for_each([&](Cell cell) {
      if (visited().contains(cell) || !routes.reaches(cell)) return;
      if (!cheapest || cost(routes, cell) < cost(routes, *cheapest)) cheapest = cell;
    });
    if (cheapest) plan_to(*cheapest);
  }

  DistanceField optimistic_;
};

}  // namespace labmouse
