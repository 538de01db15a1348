// From duties and motion to a motor: gain, time constant and dead zone of an axis.
//
// Method: T v' = K (u - u0 sign(v)) - v, integrated twice, makes the place that a mouse comes to a sum of known curves,
// linear in 1/T, K/T and K u0/T, without a derivative of anything that was measured (integrated-form identification,
// as in Garnier and Wang, "Identification of continuous-time models from sampled data", 2008). Least squares over short
// stretches in which it moves one way, each with a beginning and a speed of its own. Errors are those of a jackknife
// over blocks of stretches, so that residuals may depend on their neighbours. How well it fits is said of stretches
// left out.
//
// Where a model with a lag or a drag fits those better, errors hold what it would change; where even that leaves much
// more than noise, errors grow by the share of the motion that is left unexplained.
#pragma once

#include <cstddef>
#include <string>

#include "labmouse/hardware/hardware.hpp"
#include "labmouse/lab/logs/estimate.hpp"
#include "labmouse/lab/logs/motor_curves.hpp"

namespace labmouse {

struct MotorFit {
  Estimate gain, time, dead_zone;  ///< time in s
  Estimate taking;                 ///< the factor of what takes of the duty
  Estimate mixed;                  ///< how much of the other axis's duty is in it: turning, by how much the right motor
                                   ///< is stronger than the left one, as a share
  bool time_known = true;          ///< false where the log does not tell the time: the gain goes with that of the base
  std::size_t stretches = 0;       ///< of moving one way
  double peak = 0.0;               ///< the largest rate
  double missed = 0.0;             ///< by how much it misses the rate on stretches left out, rms
  double noise = 0.0;              ///< how much of that is no motion, rms
  double changes = 0.0;            ///< the rates without those that stretches begin with, rms: what was to explain
  double lag = 0.0;                ///< s that a motor of the second order would lag, where that fits better
  double drag = 0.0;               ///< duty that drag would take at the peak, where that fits better
  std::string refusal;             ///< why the log does not tell what it should; empty where it does
};

/// Fits an axis; the base says what is slow, and the time where the log does not.
MotorFit fit_motor(const AxisLog& log, const MotorAxis& base);

}  // namespace labmouse
