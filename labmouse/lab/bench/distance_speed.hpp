// How fast this build is on this machine.
#pragma once

#include <map>
#include <string>

namespace labmouse {

/// Nanoseconds of one distance field, medians of one run.
struct DistanceSpeed {
  double rows = 0.0;           ///< rows of bits, the widest code of this processor
  double portable_rows = 0.0;  ///< rows of bits, the code for every processor
  double queue = 0.0;          ///< one cell at a time, from a ring in an array
  double plain = 0.0;          ///< one cell at a time, written for clarity
};

/// By the side of the maze: 16, 32, 64. Strides of three, mazes of our generators with loops.
using DistanceSpeeds = std::map<int, DistanceSpeed>;

struct Speed {
  DistanceSpeeds distance_ns;
  /// By mouse: whole contests a second on one thread, over the contest generator's 16×16 mazes.
  std::map<std::string, double> contests_per_second;
};

Speed measure_speed();

/// The distance fields alone.
DistanceSpeeds measure_distances();

}  // namespace labmouse
