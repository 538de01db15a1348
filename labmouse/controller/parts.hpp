// What a controller is put together of, part by part, so that each can be somebody else's.
//
// Moves and routes, and when each of them is over, are the controller's own: its targets go by the time alone. So a
// mouse with a bad part drives the same moves, and only less well.
#pragma once

#include "labmouse/controller/pose_estimate.hpp"
#include "labmouse/controller/target.hpp"
#include "labmouse/hardware/sense.hpp"
#include "labmouse/mouse/evidence.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

/// Says where the mouse is.
class EstimatorPart {
 public:
  virtual ~EstimatorPart() = default;
  /// A hand has put it there, about, and it stands.
  virtual void put(const Position& position, const Direction& ahead) = 0;
  /// Called each tick: what was read, where the mouse should be by now, and what is known of walls; null where nothing
  /// is.
  virtual PoseEstimate estimate(const Sense& sense, const Target& target, const Knowledge* known) = 0;
};

/// Says whether walls stand about a cell.
class ReaderPart {
 public:
  virtual ~ReaderPart() = default;
  /// Reads that cell from now on, as seen in that heading; forgets what it has read before.
  virtual void begin(const Pose& pose) = 0;
  /// Called each tick, after the estimate.
  virtual void read(const Sense& sense, const PoseEstimate& estimate) = 0;
  /// What was read so far.
  virtual WallEvidence evidence(const PoseEstimate& estimate) const = 0;
};

/// Brings the mouse to where it should be.
class TrackerPart {
 public:
  virtual ~TrackerPart() = default;
  /// It begins from rest.
  virtual void reset() = 0;
  /// Called each tick, last: the duties until the next one.
  virtual Drive follow(const Sense& sense, const Target& target, const PoseEstimate& estimate) = 0;
};

/// Parts that are somebody else's, in place of the controller's own; null: its own. They must outlive the controller,
/// and serve no other.
struct ControllerParts {
  EstimatorPart* estimator = nullptr;
  ReaderPart* reader = nullptr;
  TrackerPart* tracker = nullptr;

  bool any() const { return estimator != nullptr || reader != nullptr || tracker != nullptr; }
};

}  // namespace labmouse
