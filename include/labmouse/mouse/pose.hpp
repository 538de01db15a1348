// The pose of a mouse: its cell and its heading.
#pragma once

#include "labmouse/grid/heading.hpp"

namespace labmouse {

/// A cell, and the heading that a mouse has in it.
struct Pose {
  Cell cell;
  Heading heading = Heading::north;

  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

}  // namespace labmouse
