// The interface between DistanceField and its kernels. No inline functions here: see distance_rows.hpp.
#pragma once

#include <cstdint>

namespace labmouse {

/// Work for a kernel. `north`, `east` and `from` are 64 rows of 64 bits each. `sets` are sets of cells in rows of the
/// kernel's width. The first are the output, the unreached cells and then the planes of the distances; the rest is
/// scratch.
struct FieldOrder {
  const std::uint64_t* north;  ///< cells with a passage to the north
  const std::uint64_t* east;   ///< cells with a passage to the east
  const std::uint64_t* from;   ///< cells at distance 0
  std::uint64_t* sets;
  int planes;
  int longest;
  const std::uint8_t* cost;  ///< cost[k] of a straight run of k cells
};

using Kernel = void (*)(const FieldOrder&);

/// The kernel for a motion and rows of 16, 32 or 64 bits: `portable` uses vectors of 16 bytes, `wide` those of AVX2.
namespace portable {
Kernel kernel_for(int row_bits, int longest, bool uniform);
}
namespace wide {
Kernel kernel_for(int row_bits, int longest, bool uniform);
}

}  // namespace labmouse
