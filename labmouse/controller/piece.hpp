// One piece of what a mouse drives: a straight, a curve, a pivot, or a rest.
#pragma once

#include <optional>

#include "labmouse/controller/ramps.hpp"
#include "labmouse/controller/target.hpp"
#include "labmouse/mouse/robot/drive_profile.hpp"
#include "labmouse/mouse/robot/turn_shape.hpp"

namespace labmouse {

struct Piece {
  enum class Kind { straight, backwards, curve, pivot, rest };

  Kind kind = Kind::rest;
  Position from;
  Direction ahead;
  Ramps ramps;                       ///< of a straight's length, a curve's, or a pivot's angle; of a rest none
  double seconds = 0.0;              ///< all of it
  const TurnShape* shape = nullptr;  ///< of a curve; must outlive it
  double shape_from = 0.0;           ///< mm along the shape where it begins
  bool left = true;                  ///< of a curve or a pivot

  static Piece straight(const Position& from, const Direction& ahead, const Ramps& ramps);
  /// Backwards over the length of the ramps; `ahead` stays where it points.
  static Piece backwards(const Position& from, const Direction& ahead, const Ramps& ramps);
  static Piece curve(const Position& from, const Direction& ahead, const TurnShape& shape, bool left,
                     const Ramps& ramps);
  static Piece pivot(const Position& at, const Direction& ahead, bool left, const Ramps& ramps);
  static Piece rest(const Position& at, const Direction& ahead, double seconds);
};

/// Follows a piece, a tick at a time.
class PieceWalk {
 public:
  PieceWalk() = default;
  /// From the first `late` seconds on. Of a route's segment with its own profile, which replaces the ramps.
  explicit PieceWalk(const Piece& piece, const std::optional<DriveProfile>& profile = std::nullopt);

  /// So many seconds on, not beyond the end.
  void step(double seconds);
  const Target& target() const { return target_; }
  /// What is left, in seconds.
  double left() const { return piece_.seconds - time_; }

 private:
  /// How far it has come by then, in mm or rad, and how fast it is.
  double length_at(double seconds) const;
  double speed_at(double seconds) const;
  void drive(double from, double to);

  Piece piece_;
  std::optional<DriveProfile> profile_;
  Target target_;
  double time_ = 0.0, length_ = 0.0, speed_ = 0.0;  ///< now
};

}  // namespace labmouse
