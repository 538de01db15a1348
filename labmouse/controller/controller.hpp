// The program of a mouse: it drives the moves of a search and fast routes, by what its sensors read, and says what they
// show of walls. The belief; it knows no truth.
//
//   sense ──► estimator ◄── corrections        pieces of moves and routes ──► target
//                 │                                                              │
//                 └──────────────► tracker ◄─────────────────────────────────────┘
//                                     └──► axis control ──► duties of the motors
//
// It takes no memory once it is made, and works off a tick in the same few thousand instructions each time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "labmouse/controller/piece.hpp"
#include "labmouse/controller/reference_parts.hpp"
#include "labmouse/controller/search_manner.hpp"
#include "labmouse/controller/wall_reader.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// What of a controller can be chosen.
struct ControllerChoice {
  CorrectionChoice corrections;
  double search_speed = 0.0;  ///< mm/s; 0: the robot's own
  double pace = 1.0;          ///< of all that it drives: at one half everything takes twice its time
};

class Controller {
 public:
  /// Of a robot with limits and hardware; model and gains' owner must outlive it.
  Controller(const DriveModel& model, const Hardware& hardware, Size size, const Gains& gains,
             const ControllerChoice& choice = {}, const ControllerParts& parts = {});

  /// It was put down at rest in the middle of a cell, about.
  void put(const Pose& pose);
  /// From the next move on all is driven as fast as a part of the usual pace says, above 0: the same curves, in slow
  /// motion.
  void set_pace(double pace) { pace_ = pace; }
  /// What is known of walls, for corrections; must outlive its use. Null: nothing.
  void know(const Knowledge* known) { known_ = known; }
  /// Begins a move from place(): a step of a search over one edge, or a dash over more, or to rest.
  void search(const Action& step);
  /// From rest, backs up to where runs begin, and drives a route, which must outlive the run; then stops.
  void run(const DriveRoute& route);

  /// One tick: what the motors do until the next one.
  Drive tick(const Sense& sense);

  /// Whether the last move is driven: now is the time for the next, or the mouse goes on straight.
  bool arrived() const { return !moving_; }
  /// Where it is then, as it believes.
  const SearchPlace& place() const { return place_; }
  /// Of the walls about that cell.
  WallEvidence evidence() const {
    return parts_.reader ? parts_.reader->evidence(estimate_) : reader_.evidence(estimate_);
  }

  /// Where it believes to be.
  const PoseEstimate& estimate() const { return estimate_; }
  const Target& target() const { return target_; }
  /// Whether a run has left its beginning: its clock is on.
  bool running() const { return route_ != nullptr && segment_ > 0; }

 private:
  EstimatorPart& estimator() { return parts_.estimator ? *parts_.estimator : estimator_; }
  ReaderPart& reader() { return parts_.reader ? *parts_.reader : reader_; }
  TrackerPart& tracker() { return parts_.tracker ? *parts_.tracker : tracker_; }
  void believe(const PoseEstimate& estimate);
  Position middle_of(Cell cell) const;
  void add(const Piece& piece);
  void add_pivot(const Position& at, Direction& ahead, int quarters);
  void add_stop(const Pose& pose);
  void begin_next(double late);
  void aim();
  bool begin_segment(double late);
  void begin_piece(const Piece& piece, double late, const std::optional<DriveProfile>& profile = std::nullopt);

  const DriveModel& model_;
  double cell_;
  SearchManner manner_;
  ControllerParts parts_;
  CorrectedEstimator estimator_;
  WallReader reader_;
  MotorTracker tracker_;
  PoseEstimate estimate_;
  const Knowledge* known_ = nullptr;

  SearchPlace place_;
  std::array<Piece, 6> pieces_{};  ///< that are still to be driven, the next first
  std::size_t next_ = 0, count_ = 0;
  const DriveRoute* route_ = nullptr;
  std::size_t segment_ = 0;
  PieceWalk walk_;
  double pace_;
  Target target_;  ///< of the walk, at that pace
  bool moving_ = false;
  double late_ = 0.0;  ///< seconds of the last tick, at the usual pace, that belong to the next move
};

}  // namespace labmouse
