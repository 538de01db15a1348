#include "labmouse/controller/controller.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "labmouse/functions/position.hpp"

namespace labmouse {
namespace {

/// Seconds of rest after each stop and pivot, so that the mouse reads while it stands still.
constexpr double settling = 0.05;

Direction direction_of_eighths(int eighths) {
  const Position way = way_of_eighths(eighths);
  return {way.y, way.x};
}
Direction direction_in(Heading heading) { return direction_of_eighths(eighths(heading)); }

/// Limits a duty to -1..1; NaN gives 0.
float duty_of(float duty) { return duty >= -1.0F ? std::min(duty, 1.0F) : duty < -1.0F ? -1.0F : 0.0F; }

Position along(const Position& from, const Direction& ahead, double way) {
  return {from.x + way * ahead.cosine, from.y + way * ahead.sine};
}

}  // namespace

Controller::Controller(const DriveModel& model, const Hardware& hardware, Size size, const Gains& gains,
                       const ControllerChoice& choice, const ControllerParts& parts)
    : model_(model),
      cell_(model.tables.cell),
      manner_(search_manner(model, choice.search_speed)),
      parts_(parts),
      estimator_(hardware, cell_, size, choice.corrections, gains.speed_filter),
      reader_(hardware, cell_),
      tracker_(gains, hardware.motors),
      pace_(choice.pace),
      period_(static_cast<unsigned>(hardware.motors.period)) {}

Position Controller::middle_of(Cell cell) const { return {(cell.x + 0.5) * cell_, (cell.y + 0.5) * cell_}; }

void Controller::put(const Pose& pose) {
  place_ = {pose, true};
  route_ = nullptr;
  next_ = count_ = 0;
  duties_ = {};
  estimate_ = {};
  estimate_.position = middle_of(pose.cell);
  estimate_.ahead = direction_in(pose.heading);
  estimator().put(estimate_.position, estimate_.ahead);
  tracker().reset();
  reader().begin(pose);
  // Rests first, to read the walls.
  begin_piece(Piece::rest(middle_of(pose.cell), direction_in(pose.heading), settling), 0.0);
}

void Controller::add(const Piece& piece) {
  assert(count_ < pieces_.size());
  pieces_[count_++] = piece;
}

void Controller::add_pivot(const Position& at, Direction& ahead, int quarters) {
  if (quarters != 0) {
    const double angle = std::abs(quarters) * (pi / 2.0);
    add(Piece::pivot(at, ahead, quarters < 0, Ramps(angle, 0.0, 0.0, manner_.pivot)));
    for (int i = 0; i < std::abs(quarters); ++i)
      ahead = quarters < 0 ? Direction{ahead.cosine, -ahead.sine} : Direction{-ahead.cosine, ahead.sine};
  }
  add(Piece::rest(at, ahead, settling));
}

/// Adds the way from the edge to the middle of the cell, and a rest.
void Controller::add_stop(const Pose& pose) {
  const Direction ahead = direction_in(pose.heading);
  const double half = cell_ / 2.0, rate = manner_.acceleration;
  add(Piece::straight(along(middle_of(pose.cell), ahead, -half), ahead,
                      Ramps(half, manner_.speed, 0.0, {manner_.speed, rate, rate})));
  add(Piece::rest(middle_of(pose.cell), ahead, settling));
}

void Controller::search(const Action& step) {
  assert(is_search_step(place_, step));
  const Pose from = place_.pose;
  const SearchPlace to = after_search(place_, step);
  const int quarters = step.rotation / 90;
  const double half = cell_ / 2.0, rate = manner_.acceleration, speed = manner_.speed;
  Direction ahead = direction_in(from.heading);
  next_ = count_ = 0;
  route_ = nullptr;
  const bool stops = step.movement == 0 || step.rotation == 180;
  if (place_.at_rest || stops) {
    if (!place_.at_rest) add_stop(from);
    add_pivot(middle_of(from.cell), ahead, quarters);
    if (step.movement > 0)
      add(Piece::straight(middle_of(from.cell), ahead, Ramps(half, 0.0, speed, {speed, rate, rate})));
  } else if (step.rotation != 0) {
    const double turn_speed = manner_.turn_speed;
    const Position edge = along(middle_of(from.cell), ahead, -half);
    const TurnShape& shape = manner_.turn;
    const RampLimits limits{std::max(speed, turn_speed), rate, rate};
    // The straight lead-in and lead-out are for changing to the speed of the turn and back.
    if (turn_speed != speed) {
      add(Piece::straight(edge, ahead, Ramps(shape.lead_in, speed, turn_speed, limits)));
      Piece curve =
          Piece::curve(along(edge, ahead, shape.lead_in), ahead, shape, quarters < 0, Ramps(shape.length, turn_speed));
      curve.shape_from = shape.lead_in;
      add(curve);
      const Direction out = direction_in(to.pose.heading);
      add(Piece::straight(along(middle_of(from.cell), out, half - shape.lead_out), out,
                          Ramps(shape.lead_out, turn_speed, speed, limits)));
    } else {
      add(Piece::curve(edge, ahead, shape, quarters < 0, Ramps(shape.whole(), speed)));
    }
  } else {
    const Position edge = along(middle_of(from.cell), ahead, -half);
    const double length = step.movement * cell_, known = manner_.known_acceleration;
    const bool dashes = step.movement > 1 && manner_.known_speed > speed;
    add(Piece::straight(
        edge, ahead, dashes ? Ramps(length, speed, speed, {manner_.known_speed, known, known}) : Ramps(length, speed)));
  }
  reader().begin(to.pose);
  place_ = to;
  // What is left of the present tick belongs to the new move.
  begin_next(std::exchange(late_, 0.0));
}

void Controller::run(const DriveRoute& route) {
  assert(place_.at_rest && !route.segments.empty());
  const Direction ahead = direction_in(place_.pose.heading);
  const Position middle = middle_of(place_.pose.cell);
  const double back = model_.robot.run_up, rate = manner_.acceleration / 4.0;
  next_ = count_ = 0;
  if (back > 0.0) {
    add(Piece::backwards(middle, ahead, Ramps(back, 0.0, 0.0, {manner_.speed / 2.0, rate, rate})));
    add(Piece::rest(along(middle, ahead, -back), ahead, 4.0 * settling));
  }
  route_ = &route;
  segment_ = 0;
  begin_next(0.0);
}

void Controller::begin_piece(const Piece& piece, double late, const std::optional<DriveProfile>& profile) {
  walk_ = PieceWalk(piece, profile);
  walk_.step(late);
  moving_ = true;
  aim();
}

/// Sets the target to that of the walk, scaled by the pace.
void Controller::aim() {
  target_ = walk_.target();
  target_.speed *= pace_;
  target_.turning *= pace_;
  target_.speeding *= pace_ * pace_;
  target_.twisting *= pace_ * pace_;
}

/// Begins the next piece, `late` seconds into it. Without one the mouse has arrived.
void Controller::begin_next(double late) {
  if (next_ < count_) {
    begin_piece(pieces_[next_++], late);
  } else if (!begin_segment(late)) {
    moving_ = false;
  }
}

/// Begins the next segment of the route, or after its last one the straight on which the mouse brakes. False after
/// that.
bool Controller::begin_segment(double late) {
  if (route_ == nullptr || segment_ > route_->segments.size()) return false;
  if (segment_ == route_->segments.size()) {
    ++segment_;
    const Target& target = walk_.target();
    const double speed = target.speed, braking = model_.robot.braking;
    const DriveNode& end = route_->segments.back().to;
    place_ = {{end.cell, end.heading}, true};
    begin_piece(Piece::straight(target.position, target.ahead,
                                Ramps(speed * speed / (2.0 * braking), speed, 0.0, {speed, braking, braking})),
                late);
    return true;
  }
  const DriveSegment& segment = route_->segments[segment_];
  const DriveProfile profile(model_, *route_, segment_++);
  const Direction ahead = direction_of_eighths(eighths(segment.from));
  const HalfPoint node = half_point(segment.from);
  const Position from = along({node.x * cell_ / 2.0, node.y * cell_ / 2.0}, ahead, profile.beginning());
  Piece piece = Piece::straight(from, ahead, {});
  if (profile.shape() != nullptr) {
    piece = Piece::curve(from, ahead, *profile.shape(), segment.left, {});
    piece.shape_from = profile.beginning();
  }
  begin_piece(piece, late, profile);
  return true;
}

/// A ToF reading between two periods is as new in the next of them.
void Controller::read(const Sense& sense) {
  Sense since = sense;
  for (std::size_t i = 0; i < range_is_new_.size(); ++i)
    since.ranges[i].is_new |= std::exchange(range_is_new_[i], false);
  believe(estimator().estimate(since, target_, known_));
  reader().read(since, estimate_);
}

Drive Controller::tick(const Sense& sense) {
  const bool due = sense.tick % period_ == 0;
  if (due) read(sense);
  for (std::size_t i = 0; !due && i < range_is_new_.size(); ++i) range_is_new_[i] |= sense.ranges[i].is_new;
  double seconds = pace_ * tick_seconds;
  while (moving_ && walk_.left() < seconds) {
    seconds -= walk_.left();
    walk_.step(walk_.left());
    begin_next(0.0);
  }
  walk_.step(seconds);
  aim();
  late_ = moving_ ? 0.0 : seconds;
  if (!due) return duties_;
  duties_ = tracker().follow(sense, target_, estimate_);
  if (parts_.tracker != nullptr) duties_ = {duty_of(duties_.left), duty_of(duties_.right)};
  return duties_;
}

/// Ignores an invalid estimate, which only an external part can return.
void Controller::believe(const PoseEstimate& estimate) {
  if (parts_.estimator == nullptr || estimate.is_valid()) estimate_ = estimate;
}

}  // namespace labmouse
