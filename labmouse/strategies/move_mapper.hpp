// Base of the strategies of the third report: manhattan, frontier, potential, cautious, random and
// random-then-shortest.
//
// They map which cells one move can reach, if a single reading shows the whole move (ConnectedCells). Ties go to the
// first in the order of a hash table of Python 3.4, as in the original. A cell is visited when a step ends in it; the
// search run ends when that is a goal. The speed run is planned once, by breadth-first search over the map to the first
// mapped goal cell, column by column. It ends in the first goal cell on that way.
// Source: Edward Kish, "Plot and Navigate a Virtual Maze" (the third report), and its program.
#pragma once

#include <vector>

#include "labmouse/mouse/connected_cells.hpp"
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/search_tree.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

inline constexpr Parameter table_order = Parameter::choice(
    "order", "python-3.4", all_cell_orders,
    "Order of the hash table of that Python version, or row by row (rows), in which equally good choices are tried.");

/// A mouse that moves over a map of seen moves. Strategies derive from it and define choose().
class MoveMapper : public Explorer {
 public:
  /// Takes the parameter `order`.
  MoveMapper(const Briefing& briefing, const Settings& settings);

 protected:
  /// One action of the search run. The present reading is already in the map.
  virtual Action choose() = 0;
  /// Whether the search run is over, once a goal was entered.
  virtual bool is_done() const { return true; }
  Action race() override;

  /// Adds the present reading to the map.
  void look() { map_.learn(pose(), seen()); }
  const ConnectedCells& map() const { return map_; }
  /// Computes the shortest routes from the present cell.
  const SearchTree& find_routes();
  /// The next action on the planned route.
  Action follow();
  bool is_underway() const { return !plan_.empty(); }
  /// Plans the way to a cell that the last search has found.
  void plan_to(Cell target);
  /// The move to a cell that one known move leads to.
  Action go_to(Cell cell) const;

 private:
  Action explore() final;

  ConnectedCells map_;
  SearchTree routes_;
  std::vector<Cell> plan_;  ///< the cells in which moves end, in reverse order
};

}  // namespace labmouse
