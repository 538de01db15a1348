// Measures the speed of this build on this machine.
#pragma once

#include <map>
#include <string>

namespace labmouse {

/// Median time to fill one distance field, in nanoseconds, by four implementations.
struct DistanceSpeed {
  double rows = 0.0;           ///< DistanceField: bitboard rows, widest SIMD of this processor
  double portable_rows = 0.0;  ///< the same in portable C++
  double queue = 0.0;          ///< RingSearch: one cell at a time
  double plain = 0.0;          ///< plain_distances: one cell at a time, written for clarity
};

/// By the side of the maze: 16, 32, 64 cells. Steps of up to three cells, in generated mazes with loops.
using DistanceSpeeds = std::map<int, DistanceSpeed>;

struct Speed {
  DistanceSpeeds distance_ns;
  /// By mouse: whole contests a second on one thread, over the contest generator's 16×16 mazes.
  std::map<std::string, double> contests_per_second;
};

Speed measure_speed();

/// Measures the distance fields only.
DistanceSpeeds measure_distances();

}  // namespace labmouse
