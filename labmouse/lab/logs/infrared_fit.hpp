// From readings at known distances to the law of infrared sensors: gain and fall-off.
//
// Method: ln(reading) is a line over the distance that the beam goes, with a gain for each sensor and one fall-off for
// all, by least squares over places: runs of rows at distances that hardly change from row to row. What a place errs by
// (how its wall reflects, how well it was measured) is common to all its rows, so errors are those of a jackknife over
// places. Where a law that bends or has an offset fits places left out better, errors hold what it would change.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "labmouse/hardware/hardware.hpp"
#include "labmouse/lab/logs/estimate.hpp"
#include "labmouse/lab/logs/log_file.hpp"

namespace labmouse {

struct InfraredFit {
  Estimate gain;  ///< counts in the middle of a cell, in the mean of sensors, which differ from mouse to mouse
  Estimate fall;  ///< mm
  std::array<double, beam_count> of_beam{};  ///< gain of each sensor; 0: the log has too little of it
  std::size_t places = 0;
  double missed = 0.0;  ///< share by which it misses readings at places left out, rms
  bool bends = false;   ///< whether they follow another law
  std::string refusal;  ///< why the log does not tell it; empty where it does
};

/// Where sensors sit, how high they read and how noisy they are is the hardware's.
InfraredFit fit_infrared(const Log& log, const Hardware& hardware, double cell);

}  // namespace labmouse
