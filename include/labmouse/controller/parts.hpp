// Interfaces of the parts of a controller. An external controller can replace each of them.
//
// The controller itself decides on the moves and routes and when each ends: its targets depend on time alone. So a bad
// part drives the same moves, only less accurately.
#pragma once

#include <initializer_list>
#include <string_view>

#include "labmouse/controller/pose_estimate.hpp"
#include "labmouse/controller/target.hpp"
#include "labmouse/hardware/sense.hpp"
#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/evidence.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

class ControllerPart {
 public:
  virtual ~ControllerPart() = default;
  /// Why the part gave up, which ends the contest; `none` while it works.
  virtual ForfeitReason reason() const { return ForfeitReason::none; }
};

/// Estimates the pose of the mouse.
class EstimatorPart : public ControllerPart {
 public:
  /// The mouse was put about there by hand, and is at rest.
  virtual void put(const Position& position, const Direction& ahead) = 0;
  /// Called each tick, with the readings, the present target, and the map of walls `known` (null: no map).
  virtual PoseEstimate estimate(const Sense& sense, const Target& target, const Knowledge* known) = 0;
};

/// Detects the walls around a cell.
class ReaderPart : public ControllerPart {
 public:
  /// Begins to read the walls of the pose's cell, seen in its heading. Discards earlier readings.
  virtual void begin(const Pose& pose) = 0;
  /// Called each tick, after the estimate.
  virtual void read(const Sense& sense, const PoseEstimate& estimate) = 0;
  /// Evidence of the readings so far, relative to the heading given to begin().
  virtual WallEvidence evidence(const PoseEstimate& estimate) const = 0;
};

/// Makes the mouse follow the target.
class TrackerPart : public ControllerPart {
 public:
  /// Called when the mouse was put down, at rest.
  virtual void reset() = 0;
  /// Called each tick, after the other parts. Returns the duties until the next tick.
  virtual Drive follow(const Sense& sense, const Target& target, const PoseEstimate& estimate) = 0;
};

/// External parts that replace the controller's own; null: its own. They must outlive the controller, and serve no
/// other.
struct ControllerParts {
  EstimatorPart* estimator = nullptr;
  ReaderPart* reader = nullptr;
  TrackerPart* tracker = nullptr;

  bool any() const { return estimator != nullptr || reader != nullptr || tracker != nullptr; }
  /// Why one of them gave up; `none` while all work.
  ForfeitReason reason() const {
    for (const ControllerPart* part : std::initializer_list<const ControllerPart*>{estimator, reader, tracker})
      if (part != nullptr && part->reason() != ForfeitReason::none) return part->reason();
    return ForfeitReason::none;
  }
};

/// External parts for one contest, and what they consist of.
class PartsOwner {
 public:
  virtual ~PartsOwner() = default;
  /// The parts for drive_physically(); they are owned by this object.
  virtual ControllerParts parts() = 0;
  /// See Strategy.
  virtual bool started() const { return true; }
  virtual std::string_view last_words() { return {}; }
};

}  // namespace labmouse
