// Learning what to expect of walls that have not been seen, by counting.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <span>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/wall_prior.hpp"

namespace labmouse {

/// How often an unseen wall turned out to be open and closed.
struct WallCount {
  std::int64_t open = 0;
  std::int64_t closed = 0;

  friend bool operator==(const WallCount&, const WallCount&) = default;
};

/// Counts of unseen walls along search runs: each wall once for each state of its surroundings in which it was unseen.
/// Walls between two goal cells do not count.
struct PriorCounts {
  std::array<WallCount, wall_contexts> walls{};  ///< by folded_context
  std::array<WallCount, rim_contexts> rim{};     ///< of the rim of a goal room of 2×2 cells, by rim_context

  /// Counts along the search run of a maze; the speed run that may follow it does not count.
  void add(const Maze& maze, const RunRecord& record);
  /// Explores a maze as the mouse does to which every unseen wall is equally dear, and counts. Where the goal cannot be
  /// reached, that counts too, as far as the mouse comes.
  void explore(const Maze& maze, const Rules& rules);

  friend bool operator==(const PriorCounts&, const PriorCounts&) = default;
};

/// The reluctances of counts. A context that was seen rarely leans on the same without the two parallel walls, and that
/// on the share of all walls: as if each had been seen a few times more with the share of the wider one. Where nothing
/// was counted, a wall is as likely open as closed.
WallPrior prior_of(const PriorCounts& counts);

/// How well a prior foretells the walls that it was counted from, in nats a wall; 0 where none was counted.
struct PriorFit {
  std::int64_t walls = 0;  ///< as counted
  double log_loss = 0.0;   ///< mean of -ln P(what the wall was), before P was rounded to a reluctance
  double entropy = 0.0;    ///< the same by one P for all walls, their common share
};
PriorFit fit_of(const PriorCounts& counts);

/// The prior that mazes teach. Their order makes no difference. Once `stop` is true no other maze is explored.
WallPrior learn_prior(std::span<const Maze* const> mazes, const Rules& rules, const std::atomic<bool>* stop = nullptr);

}  // namespace labmouse
