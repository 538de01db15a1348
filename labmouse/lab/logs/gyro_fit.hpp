// From a mouse at rest to the noise of its gyro.
//
// Method: second differences of white noise have six times its variance, and no bias and no drift is in them; first
// differences have twice of it. Where the two disagree the noise is not white, and the error holds by how much.
#pragma once

#include <string>

#include "labmouse/lab/logs/estimate.hpp"
#include "labmouse/lab/logs/log_motion.hpp"

namespace labmouse {

struct GyroFit {
  Estimate noise;       ///< rad/s, of each moment, without what rounding to a unit of the gyro adds
  double rest = 0.0;    ///< s at rest
  double missed = 0.0;  ///< by how much quarters of the rest differ from what the others say, rms, as a share
  std::string refusal;  ///< why the log does not tell it; empty where it does
};

GyroFit fit_gyro(const Log& log, const LogMotion& motion);

}  // namespace labmouse
