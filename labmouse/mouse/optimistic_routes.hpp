// The shortest routes that may exist, where every unknown wall is taken to be open.
//
// Their length is a bound: no route is shorter. While it is less than that of the shortest known route, each of them
// leads through some unknown wall; when both agree, the known route is proven shortest.
#pragma once

#include <vector>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

class OptimisticRoutes {
 public:
  /// Routes from the briefing's start to its goals. Takes all memory that it will need.
  explicit OptimisticRoutes(const Briefing& briefing);

  /// Finds the routes anew.
  void plan(const Knowledge& knowledge);

  /// Their length in the motion's unit, or unreachable where there is none.
  int length() const { return length_; }
  /// The unknown walls that a move of any of them leads through.
  const WallSet& unknown_walls() const { return walls_; }

 private:
  void add_walls(const Knowledge& knowledge, Cell from, Heading direction);
  int start_cost(Cell cell) const { return start_costs_[static_cast<std::size_t>(size_.index(cell))]; }
  int goal_cost(Cell cell) const { return goal_costs_[static_cast<std::size_t>(size_.index(cell))]; }

  Size size_;
  CellSet start_;
  CellSet goals_;
  DistanceField field_;
  std::vector<int> start_costs_;
  std::vector<int> goal_costs_;
  WallSet walls_;
  int length_ = unreachable;
};

}  // namespace labmouse
