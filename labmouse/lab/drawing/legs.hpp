// The movement of each step of a walk.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse::drawing {

/// One step of a walk. A turn has length 0; a step by which the mouse was carried elsewhere has no direction.
struct Leg {
  Cell from;
  Cell to;
  std::optional<Heading> direction;
  int length = 0;

  /// Whether the mouse was carried here, as at the reset.
  bool carried() const { return from != to && !direction; }
};

/// One leg for each step between the poses, all of which must lie in the maze.
std::vector<Leg> legs_of(const Maze& maze, const std::vector<Pose>& route);

/// Total length in cells.
int length_of(const std::vector<Leg>& legs);

/// Whether the walk enters a cell twice.
bool revisits(const std::vector<Leg>& legs);

}  // namespace labmouse::drawing
