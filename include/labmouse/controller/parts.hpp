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

/// A part of a controller. "Each tick" means each one in which the controller acts: all of them, or one in each
/// Motors::period.
class ControllerPart {
 public:
  virtual ~ControllerPart() = default;
  /// Why the part gave up, which ends the contest; `none` while it works. Called each millisecond.
  virtual ForfeitReason reason() const { return ForfeitReason::none; }
};

/// Estimates the pose of the mouse.
class EstimatorPart : public ControllerPart {
 public:
  /// The mouse was put about there by hand, and is at rest.
  /// @param position the middle of the cell, mm from the south-western corner of the maze.
  /// @param ahead where the mouse points: angle from east to the left.
  virtual void put(const Position& position, const Direction& ahead) = 0;
  /// Estimates the pose at this moment. Called each tick, before the other parts.
  /// @param sense the readings. A ToF reading of a tick in which the controller did not act is still marked as new.
  /// @param target where the mouse should be at this moment.
  /// @param known the map of walls; null: no map.
  /// @return the estimate. If it is not valid (PoseEstimate::is_valid), the controller keeps the one before.
  virtual PoseEstimate estimate(const Sense& sense, const Target& target, const Knowledge* known) = 0;
};

/// Detects the walls around a cell.
class ReaderPart : public ControllerPart {
 public:
  /// Begins to read the walls of a cell. Discards earlier readings.
  /// @param pose the cell, and the heading in which the mouse sees it. The mouse may not be there yet.
  virtual void begin(const Pose& pose) = 0;
  /// Uses the readings of a tick. Called each tick, after the estimate.
  /// @param sense as for EstimatorPart::estimate().
  /// @param estimate the pose at this moment.
  virtual void read(const Sense& sense, const PoseEstimate& estimate) = 0;
  /// Evidence of the readings so far.
  /// @param estimate the pose at this moment.
  /// @return for the walls to the left, ahead and to the right of the heading given to begin(), in eighths of a nat.
  virtual WallEvidence evidence(const PoseEstimate& estimate) const = 0;
};

/// Makes the mouse follow the target.
class TrackerPart : public ControllerPart {
 public:
  /// Called when the mouse was put down, at rest.
  virtual void reset() = 0;
  /// Called each tick, after the other parts.
  /// @param sense the readings.
  /// @param target where the mouse should be a millisecond later.
  /// @param estimate the pose at this moment.
  /// @return the duties until the next tick, -1 to 1. The controller cuts larger ones, and replaces NaN by 0.
  virtual Drive follow(const Sense& sense, const Target& target, const PoseEstimate& estimate) = 0;
};

/// External parts that replace the controller's own; null: its own. They must outlive the controller, and serve no
/// other.
struct ControllerParts {
  EstimatorPart* estimator = nullptr;
  ReaderPart* reader = nullptr;
  TrackerPart* tracker = nullptr;

  /// Whether there is one.
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
  /// The parts for drive_physically(); they are owned by this object, and null where the controller's own is used.
  virtual ControllerParts parts() = 0;
  /// False for an external program that did not start, or ended before its greeting.
  virtual bool started() const { return true; }
  /// Text for the user, as StrategyReport::last_words; it belongs to this object.
  virtual std::string_view last_words() { return {}; }
};

}  // namespace labmouse
