// All that a log says of a mouse.
#pragma once

#include <string>

#include "labmouse/lab/logs/count_fit.hpp"
#include "labmouse/lab/logs/gyro_fit.hpp"
#include "labmouse/lab/logs/infrared_fit.hpp"
#include "labmouse/lab/logs/log_file.hpp"
#include "labmouse/lab/logs/motor_fit.hpp"

namespace labmouse {

struct LogFit {
  CountFit count;
  MotorFit drive, turn;
  GyroFit gyro;
  InfraredFit infrared;
  double seconds = 0.0;
  std::string error;  ///< why the log says nothing at all
};

/// Fits it to a mouse in cells of that many mm; what the log does not say is the hardware's. Millimetres are those of
/// the fitted count. Errors of the motors hold that of the count or, where that is not known, and of the gyro, by how
/// much the hardware's scales may be off.
LogFit fit_log(const Log& log, const Hardware& hardware, double cell, const WholeWay& whole);

}  // namespace labmouse
