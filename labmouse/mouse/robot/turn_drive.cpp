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
  const RampPath& ramp = shape.ramp;
  const double left = shape.length - distance;
  if (distance < ramp.length) return {ramp.curvature_at(distance), ramp.growth_at(distance)};
  if (left < ramp.length) return {ramp.curvature_at(left), -ramp.growth_at(left)};
  return {ramp.peak, 0.0};
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

/// The squares of the speeds along the curve, accelerating from the first as hard as allowed, up to a top speed.
std::array<double, TurnDrive::steps + 1> rise(const TurnShape& shape, double from, double top, double own,
                                              const Robot& robot) {
  std::array<double, TurnDrive::steps + 1> squares{};
  const double step = shape.length / TurnDrive::steps;
  squares[0] = from * from;
  for (int i = 0; i < TurnDrive::steps; ++i) {
    const double here = squares[static_cast<std::size_t>(i)];
    const auto limit = [&](double squared_speed, double distance) {
      return acceleration_at(squared_speed, bend_at(shape, distance), own, robot);
    };
    const auto after = [&](double acceleration) { return std::min(top * top, here + 2.0 * acceleration * step); };
    // What is allowed all along the step, at the speeds that it leads to.
    double acceleration = limit(here, step * i);
    for (int round = 0; round < 3; ++round)
      acceleration = std::min(
          {acceleration, limit(after(acceleration), step * (i + 0.5)), limit(after(acceleration), step * (i + 1))});
    squares[static_cast<std::size_t>(i) + 1] = after(acceleration);
  }
  return squares;
}

}  // namespace

std::optional<TurnDrive> turn_drive(const TurnShape& shape, double from, double to, double top, const Robot& robot) {
  const bool diagonal = begins_diagonal(shape.turn) || ends_diagonal(shape.turn);
  const double up = diagonal ? std::min(robot.acceleration, robot.acceleration_diagonal) : robot.acceleration;
  const double down = diagonal ? std::min(robot.braking, robot.braking_diagonal) : robot.braking;
  // The curve is its own mirror image: braking along it is speeding up from its end.
  const auto forwards = rise(shape, from, top, up, robot), backwards = rise(shape, to, top, down, robot);
  constexpr double slack = 1e-9;
  if (forwards.back() < to * to * (1.0 - slack) || backwards.back() < from * from * (1.0 - slack)) return std::nullopt;
  TurnDrive drive;
  for (std::size_t i = 0; i < drive.speeds.size(); ++i)
    drive.speeds[i] = std::sqrt(std::min(forwards[i], backwards[TurnDrive::steps - i]));
  for (std::size_t i = 0; i < TurnDrive::steps; ++i)
    drive.seconds += 2.0 * shape.length / TurnDrive::steps / (drive.speeds[i] + drive.speeds[i + 1]);
  return drive;
}

}  // namespace labmouse
