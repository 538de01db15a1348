// What the robots of the third report share: manhattan, frontier, potential, cautious and the two that go by chance.
//
// They note which cells one move leads to, as far as single readings show it (ConnectedCells), in tables of their
// language's (Python 3.4's); of equal choices they take the first that such a table lists. A cell is visited where a
// step ends in it, and the search run ends where that is a goal. The speed run is planned once: a breadth-first search
// over the map to the first goal cell, column by column, that is in it; it ends in the first goal cell on that way.
// Source: Edward Kish, "Plot and Navigate a Virtual Maze" (the third report), and the program behind it.
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

/// A mouse that moves over a map of the moves that it has seen. A strategy derives from it and writes choose().
class MoveMapper : public Explorer {
 public:
  /// Takes the parameter `order`.
  MoveMapper(const Briefing& briefing, const Settings& settings);

 protected:
  /// One action of the search run. What is seen here is in the map.
  virtual Action choose() = 0;
  /// Whether the search run, which has entered a goal, is over.
  virtual bool is_done() const { return true; }
  Action race() override;

  /// Adds the present reading to the map.
  void look() { map_.learn(pose(), seen()); }
  const ConnectedCells& map() const { return map_; }
  /// Searches the shortest routes from the present cell.
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
  std::vector<Cell> plan_;  ///< where the moves end, the last first
};

}  // namespace labmouse
