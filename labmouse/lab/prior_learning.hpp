// Learning what to expect of walls that have not been seen, by counting.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/wall_prior.hpp"

namespace labmouse {

/// How often a wall turned out to be open and closed.
struct WallCount {
  std::int64_t open = 0;
  std::int64_t closed = 0;
};

/// Counts of unseen walls by their context, along explorations: each wall once for each context that it had.
struct PriorCounts {
  std::array<WallCount, wall_contexts> walls{};  ///< by folded context
  std::array<WallCount, 24> rim{};

  /// Counts along one exploration of a maze.
  void add(const Maze& maze, const RunRecord& record);
};

/// The reluctances of counts. A context that was seen rarely leans on the same without the two parallel walls, and that on
/// the share of all walls: as if each had been seen a few times more with the share of the wider one.
WallPrior prior_of(const PriorCounts& counts);

/// Explores every maze as the mouse does that finds every unseen wall equally dear, and counts.
WallPrior learn_prior(std::span<const Maze> mazes, const Rules& rules);

}  // namespace labmouse
