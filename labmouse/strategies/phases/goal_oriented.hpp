// Goal-oriented choice of cells in `phases`: the lowest f = steps from here + heuristic.
#pragma once

#include <optional>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/hashed_cells.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/search_tree.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// Walks to the candidate with the lowest f, chosen again at every step.
class GoalOriented {
 public:
  /// The heuristic that is added to the steps; with `none` the nearest cell is chosen.
  enum class Heuristic : std::uint8_t { none, edges, manhattan, manhattan_edges, optimistic };

  /// Reads the parameters `heuristic`, `ties` and `order`, and allocates all memory.
  GoalOriented(const Briefing& briefing, const Settings& settings);

  /// The next action towards the reachable candidate with the lowest f; a turn to the right if that is the present
  /// cell; nullopt if no candidate is known to be reachable.
  std::optional<Action> towards(const CellSet& candidates, const Knowledge& knowledge, Pose pose);

 private:
  void list_reached(const Knowledge& knowledge);
  std::optional<Cell> most_promising(const CellSet& candidates, const Knowledge& knowledge) const;
  int heuristic(const Knowledge& knowledge, Cell cell) const;

  Pose start_;
  CellSet goals_;
  Heuristic heuristic_;
  SearchTree cell_by_cell_;  ///< from the start
  HashedCells reached_;      ///< the cells that it finds, in the order of a Python set
  SearchTree tree_;          ///< from the present cell, in strides
  DistanceField optimistic_;
};

}  // namespace labmouse
