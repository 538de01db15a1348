// What the mice have to keep to that seek out cells which they have not visited.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "labmouse/mouse/connected_cells.hpp"
#include "labmouse/mouse/search_tree.hpp"
#include "tests/strategies/one_contest.hpp"

namespace labmouse::test {

/// What the report's robot remembers, kept a second time.
class SeekersMemory {
 public:
  explicit SeekersMemory(Size size) : map_(size, 3, CellOrder::python_3_4), routes_(size, 3, TieOrder("nesw")) {}

  void learn(const StepRecord& step) {
    map_.learn(step.pose, step.sighting);
    visited_.insert(step.pose.cell);
  }

  /// The first of the cheapest cells that were seen and not visited; cost(routes, cell), the routes beginning here.
  template <class Cost>
  std::optional<Cell> cheapest(Pose here, Cost cost) {
    routes_.grow(map_, here);
    std::optional<Cell> best;
    map_.cells().for_each([&](Cell cell) {
      if (!visited_.contains(cell) && routes_.reaches(cell) && (!best || cost(routes_, cell) < cost(routes_, *best)))
        best = cell;
    });
    return best;
  }

  bool knows(Pose from, const Action& step) const {
    const Cell to = after(from, step).cell;
    if (to == from.cell) return true;
    const auto cells = map_.of(from.cell);
    return std::find(cells.begin(), cells.end(), to) != cells.end();
  }
  int moves_to(Cell cell) const { return routes_.distance(cell); }

 private:
  ConnectedCells map_;
  CellSet visited_;
  SearchTree routes_;
};

/// That the mouse goes to the cheapest cell by a shortest route, and chooses again when it is there.
template <class Cost>
void expect_goes_to_the_cheapest(const BuiltinMouse& mouse, const Maze& maze, Cost cost) {
  SeekersMemory memory(maze.size());
  std::optional<Cell> target;
  int moves_left = 0;
  follow_search_run(maze, contest(mouse, maze), [&](const StepRecord& step, const Knowledge&) {
    memory.learn(step);
    if (moves_left == 0) {
      EXPECT_EQ(step.pose.cell, target.value_or(step.pose.cell)) << step.step;
      target = memory.cheapest(step.pose, cost);
      moves_left = target ? memory.moves_to(*target) : 1;
    }
    --moves_left;
  });
}

/// That each move of both runs was seen as a whole before the speed run, and before it was made.
inline void expect_makes_only_moves_seen_as_a_whole(const BuiltinMouse& mouse, const Maze& maze) {
  SeekersMemory memory(maze.size());
  for (const StepRecord& step : contest(mouse, maze).steps) {
    if (step.run != Run::speed) memory.learn(step);
    if (step.action.kind != Action::Kind::step) continue;
    EXPECT_TRUE(memory.knows(step.pose, step.action)) << step.step;
  }
}

}  // namespace labmouse::test
