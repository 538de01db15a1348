// What a mouse sees of the walls around it.
#pragma once

#include "labmouse/grid/heading.hpp"

namespace labmouse {

/// One reading: the number of open cells to the left, ahead and to the right, up to the next wall or the range of the
/// sensors (Briefing::sight).
struct Sighting {
  int left = 0;
  int ahead = 0;
  int right = 0;

  friend constexpr bool operator==(const Sighting&, const Sighting&) = default;

  /// The reading in a direction.
  /// @param quarters quarter turns clockwise from ahead: -1 left, 0 ahead, 1 right.
  /// @return in cells.
  constexpr int towards(int quarters) const { return quarters < 0 ? left : quarters == 0 ? ahead : right; }
};

}  // namespace labmouse
