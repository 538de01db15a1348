// What manhattan and frontier share: they have seen a cell, have not stood in it, and go there.
#pragma once

#include <optional>

#include "labmouse/strategies/move_mapper.hpp"

namespace labmouse {

/// A mouse that goes to the cheapest unvisited cell of its map by a whole shortest route, whatever it sees on the way,
/// and chooses again. A strategy derives from it and says what a cell costs.
///
/// A cell into which a mouse moves was seen before, in all four directions, but for the wall behind it at the start.
/// Where no unvisited cell is left to see, that wall is what is left: the mouse goes and looks at it, if a route to the
/// goal could lead through it.
class Seeker : public MoveMapper {
 public:
  Seeker(const Briefing& briefing, const Settings& settings)
      : MoveMapper(briefing, settings), optimistic_(briefing.size, briefing.motion) {}

 protected:
  /// What the strategy gives an unvisited cell that the search has found: the least is next.
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
