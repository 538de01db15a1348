#include "labmouse/mouse/robot/turn_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/functions/angles.hpp"
#include "labmouse/functions/position.hpp"
#include "labmouse/mouse/robot/path_integral.hpp"

namespace labmouse {
namespace {

double angle_of(Turn turn) { return eighths(turn) * (pi / 4.0); }

/// The direction at the end of a turn; exact for quarters of a circle.
Direction end_direction(Turn turn) {
  const Position way = way_of_eighths(eighths(turn));
  return {way.x, way.y};
}

/// A point of the shape's curve at a distance from where the curve begins; the curve is symmetric.
PathPoint on_curve(const TurnShape& shape, double distance) {
  const double peak = shape.ramp.peak;
  const PathPoint point = shape.ramp.at(std::min(distance, shape.ramp.length));
  if (distance <= shape.ramp.length) return point;
  const double angle = point.angle + peak * (distance - shape.ramp.length);
  const Direction before = direction_of(point.angle);
  const Direction after = direction_of(angle);
  return {point.ahead + (after.sine - before.sine) / peak, point.aside + (before.cosine - after.cosine) / peak, angle};
}

/// The part of a curve of free shape at a distance from where the curve begins, and the distance from its own
/// beginning.
struct PartAt {
  const CurvePart& part;
  double distance;
};

PartAt part_at(const TurnShape& shape, double distance) {
  std::size_t i = 0;
  while (i + 1 < shape.parts.size() && distance > shape.parts[i].length) distance -= shape.parts[i++].length;
  return {shape.parts[i], std::min(distance, shape.parts[i].length)};
}

/// Where the curve ends, seen from its beginning. Unless its shape is free, its two halves are mirror images.
PathPoint curve_end(const TurnShape& shape) {
  if (!shape.parts.empty()) return shape.parts.back().at(shape.parts.back().length);
  const PathPoint middle = on_curve(shape, shape.length / 2.0);
  // The axis of the mirror is at half the angle; the second half is the first one, mirrored.
  const Direction end = end_direction(shape.turn);
  return {middle.ahead * (1.0 + end.cosine) + middle.aside * end.sine,
          middle.ahead * end.sine + middle.aside * (1.0 - end.cosine), angle_of(shape.turn)};
}

/// Sets the leads that put a curve with that end between the nodes of a turn.
void set_leads(TurnShape& shape, const PathPoint& curve) {
  const Direction end = end_direction(shape.turn);
  shape.lead_out = (shape.end.aside - curve.aside) / end.sine;
  shape.lead_in = shape.end.ahead - curve.ahead - shape.lead_out * end.cosine;
  const bool symmetric = shape.turn == Turn::f90 || shape.turn == Turn::v90 || shape.turn == Turn::s90;
  if (symmetric) shape.lead_in = shape.lead_out;
}

/// A curve eight times as long as each of its clothoids, not yet put between its nodes.
TurnShape curve_of_eighths(Turn turn, double ramp) {
  TurnShape shape;
  shape.turn = turn;
  shape.ramp = {ramp, 0.0, angle_of(turn) / (7.0 * ramp), TurnProfile::trapezoid};
  shape.length = 8.0 * ramp;
  return shape;
}

}  // namespace

TurnShape placed(TurnShape shape, double cell) {
  shape.end = end_of(shape.turn, cell);
  if (shape.turn == Turn::f180)
    shape.lead_in = shape.lead_out = cell / 2.0;
  else
    set_leads(shape, curve_end(shape));
  return shape;
}

PathPoint CurvePart::at(double distance) const {
  const auto angle_at = [&](double driven) {
    return begin.angle + driven * (curvature + driven * (growth / 2.0 + driven * bend / 6.0));
  };
  PathPoint point{begin.ahead, begin.aside, angle_at(distance)};
  move_along(angle_at, 0.0, distance, point);
  return point;
}

PathPoint join(std::vector<CurvePart>& parts) {
  PathPoint end;
  for (CurvePart& part : parts) {
    part.begin = end;
    end = part.at(part.length);
  }
  return end;
}

PathPoint end_of(Turn turn, double cell) {
  constexpr double half = way_of_eighths(1).x;  // square root of 1/2
  constexpr std::array<PathPoint, 8> ends = {{{1.0, 0.5},
                                              {1.0, 1.0},
                                              {0.5, 1.0},
                                              {0.0, 1.0},
                                              {half, half},
                                              {0.5, 0.5},
                                              {1.5 * half, 0.5 * half},
                                              {0.5 * half, 1.5 * half}}};
  const PathPoint& end = ends[static_cast<unsigned>(turn)];
  return {end.ahead * cell, end.aside * cell, angle_of(turn)};
}

PathPoint TurnShape::at(double distance) const {
  const double left = whole() - distance;
  const Direction out = end_direction(turn);
  if (distance <= lead_in) return {distance, 0.0, 0.0};
  if (left <= lead_out) return {end.ahead - left * out.cosine, end.aside - left * out.sine, end.angle};
  if (!parts.empty()) {
    const auto [part, driven] = part_at(*this, distance - lead_in);
    const PathPoint point = part.at(driven);
    return {lead_in + point.ahead, point.aside, point.angle};
  }
  if (distance - lead_in <= length / 2.0) {
    const PathPoint point = on_curve(*this, distance - lead_in);
    return {lead_in + point.ahead, point.aside, point.angle};
  }
  // From its end the curve is its own mirror image.
  const PathPoint point = on_curve(*this, left - lead_out);
  const double back = lead_out + point.ahead;
  return {end.ahead - back * out.cosine - point.aside * out.sine,
          end.aside - back * out.sine + point.aside * out.cosine, end.angle - point.angle};
}

double TurnShape::curvature_at(double distance) const {
  const double driven = distance - lead_in;
  if (driven <= 0.0 || driven >= length) return 0.0;
  if (!parts.empty()) {
    const auto [part, within] = part_at(*this, driven);
    return part.curvature_at(within);
  }
  return ramp.curvature_at(std::min({driven, length - driven, ramp.length}));
}

double TurnShape::growth_at(double driven) const {
  if (!parts.empty()) {
    const auto [part, within] = part_at(*this, driven);
    return part.growth_at(within);
  }
  const double left = length - driven;
  if (driven < ramp.length) return ramp.growth_at(driven);
  return left < ramp.length ? -ramp.growth_at(left) : 0.0;
}

TurnShape shape_at(Turn turn, double speed, const CurveLimits& limits, double cell) {
  const double angle = angle_of(turn);
  double yaw_rate = limits.lateral_acceleration / speed;
  if (limits.yaw_speed > 0.0) yaw_rate = std::min(yaw_rate, limits.yaw_speed);
  YawRamp ramp = ramp_to(yaw_rate, limits);
  if (ramp.rate * ramp.seconds > angle) ramp = ramp_of_half(angle, limits);
  TurnShape shape;
  shape.turn = turn;
  shape.ramp = {speed * ramp.seconds, speed * ramp.onset, ramp.rate / speed, limits.profile};
  shape.length = angle / shape.ramp.peak + shape.ramp.length;
  return placed(shape, cell);
}

double width_of(const TurnShape& shape) { return curve_end(shape).aside; }

TurnShape plain_shape(Turn turn, double cell) {
  const TurnShape unit = curve_of_eighths(turn, 1.0);
  if (turn == Turn::f180) return placed(curve_of_eighths(turn, cell / width_of(unit)), cell);
  // A sharp corner has the longest leads; they shrink linearly with the length of the curve.
  TurnShape corner = unit;
  corner.end = end_of(turn, cell);
  set_leads(corner, {});
  TurnShape taken = unit;
  taken.end = {};
  set_leads(taken, curve_end(unit));
  const double ramp = std::min(corner.lead_in / -taken.lead_in, corner.lead_out / -taken.lead_out);
  TurnShape shape = placed(curve_of_eighths(turn, ramp), cell);
  shape.lead_in = std::max(0.0, shape.lead_in);
  shape.lead_out = std::max(0.0, shape.lead_out);
  return shape;
}

TurnShape backwards(const TurnShape& shape) {
  TurnShape back = shape;
  back.turn = reversed(shape.turn);
  std::swap(back.lead_in, back.lead_out);
  const Direction out = end_direction(shape.turn);
  back.end = {shape.end.ahead * out.cosine + shape.end.aside * out.sine,
              shape.end.ahead * out.sine - shape.end.aside * out.cosine, shape.end.angle};
  std::reverse(back.parts.begin(), back.parts.end());
  for (CurvePart& part : back.parts) {
    const double curvature = part.curvature_at(part.length), growth = part.growth_at(part.length);
    part.curvature = curvature;
    part.growth = -growth;
  }
  join(back.parts);
  return back;
}

}  // namespace labmouse
