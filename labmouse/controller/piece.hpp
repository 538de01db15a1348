// One piece of a path: a straight, a curve, a pivot, or a rest.
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
  Ramps ramps;                       ///< over the length of a straight or curve (mm) or the angle of a pivot (rad)
  double seconds = 0.0;              ///< duration of the piece
  const TurnShape* shape = nullptr;  ///< of a curve; must outlive it
  double shape_from = 0.0;           ///< mm along the shape where it begins
  bool left = true;                  ///< of a curve or a pivot

  static Piece straight(const Position& from, const Direction& ahead, const Ramps& ramps);
  /// Backwards over the length of the ramps; `ahead` is still where the mouse points.
  static Piece backwards(const Position& from, const Direction& ahead, const Ramps& ramps);
  static Piece curve(const Position& from, const Direction& ahead, const TurnShape& shape, bool left,
                     const Ramps& ramps);
  static Piece pivot(const Position& at, const Direction& ahead, bool left, const Ramps& ramps);
  static Piece rest(const Position& at, const Direction& ahead, double seconds);
};

/// Computes the target along a piece, tick by tick.
class PieceWalk {
 public:
  PieceWalk() = default;
  /// Begins at the start of a piece. The profile of a route's segment replaces the ramps.
  explicit PieceWalk(const Piece& piece, const std::optional<DriveProfile>& profile = std::nullopt);

  /// Advances by so many seconds, at most to the end.
  void step(double seconds);
  const Target& target() const { return target_; }
  /// Remaining time, s.
  double left() const { return piece_.seconds - time_; }

 private:
  /// Distance in mm or rad, and speed, at a time since the start.
  double length_at(double seconds) const;
  double speed_at(double seconds) const;
  void drive(double from, double to);

  Piece piece_;
  std::optional<DriveProfile> profile_;
  Target target_;
  double time_ = 0.0, length_ = 0.0, speed_ = 0.0;  ///< now
};

}  // namespace labmouse
