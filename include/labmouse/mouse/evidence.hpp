// Evidence of sensor readings about walls.
#pragma once

#include <cstdint>

namespace labmouse {

/// Log-likelihood ratio of the readings, wall against no wall, in eighths of a nat: above 0 for a wall, below 0 for
/// none, 0 where nothing was seen.
using Evidence = std::int8_t;

/// One nat, in the unit of Evidence.
inline constexpr int evidence_a_nat = 8;

/// Evidence about the walls to the left, ahead and to the right of a mouse, in a cell.
struct WallEvidence {
  Evidence left = 0;
  Evidence ahead = 0;
  Evidence right = 0;

  friend constexpr bool operator==(const WallEvidence&, const WallEvidence&) = default;
};

}  // namespace labmouse
