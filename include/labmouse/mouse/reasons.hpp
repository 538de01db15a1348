// The reasons of a strategy's decisions, for viewers: its options, and how it rated them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "labmouse/grid/wall.hpp"

namespace labmouse {

/// Costs in reasons are in thirtieths of a step of the speed run.
inline constexpr int costs_a_step = 30;

/// An option for the next move of a strategy.
struct Candidate {
  Wall wall;          ///< the unseen wall to look at; for a goal only its cell counts
  Cell seen_from;     ///< the cell to go to
  bool goal = false;  ///< whether the option is to enter the goal
  int through = 0;    ///< cost of a run from start to goal through the wall; see Reasons::way_here
  int travel = 0;     ///< cost of the way to that cell, in the motion's unit
  bool worth = true;  ///< worth its way; after reaching the goal, some options are not
  double score = 0;   ///< rating: the option with the lowest one that is worth its way is chosen

  friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// The method of a decision.
enum class Ground : std::uint8_t {
  candidates,  ///< the candidate with the lowest score; none if none was worth its price
  flood,       ///< a flood fill without candidates: time is short, or the maze is too large
  no_loops,    ///< the maze seems to have no loops, so the search stops at the goal
};

/// Names of the methods in records, in the order of the enumeration.
inline constexpr std::array ground_names = {"candidates", "flood", "no loops"};

/// The name of a method in records.
/// @param ground one of the three.
/// @return in static memory.
constexpr std::string_view name_of(Ground ground) { return ground_names[static_cast<unsigned>(ground)]; }

/// The reasons of one decision.
struct Reasons {
  Ground ground = Ground::candidates;
  std::vector<Candidate> candidates;
  /// The position of the chosen one; -1 where none was worth its price, and the strategy stops.
  int chosen = -1;
  int known = 0;  ///< cost of the shortest known run from start to goal; 0 where there is none yet
  /// Weight, in each `through`, of the cost from the start to the wall; 0 if a strategy counts only the cost from the
  /// wall to the goal.
  double way_here = 1;
  double hope = 0;   ///< after the goal: cost of the run through the wall that is nearest to being worth a look
  double price = 0;  ///< the cost of that look, as the strategy weighs it against `hope`

  friend bool operator==(const Reasons&, const Reasons&) = default;
};

}  // namespace labmouse
