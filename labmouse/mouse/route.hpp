// From a distance field to moves.
#pragma once

#include <optional>

#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

/// A straight move: so many cells in a direction.
struct Move {
  Heading direction = Heading::north;
  int cells = 0;

  friend constexpr bool operator==(const Move&, const Move&) = default;
};

/// The first move of a cheapest route, over the passages that the field was filled with, from a pose to the cells at
/// distance 0. Nothing where there is no route or the pose is already there.
///
/// Among equally cheap moves the order is total: ahead, left, right, back; in each direction the longest first.
std::optional<Move> next_move(const DistanceField& field, const WallSet& passages, Pose pose);

/// The same as an action; a pose at distance 0 gives the step that stays there, none gives a forfeit.
Action step_along(const DistanceField& field, const WallSet& passages, Pose pose);

/// One step towards the cells at distance 0 of a field filled over knowledge.possible(): along a cheapest route as far
/// as it is known to be open; where it begins behind a wall not yet seen, a quarter turn to look at that wall. For a
/// pose whose reading has been learned.
Action optimistic_step(const DistanceField& optimistic, const Knowledge& knowledge, Pose pose);

}  // namespace labmouse
