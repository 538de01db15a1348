// Why a strategy goes where it goes, for those who watch: what it could have done, and what it took that to be worth.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "labmouse/grid/wall.hpp"

namespace labmouse {

/// Costs in reasons are in thirtieths of a step of the speed run.
inline constexpr int costs_a_step = 30;

/// Something that a strategy considered doing next.
struct Candidate {
  Wall wall;          ///< the unseen wall to look at; of a goal the cell alone counts
  Cell seen_from;     ///< where to go for it
  bool goal = false;  ///< to enter the goal
  int through = 0;    ///< what a run from start to goal would cost that led through the wall; see Reasons::way_here
  int travel = 0;     ///< what the way to that cell costs, in the motion's unit
  bool worth = true;  ///< worth the way to it; after the goal, some are not
  double score = 0;   ///< the lowest of those that are is chosen

  friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// What a strategy went by.
enum class Ground : std::uint8_t {
  candidates,  ///< the lowest score of its candidates, or that none of them was worth its price
  flood,       ///< a flood fill: it weighs no candidates, for want of time or because the maze is too large
  no_loops,    ///< it takes the maze for one without loops, and stops at the goal
};

inline constexpr std::array ground_names = {"candidates", "flood", "no loops"};

constexpr std::string_view name_of(Ground ground) { return ground_names[static_cast<unsigned>(ground)]; }

/// One choice of a strategy.
struct Reasons {
  Ground ground = Ground::candidates;
  std::vector<Candidate> candidates;
  /// The position of the chosen one; -1 where none was worth its price, and the strategy stops.
  int chosen = -1;
  int known = 0;  ///< cost of the shortest known run from start to goal; 0 where there is none yet
  /// The share of the way from the start to a wall that `through` of the wall counts: 0 where a strategy only looks
  /// ahead.
  double way_here = 1;
  double hope = 0;   ///< after the goal: the cost of the run through the wall that comes nearest to being worth a look
  double price = 0;  ///< and what the look at it would cost, as far as the strategy counts it against the hope

  friend bool operator==(const Reasons&, const Reasons&) = default;
};

}  // namespace labmouse
