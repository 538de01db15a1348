// How `phases` chooses among cells: f = steps from here + heuristic.
#pragma once

#include <optional>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/hashed_cells.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/search_tree.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// Walks to the most promising of some cells, and chooses anew at every step.
class GoalOriented {
 public:
  /// What is added to the steps; `none` adds nothing, so the nearest cell is the most promising.
  enum class Heuristic : std::uint8_t { none, edges, manhattan, manhattan_edges, optimistic };

  /// Takes the parameters `heuristic`, `ties` and `order`, and all memory.
  GoalOriented(const Briefing& briefing, const Settings& settings);

  /// The next action towards the candidate with the least f among those that are known to be reachable; where that is
  /// the present cell, a turn to the right. Nothing where no candidate can be reached.
  std::optional<Action> towards(const CellSet& candidates, const Knowledge& knowledge, Pose pose);

 private:
  void list_reached(const Knowledge& knowledge);
  std::optional<Cell> most_promising(const CellSet& candidates, const Knowledge& knowledge) const;
  int heuristic(const Knowledge& knowledge, Cell cell) const;

  Pose start_;
  CellSet goals_;
  Heuristic heuristic_;
  SearchTree cell_by_cell_;  ///< from the start
  HashedCells reached_;      ///< what it finds, in the order of a set
  SearchTree tree_;          ///< from here, in strides
  DistanceField optimistic_;
};

}  // namespace labmouse
