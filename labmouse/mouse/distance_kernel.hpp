// What DistanceField and its kernels agree on. No inline functions here: see distance_rows.hpp.
#pragma once

#include <cstdint>

namespace labmouse {

/// Work for a kernel. `north`, `east` and `from` are 64 rows of 64 bits each. `sets` are sets of cells in rows of the
/// kernel's width: out come the unreached cells and then the planes of the distances; behind them lies its scratch.
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

/// The kernel for rows of 16, 32 or 64 bits and a motion: with vectors of 16 bytes, and with those of AVX2.
namespace portable {
Kernel kernel_for(int row_bits, int longest, bool uniform);
}
namespace wide {
Kernel kernel_for(int row_bits, int longest, bool uniform);
}

}  // namespace labmouse
