// A walk as legs: what each step did on the floor.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse::drawing {

/// One step of a walk. A step that only turned has length 0; one that was carried elsewhere has no direction.
struct Leg {
  Cell from;
  Cell to;
  std::optional<Heading> direction;
  int length = 0;

  /// Whether the mouse did not get here on its own feet, as at the reset.
  bool carried() const { return from != to && !direction; }
};

/// One leg for each step between the poses, all of which must lie in the maze.
std::vector<Leg> legs_of(const Maze& maze, const std::vector<Pose>& route);

/// Cells gone, over all legs.
int length_of(const std::vector<Leg>& legs);

/// Whether the walk enters a cell again that it has been in.
bool revisits(const std::vector<Leg>& legs);

}  // namespace labmouse::drawing
