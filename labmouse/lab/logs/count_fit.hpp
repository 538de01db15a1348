// From a way that is known to the travel for a count of the encoders.
//
// Method: a line through the places that are known, by the counts there. The error is that of a jackknife over blocks
// of places, or of blocks of differences between them where that is larger, as it is where errors add up on the way.
#pragma once

#include <string>

#include "labmouse/lab/logs/estimate.hpp"
#include "labmouse/lab/logs/log_file.hpp"

namespace labmouse {

/// A way from the first row of a log to its last, as measured.
struct WholeWay {
  double way = 0.0;    ///< mm; 0: not measured
  double error = 0.0;  ///< mm, standard
};

struct CountFit {
  Estimate count;       ///< mm of the mean of both wheels
  double way = 0.0;     ///< mm, from one end of what is known to the other
  double missed = 0.0;  ///< mm by which it misses known places left out, rms; 0 of a whole way
  std::string refusal;  ///< why the log does not tell it; empty where it does
};

CountFit fit_count(const Log& log, const WholeWay& whole);

}  // namespace labmouse
