#include "labmouse/mouse/robot/drive_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/functions/position.hpp"
#include "labmouse/mouse/robot/straights.hpp"

namespace labmouse {
namespace {

/// An end of a straight: a turn's lane, the start or the goal.
struct End {
  double speed = 0.0;
  double lead = 0.0;
  bool free = false;  ///< at any speed up to that
};

End lane_end(const Lane& lane) { return {lane.speed, lane.lead, false}; }

const StraightTimes& straights_of(const DriveModel& model, const DriveSegment& segment) {
  return segment.diagonal() ? model.tables.diagonal : model.tables.along;
}

End first_end(const DriveModel& model, const DriveRoute& route, std::size_t i) {
  if (i > 0)
    return lane_end(straights_of(model, route.segments[i]).lanes[model.tables.turns[route.segments[i - 1].turn].to]);
  if (model.robot.fixed) return {model.robot.fixed->speed, 0.0, false};
  return {0.0, model.robot.run_up, false};
}

End last_end(const DriveModel& model, const DriveRoute& route, std::size_t i) {
  if (i + 1 < route.segments.size())
    return lane_end(straights_of(model, route.segments[i]).lanes[model.tables.turns[route.segments[i + 1].turn].from]);
  if (model.robot.fixed) return {model.robot.fixed->speed, 0.0, false};
  return {end_speed(model.robot, stopping_room(route, model.tables)), 0.0, true};
}

/// The end with the speed that is reached there, if it is free.
End reached(End last, double length, const End& first, const StraightLimits& limits) {
  if (last.free)
    last.speed =
        std::min({last.speed, limits.speed, std::sqrt(first.speed * first.speed + 2.0 * limits.acceleration * length)});
  return last;
}

double peak_of(double length, const End& first, const End& last, const StraightLimits& limits) {
  const double up = limits.acceleration, down = limits.braking;
  const double squared =
      (2.0 * up * down * length + down * first.speed * first.speed + up * last.speed * last.speed) / (up + down);
  return std::min(limits.speed, std::max({std::sqrt(squared), first.speed, last.speed}));
}

/// The largest speed of a turn.
double top_speed_of(const DriveModel& model, Turn turn) {
  double top = 0.0;
  for (const DrivenTurn& driven : model.tables.turns)
    if (driven.turn == turn) top = std::max(top, driven.speed);
  return top;
}

}  // namespace

DriveProfile::DriveProfile(const DriveModel& model, const DriveRoute& route, std::size_t segment)
    : segment_(route.segments[segment]), cell_(model.tables.cell), duration_(segment_.end - segment_.begin) {
  if (segment_.kind == DriveSegment::Kind::straight)
    set_straight(model, route, segment);
  else
    set_turn(model, segment_);
  double seconds = 0.0;
  for (const Phase& phase : phases()) seconds += phase.seconds;
  if (seconds > 0.0) scale_ = duration_ / seconds;
}

void DriveProfile::set_straight(const DriveModel& model, const DriveRoute& route, std::size_t segment) {
  const bool diagonal = segment_.diagonal();
  const StraightLimits limits = diagonal ? limits_diagonal(model.robot) : limits_along(model.robot);
  const End first = first_end(model, route, segment);
  End last = last_end(model, route, segment);
  offset_ = first.lead;
  length_ = first.lead + segment_.units * (diagonal ? cell_ / std::sqrt(2.0) : cell_ / 2.0) + last.lead;
  last = reached(last, length_, first, limits);
  const double peak = peak_of(length_, first, last, limits);
  const double end = last.speed;
  const double up = (peak * peak - first.speed * first.speed) / (2.0 * limits.acceleration);
  const double down = (peak * peak - end * end) / (2.0 * limits.braking);
  const double even = std::max(0.0, length_ - up - down);
  add({(peak - first.speed) / limits.acceleration, up, first.speed, limits.acceleration});
  add({even / peak, even, peak, 0.0});
  add({(peak - end) / limits.braking, down, peak, -limits.braking});
}

void DriveProfile::set_turn(const DriveModel& model, const DriveSegment& segment) {
  const DrivenTurn& turn = model.tables.turns[segment.turn];
  const auto lead = [&](bool diagonal, std::size_t lane) {
    return (diagonal ? model.tables.diagonal : model.tables.along).lanes[lane].lead;
  };
  shape_ = &model.shapes[segment.turn];
  offset_ = lead(begins_diagonal(turn.turn), turn.from);
  length_ = shape_->whole() - offset_ - lead(ends_diagonal(turn.turn), turn.to);
  if (model.robot.grip > 0.0) {
    set_phases(*turn_drive(*shape_, turn.speed, turn.end_speed, top_speed_of(model, turn.turn), model.robot));
    return;
  }
  const double seconds = duration_ / 1e6;
  add({seconds, length_, length_ / seconds, 0.0});
}

void DriveProfile::set_phases(const TurnDrive& drive) {
  const double step = length_ / TurnDrive::steps;
  for (std::size_t i = 0; i < TurnDrive::steps; ++i) {
    const double from = drive.speeds[i], to = drive.speeds[i + 1];
    add({2.0 * step / (from + to), step, from, (to * to - from * from) / (2.0 * step)});
  }
}

std::array<double, 2> DriveProfile::changes() const {
  if (shape_ != nullptr) return {0.0, static_cast<double>(duration_)};
  return {phases_[0].seconds * scale_, (phases_[0].seconds + phases_[1].seconds) * scale_};
}

double DriveProfile::distance_at(double time) const {
  double seconds = time / scale_, driven = 0.0;
  for (const Phase& phase : phases()) {
    const double spent = std::min(seconds, phase.seconds);
    driven += phase.speed * spent + phase.acceleration * spent * spent / 2.0;
    seconds -= spent;
  }
  return std::min(driven, length_);
}

double DriveProfile::speed_at(double time) const {
  double seconds = time / scale_, speed = 0.0;
  for (const Phase& phase : phases()) {
    if (phase.seconds <= 0.0) continue;
    const double spent = std::min(seconds, phase.seconds);
    speed = phase.speed + phase.acceleration * spent;
    if (seconds <= phase.seconds) break;
    seconds -= spent;
  }
  return speed;
}

double DriveProfile::time_at(double distance) const {
  if (distance <= 0.0) return 0.0;
  double seconds = 0.0;
  for (const Phase& phase : phases()) {
    if (distance >= phase.length) {
      seconds += phase.seconds;
      distance -= phase.length;
      continue;
    }
    const double speed = std::sqrt(std::max(0.0, phase.speed * phase.speed + 2.0 * phase.acceleration * distance));
    return (seconds + 2.0 * distance / (phase.speed + speed)) * scale_;
  }
  return duration_;
}

DriveSpot DriveProfile::spot(double distance) const {
  constexpr double eighth = 0.78539816339744830962;
  const Position ahead = way_of_eighths(eighths(segment_.from)), left = way_of_eighths(eighths(segment_.from) + 6);
  PathPoint point;
  if (shape_ != nullptr) {
    point = shape_->at(offset_ + distance);
    if (!segment_.left) point = {point.ahead, -point.aside, -point.angle};
  } else {
    point.ahead = distance - offset_;
  }
  const HalfPoint from = half_point(segment_.from);
  return {from.x * cell_ / 2.0 + ahead.x * point.ahead + left.x * point.aside,
          from.y * cell_ / 2.0 + ahead.y * point.ahead + left.y * point.aside,
          eighths(segment_.from) * eighth - point.angle};
}

}  // namespace labmouse
