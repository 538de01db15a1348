#include "labmouse/controller/piece.hpp"

#include <algorithm>

namespace labmouse {

Piece Piece::straight(const Position& from, const Direction& ahead, const Ramps& ramps) {
  return {Kind::straight, from, ahead, ramps, ramps.seconds()};
}

Piece Piece::backwards(const Position& from, const Direction& ahead, const Ramps& ramps) {
  return {Kind::backwards, from, ahead, ramps, ramps.seconds()};
}

Piece Piece::curve(const Position& from, const Direction& ahead, const TurnShape& shape, bool left,
                   const Ramps& ramps) {
  return {Kind::curve, from, ahead, ramps, ramps.seconds(), &shape, 0.0, left};
}

Piece Piece::pivot(const Position& at, const Direction& ahead, bool left, const Ramps& ramps) {
  return {Kind::pivot, at, ahead, ramps, ramps.seconds(), nullptr, 0.0, left};
}

Piece Piece::rest(const Position& at, const Direction& ahead, double seconds) {
  return {Kind::rest, at, ahead, {}, seconds};
}

PieceWalk::PieceWalk(const Piece& piece, const std::optional<DriveProfile>& profile)
    : piece_(piece), profile_(profile) {
  if (profile_) piece_.seconds = profile_->duration() / 1e6;
  target_.position = piece_.from;
  target_.ahead = piece_.ahead;
  speed_ = speed_at(0.0);
  if (piece_.kind == Piece::Kind::straight || piece_.kind == Piece::Kind::curve) target_.speed = speed_;
}

double PieceWalk::length_at(double seconds) const {
  return profile_ ? profile_->distance_at(seconds * 1e6) : piece_.ramps.length_at(seconds);
}

double PieceWalk::speed_at(double seconds) const {
  return profile_ ? profile_->speed_at(seconds * 1e6) : piece_.ramps.speed_at(seconds);
}

void PieceWalk::step(double seconds) {
  if (seconds <= 0.0) return;
  time_ = std::min(time_ + seconds, piece_.seconds);
  const double length = length_at(time_), speed = speed_at(time_), rate = (speed - speed_) / seconds;
  const double side = piece_.left ? 1.0 : -1.0;
  switch (piece_.kind) {
    case Piece::Kind::straight:
    case Piece::Kind::curve:
      target_.speed = speed;
      target_.speeding = rate;
      drive(length_, length);
      break;
    case Piece::Kind::backwards:
      target_.speed = -speed;
      target_.speeding = -rate;
      drive(-length_, -length);
      break;
    case Piece::Kind::pivot:
      target_.turning = side * speed;
      target_.twisting = side * rate;
      target_.ahead = turned_by(target_.ahead, side * (length - length_));
      break;
    case Piece::Kind::rest:
      break;
  }
  length_ = length;
  speed_ = speed;
}

/// Moves the target from one length to another, along the curve if the piece is one.
void PieceWalk::drive(double from, double to) {
  double bend = 0.0;
  if (piece_.shape != nullptr) {
    const double side = piece_.left ? 1.0 : -1.0, begin = piece_.shape_from;
    bend = side * piece_.shape->curvature_at(begin + (from + to) / 2.0);
    const double before = target_.turning;
    target_.turning = side * piece_.shape->curvature_at(begin + to) * target_.speed;
    target_.twisting = to > from ? (target_.turning - before) * target_.speed / (to - from) : 0.0;
  }
  const double way = to - from;
  const Direction middle = turned_by(target_.ahead, bend * way / 2.0);
  target_.position = {target_.position.x + way * middle.cosine, target_.position.y + way * middle.sine};
  target_.ahead = turned_by(target_.ahead, bend * way);
}

}  // namespace labmouse
