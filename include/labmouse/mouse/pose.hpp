// The pose of a mouse: its cell and its heading.
#pragma once

#include "labmouse/grid/heading.hpp"

namespace labmouse {

/// Where a mouse is: in the middle of a cell or, in the worlds in seconds, about to enter it; and its heading.
struct Pose {
  Cell cell;
  Heading heading = Heading::north;

  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

}  // namespace labmouse
