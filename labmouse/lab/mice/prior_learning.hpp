// Estimates the probability that an unseen wall is closed, from counts in known mazes.
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

/// Counts of unseen walls along search runs, by context: the known states of neighbouring walls. Each wall counts once
/// for each context in which it was unseen. Walls between two goal cells do not count.
struct PriorCounts {
  std::array<WallCount, wall_contexts> walls{};  ///< by folded_context
  std::array<WallCount, rim_contexts> rim{};     ///< of the rim of a goal room of 2×2 cells, by rim_context

  /// Adds the counts of a contest's search run; its speed run is ignored.
  void add(const Maze& maze, const RunRecord& record);
  /// Adds the counts of a search run by the built-in mouse ariadne with `prior=uniform` and `model=flat`. If the goal
  /// cannot be reached, the part until the end counts.
  void explore(const Maze& maze, const Rules& rules);

  friend bool operator==(const PriorCounts&, const PriorCounts&) = default;
};

/// The prior of counts, as reluctances: -32 ln P(open). Rare contexts are smoothed by pseudo-counts in two stages. Each
/// context of eight neighbours is smoothed towards the context without the two parallel walls, and that one towards the
/// share of all walls. Rim contexts are smoothed towards the share of all walls. Without counts P is 0.5.
WallPrior prior_of(const PriorCounts& counts);

/// How well a prior predicts the walls from which it was counted, in nats per wall; 0 without walls.
struct PriorFit {
  std::int64_t walls = 0;  ///< number of walls counted
  double log_loss = 0.0;   ///< mean of -ln P(actual state), before P was rounded to a reluctance
  double entropy = 0.0;    ///< the same with a single P for all walls, their overall share
};
PriorFit fit_of(const PriorCounts& counts);

/// Learns the prior from mazes; their order does not matter. When `stop` becomes true, the remaining mazes are skipped.
WallPrior learn_prior(std::span<const Maze* const> mazes, const Rules& rules, const std::atomic<bool>* stop = nullptr);

}  // namespace labmouse
