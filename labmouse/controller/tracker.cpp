#include "labmouse/controller/tracker.hpp"

#include <algorithm>
#include <cmath>

namespace labmouse {

Command Tracker::follow(const Target& target, const Course& course) {
  const Position way = target.position - course.position;
  // Errors along the direction of motion, and to its left.
  const Direction& own = course.way;
  const Position error = {way.x * own.cosine + way.y * own.sine, way.y * own.cosine - way.x * own.sine};
  const Direction off = {target.ahead.sine * own.cosine - target.ahead.cosine * own.sine,
                         target.ahead.cosine * own.cosine + target.ahead.sine * own.sine};
  if (std::abs(target.speed) < gains_.slow_speed || target.speed < 0.0) {
    const Command command = follow_slowly(target, error, off);
    speed_ = command.speed;
    return command;
  }
  const double spring = gains_.frequency * gains_.frequency, loss = 2.0 * gains_.damping * gains_.frequency;
  const double bend = target.speed * target.turning;  // lateral acceleration of the target
  const Position wanted = {
      target.speeding * off.cosine - bend * off.sine + spring * error.x +
          loss * (target.speed * off.cosine - course.speed),
      target.speeding * off.sine + bend * off.cosine + spring * error.y + loss * target.speed * off.sine};
  speed_ += wanted.x * gains_.seconds;
  // Kept near the target's speed, so that a delayed mouse does not overspeed to catch up.
  speed_ = std::clamp(speed_, 0.5 * target.speed, 1.5 * target.speed);
  const double speed = std::max(course.speed, gains_.slow_speed);
  return {speed_, wanted.x, wanted.y / speed, target.twisting};
}

Command Tracker::follow_slowly(const Target& target, const Position& error, const Direction& off) const {
  const double stiffness = gains_.slow_stiffness;
  const double damping =
      2.0 * gains_.slow_damping * std::sqrt(target.turning * target.turning + stiffness * target.speed * target.speed);
  // A minimum, so that a mouse at rest holds its position.
  constexpr double least = 4.0;  // 1/s
  const double hold = std::max(damping, least);
  return {target.speed * off.cosine + hold * error.x, target.speeding,
          target.turning + stiffness * target.speed * error.y + hold * off.sine, target.twisting};
}

}  // namespace labmouse
