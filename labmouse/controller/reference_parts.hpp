// The parts of the built-in controller: a Kalman filter with corrections by walls, and a tracking law with a motor
// model.
#pragma once

#include "labmouse/controller/axis_control.hpp"
#include "labmouse/controller/corrections.hpp"
#include "labmouse/controller/estimator.hpp"
#include "labmouse/controller/parts.hpp"
#include "labmouse/controller/tracker.hpp"

namespace labmouse {

class CorrectedEstimator final : public EstimatorPart {
 public:
  /// The hardware must outlive it.
  CorrectedEstimator(const Hardware& hardware, double cell, Size size, const CorrectionChoice& choice,
                     double speed_filter)
      : estimator_(hardware, cell, speed_filter), corrections_(hardware, cell, size, choice) {}

  void put(const Position& position, const Direction& ahead) override {
    estimator_.put(position, ahead);
    corrections_.forget();
  }
  PoseEstimate estimate(const Sense& sense, const Target& target, const Knowledge* known) override {
    estimator_.predict(sense);
    corrections_.apply(sense, target, known, estimator_);
    return estimator_.estimate();
  }

 private:
  Estimator estimator_;
  Corrections corrections_;
};

class MotorTracker final : public TrackerPart {
 public:
  MotorTracker(const Gains& gains, const Motors& motors) : tracker_(gains.tracker), control_(gains, motors) {}

  void reset() override {
    tracker_.reset();
    control_.reset();
  }
  Drive follow(const Sense& sense, const Target& target, const PoseEstimate& estimate) override {
    const Command command = tracker_.follow(target, {estimate.position, estimate.way(), estimate.speed});
    return control_.control(command, estimate.speed, estimate.turning, sense.millivolts / 1000.0);
  }

 private:
  Tracker tracker_;
  AxisControl control_;
};

}  // namespace labmouse
