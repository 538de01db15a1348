// Moves along a distance field.
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
/// Ties are broken in this order: ahead, left, right, back; in each direction the longest first.
std::optional<Move> next_move(const DistanceField& field, const WallSet& passages, Pose pose);

/// The same as an action: a step that stays if the pose is at distance 0, a forfeit if there is no route.
Action step_along(const DistanceField& field, const WallSet& passages, Pose pose);

/// One step towards the cells at distance 0 of a field filled over knowledge.possible(). It follows a cheapest route as
/// far as it is known to be open. If the first wall is unknown, it turns by a quarter to look at it. The reading of the
/// pose must have been learned.
Action optimistic_step(const DistanceField& optimistic, const Knowledge& knowledge, Pose pose);

}  // namespace labmouse
