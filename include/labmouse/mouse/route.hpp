// Moves along a distance field.
#pragma once

#include <optional>

#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

/// A straight move: so many cells in a direction.
struct Move {
  /// Of the maze, not relative to the mouse.
  Heading direction = Heading::north;
  int cells = 0;

  friend constexpr bool operator==(const Move&, const Move&) = default;
};

/// The first move of a cheapest route from a pose to the cells at distance 0. Ties are broken in this order: ahead,
/// left, right, back; in each direction the longest first.
/// @param field the distances.
/// @param passages those that the field was filled with.
/// @param pose where the route begins; a cell outside the maze has no route.
/// @return nullopt if there is no route, or the pose is already at distance 0.
std::optional<Move> next_move(const DistanceField& field, const WallSet& passages, Pose pose);

/// The same as an action.
/// @param field the distances.
/// @param passages those that the field was filled with.
/// @param pose where the mouse is.
/// @return a step; Action::step(0, 0) if the pose is at distance 0, a forfeit with `no_route` if there is no route.
Action step_along(const DistanceField& field, const WallSet& passages, Pose pose);

/// One step towards the cells at distance 0 of a field filled over knowledge.possible(). It follows a cheapest route as
/// far as it is known to be open. If the first wall is unknown, it turns by a quarter to look at it.
/// @param optimistic that field.
/// @param knowledge what is known, including the reading of the pose: only the wall behind may be unknown.
/// @param pose where the mouse is.
/// @return a step; a forfeit with `no_route` if no possible route exists, and also if the pose is at distance 0.
Action optimistic_step(const DistanceField& optimistic, const Knowledge& knowledge, Pose pose);

}  // namespace labmouse
