#include "labmouse/mouse/robot/turn_drive.hpp"

#include <algorithm>
#include <cmath>

namespace labmouse {
namespace {

/// The curvature of a turn, rad/mm, and its growth, rad/mm², at a distance from the beginning of its curve.
struct Bend {
  double curvature = 0.0;
  double growth = 0.0;
};

Bend bend_at(const TurnShape& shape, double distance) {
  if (!shape.parts.empty()) {
    // A bend to the right is driven as its mirror image.
    const double curvature = shape.curvature_at(shape.lead_in + distance), growth = shape.growth_at(distance);
    return curvature < 0.0 ? Bend{-curvature, -growth} : Bend{curvature, growth};
  }
  const RampPath& ramp = shape.ramp;
  const double left = shape.length - distance;
  if (distance < ramp.length) return {ramp.curvature_at(distance), ramp.growth_at(distance)};
  if (left < ramp.length) return {ramp.curvature_at(left), -ramp.growth_at(left)};
  return {ramp.peak, 0.0};
}

/// The bends at the ends of the steps of a drive and in the middle between them.
using Bends = std::array<Bend, 2 * TurnDrive::steps + 1>;

Bends bends_of(const TurnShape& shape) {
  const double step = shape.length / TurnDrive::steps;
  Bends bends;
  for (int i = 0; i <= 2 * TurnDrive::steps; ++i) bends[static_cast<std::size_t>(i)] = bend_at(shape, step * (i / 2.0));
  return bends;
}

/// The bends of the same path driven backwards. A path of another than a free shape is its own mirror image.
Bends reversed(const Bends& bends, const TurnShape& shape) {
  if (shape.parts.empty()) return bends;
  Bends back;
  std::transform(bends.rbegin(), bends.rend(), back.begin(), [](const Bend& bend) {
    return Bend{bend.curvature, -bend.growth};
  });
  return back;
}

/// The square of the longitudinal acceleration that the grip leaves, for the square of a speed.
double left_of_grip(double squared_speed, const Bend& bend, double grip) {
  const double lateral = squared_speed * bend.curvature;
  return grip * grip - lateral * lateral;
}

/// The largest acceleration there: within its own limit, its grip, and its yaw acceleration, which is v² times the
/// growth of the curvature plus the acceleration times the curvature.
double acceleration_at(double squared_speed, const Bend& bend, double own, const Robot& robot) {
  const double grip = left_of_grip(squared_speed, bend, robot.grip);
  if (grip <= 0.0) return 0.0;
  double most = std::min(own, std::sqrt(grip));
  if (bend.curvature > 0.0)
    most = std::min(most, (robot.yaw_acceleration - squared_speed * bend.growth) / bend.curvature);
  return std::max(0.0, most);
}

/// The largest square of a speed at which a path of free shape keeps the limits at a place and half a step before and
/// after it, at a constant speed.
double square_limit(const Bends& bends, std::size_t place, const Robot& robot) {
  constexpr double none = 1e-12;
  double curvature = none, growth = none;
  for (std::size_t i = place - 1; i <= std::min(place + 1, bends.size() - 1); ++i) {
    curvature = std::max(curvature, bends[i].curvature);
    growth = std::max(growth, std::abs(bends[i].growth));
  }
  double most = std::min(robot.lateral_acceleration / curvature, robot.yaw_acceleration / growth);
  if (robot.yaw_speed > 0.0) {
    const double speed = robot.yaw_speed / curvature;
    most = std::min(most, speed * speed);
  }
  return most;
}

/// The squares of the speeds along the curve, accelerating from the first as hard as allowed, up to a top speed. Along
/// a path of free shape they may fall where the path allows less.
std::array<double, TurnDrive::steps + 1> rise(const TurnShape& shape, const Bends& bends, double from, double top,
                                              double own, const Robot& robot) {
  std::array<double, TurnDrive::steps + 1> squares{};
  const double step = shape.length / TurnDrive::steps;
  squares[0] = from * from;
  for (std::size_t i = 0; i < TurnDrive::steps; ++i) {
    const double here = squares[i];
    const double most = shape.parts.empty() ? top * top : std::min(top * top, square_limit(bends, 2 * i + 2, robot));
    const auto limit = [&](double squared_speed, std::size_t place) {
      return acceleration_at(squared_speed, bends[place], own, robot);
    };
    const auto after = [&](double acceleration) { return std::min(most, here + 2.0 * acceleration * step); };
    // What is allowed all along the step, at the speeds that it leads to.
    double acceleration = limit(here, 2 * i);
    for (int round = 0; round < 3; ++round)
      acceleration =
          std::min({acceleration, limit(after(acceleration), 2 * i + 1), limit(after(acceleration), 2 * i + 2)});
    squares[i + 1] = after(acceleration);
  }
  return squares;
}

/// The largest acceleration and braking on a turn: those of the straights about it.
struct Accelerations {
  double up, down;
};
Accelerations accelerations(Turn turn, const Robot& robot) {
  if (!begins_diagonal(turn) && !ends_diagonal(turn)) return {robot.acceleration, robot.braking};
  return {std::min(robot.acceleration, robot.acceleration_diagonal), std::min(robot.braking, robot.braking_diagonal)};
}

}  // namespace

std::optional<TurnDrive> turn_drive(const TurnShape& shape, double from, double to, double top, const Robot& robot) {
  const auto [up, down] = accelerations(shape.turn, robot);
  const Bends bends = bends_of(shape);
  // Braking along the curve is speeding up from its end.
  const auto forwards = rise(shape, bends, from, top, up, robot);
  const auto backwards = rise(shape, reversed(bends, shape), to, top, down, robot);
  constexpr double slack = 1e-9;
  if (forwards.back() < to * to * (1.0 - slack) || backwards.back() < from * from * (1.0 - slack)) return std::nullopt;
  TurnDrive drive;
  for (std::size_t i = 0; i < drive.speeds.size(); ++i)
    drive.speeds[i] = std::sqrt(std::min(forwards[i], backwards[TurnDrive::steps - i]));
  for (std::size_t i = 0; i < TurnDrive::steps; ++i)
    drive.seconds += 2.0 * shape.length / TurnDrive::steps / (drive.speeds[i] + drive.speeds[i + 1]);
  return drive;
}

double end_speed_of(const TurnShape& shape, double top, const Robot& robot) {
  const auto [up, down] = accelerations(shape.turn, robot);
  const Bends bends = bends_of(shape);
  const double first = rise(shape, reversed(bends, shape), top, top, down, robot).back();
  return std::sqrt(std::min(first, rise(shape, bends, top, top, up, robot).back()));
}

}  // namespace labmouse
