// The motion controller of a mouse: it drives search moves and planned routes from sensor readings, and reports
// evidence of walls. It has no access to the true state.
//
//   sense ──► estimator ◄── corrections        pieces of moves and routes ──► target
//                 │                                                              │
//                 └──────────────► tracker ◄─────────────────────────────────────┘
//                                     └──► axis control ──► duties of the motors
//
// It allocates no memory after construction, and each tick takes about the same few thousand instructions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "labmouse/controller/controller_choice.hpp"
#include "labmouse/controller/piece.hpp"
#include "labmouse/controller/reference_parts.hpp"
#include "labmouse/controller/search_manner.hpp"
#include "labmouse/controller/wall_reader.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

class Controller {
 public:
  /// The model, the hardware and the parts must outlive it.
  Controller(const DriveModel& model, const Hardware& hardware, Size size, const Gains& gains,
             const ControllerChoice& choice = {}, const ControllerParts& parts = {});

  /// Sets the pose: the mouse was put down at rest, about in the middle of the cell.
  void put(const Pose& pose);
  /// Scales all speeds by `pace`, above 0. The curves stay the same, in slow motion.
  void set_pace(double pace) { pace_ = pace; }
  /// Sets the wall map that corrections use, which must outlive its use. Null: no map.
  void know(const Knowledge* known) { known_ = known; }
  /// Begins a search move from place(): over one edge, over several (a dash), or to rest.
  void search(const Action& step);
  /// Backs up from rest by the robot's run-up, drives a route, and stops. The route must outlive the run.
  void run(const DriveRoute& route);

  /// Processes one tick. Returns the duties of the motors until the next one. Where its period is longer than a tick,
  /// the duties stay, and the sensors are not read, in the ticks between.
  Drive tick(const Sense& sense);

  /// Whether the last move is complete, so that the next one has to begin.
  bool arrived() const { return !moving_; }
  /// The place at the end of the present move.
  const SearchPlace& place() const { return place_; }
  /// Evidence of the walls around the cell of place().
  WallEvidence evidence() const {
    return parts_.reader ? parts_.reader->evidence(estimate_) : reader_.evidence(estimate_);
  }

  const PoseEstimate& estimate() const { return estimate_; }
  const Target& target() const { return target_; }
  /// Whether a run has left its start, so that its clock runs.
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
  void read(const Sense& sense);
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
  std::array<Piece, 6> pieces_{};  ///< of the present move, in order
  std::size_t next_ = 0, count_ = 0;
  const DriveRoute* route_ = nullptr;
  std::size_t segment_ = 0;
  PieceWalk walk_;
  double pace_;
  Target target_;  ///< target of `walk_`, scaled by `pace_`
  bool moving_ = false;
  unsigned period_;  ///< ticks
  Drive duties_;
  std::array<bool, most_rangers> range_is_new_{};  ///< since the sensors were last read
  double late_ = 0.0;                              ///< unused time of the last tick, s at pace 1; the next move uses it
};

}  // namespace labmouse
