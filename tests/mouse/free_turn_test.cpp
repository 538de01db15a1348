// Turns of free shape: that they keep the limits, and that no simple path is faster.
#include "labmouse/mouse/robot/free_turn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "labmouse/functions/angles.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/straights.hpp"
#include "labmouse/mouse/robot/turn_room.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

constexpr std::array forward_turns = {Turn::f45, Turn::f90, Turn::f135, Turn::f180, Turn::v90, Turn::s90};

Robot freed_robot(const Robot& robot) { return with_profile(robot, TurnProfile::free); }

std::vector<Robot> robots() { return {grip_robot(), small_grip_robot(), large_robot(), small_robot(), fan_robot()}; }

/// The distance to posts and walls that may stand, by many samples of the path.
double sampled_clearance(const TurnShape& shape, double cell) {
  const TurnRoom room = room_of(shape.turn);
  double nearest = 4.0;
  for (int i = 0; i <= 4000; ++i) {
    const MazePoint point = maze_point(room.from, true, shape.at(shape.whole() * i / 4000), cell);
    for (const Wall wall : room.standing) nearest = std::min(nearest, distance(point, wall));
  }
  return nearest * cell;
}

TEST(FreeTurn, LeadsFromNodeToNodeAndKeepsTheClearance) {
  LABMOUSE_SKIP_SANITIZED();
  for (const Robot& robot : robots())
    for (const Turn turn : forward_turns) {
      SCOPED_TRACE(robot.name + " " + std::string(name_of(turn)));
      const FittedTurn free = freed(fitted_turn(turn, robot), turn_top_speed(turn, robot), robot);
      const TurnShape& shape = free.shape;
      EXPECT_GE(sampled_clearance(shape, robot.cell), robot.clearance);
      EXPECT_GE(shape.lead_in, 0.0);
      EXPECT_GE(shape.lead_out, 0.0);
      // The last part ends where the last straight begins.
      const PathPoint curve = shape.parts.back().at(shape.parts.back().length), end = end_of(turn, robot.cell);
      const Direction out = direction_of(end.angle);
      EXPECT_NEAR(curve.angle, end.angle, 1e-9);
      EXPECT_NEAR(shape.lead_in + curve.ahead + shape.lead_out * out.cosine, end.ahead, 1e-6);
      EXPECT_NEAR(curve.aside + shape.lead_out * out.sine, end.aside, 1e-6);
    }
}

TEST(FreeTurn, IsNoSlowerThanATrapezoid) {
  for (const Robot& robot : robots())
    for (const Turn turn : forward_turns) {
      SCOPED_TRACE(robot.name + " " + std::string(name_of(turn)));
      const FittedTurn plain = fitted_turn(turn, robot);
      const FittedTurn free = freed(plain, turn_top_speed(turn, robot), robot);
      EXPECT_GE(free.speed, plain.speed * (1.0 - 1e-9));
      // The plain turn at one speed, with a straight of a cell on either side.
      const double plain_cost = cost_of(plain.shape, plain.speed, plain.speed, plain.shape.length / plain.speed, robot);
      EXPECT_LE(cost_of(free, robot), plain_cost * (1.0 + 1e-9));
    }
}

/// With grip, each turn gains, up to a tenth of its time and more.
TEST(FreeTurn, OfARobotWithGripIsFaster) {
  const Robot robot = grip_robot();
  for (const Turn turn : forward_turns) {
    const FittedTurn plain = fitted_turn(turn, robot);
    const FittedTurn free = freed(plain, turn_top_speed(turn, robot), robot);
    const double plain_cost = cost_of(plain.shape, plain.speed, plain.speed, plain.shape.length / plain.speed, robot);
    EXPECT_LT(cost_of(free, robot), plain_cost * (turn == Turn::f180 ? 0.93 : 0.998)) << name_of(turn);
    EXPECT_GT(free.speed, plain.speed + 20.0) << name_of(turn);
  }
}

/// Where the yaw acceleration is no limit, an arc fills S90 and goes around the post of a 180, behind straights as long
/// as the clearance.
TEST(FreeTurn, IsAsFastAsAnArcWhereOnlyTheTyresLimitIt) {
  Robot robot = large_robot();
  robot.yaw_acceleration = 1e6;
  const double radius = robot.cell / 2.0, speed = std::sqrt(robot.lateral_acceleration * radius);
  for (const Turn turn : {Turn::s90, Turn::f180}) {
    const FittedTurn free = freed(fitted_turn(turn, robot), turn_top_speed(turn, robot), robot);
    TurnShape arc;
    arc.turn = turn;
    arc.lead_in = arc.lead_out = turn == Turn::f180 ? robot.clearance : 0.0;
    const double seconds = eighths(turn) * pi / 4.0 * radius / speed;
    EXPECT_NEAR(cost_of(free, robot) / cost_of(arc, speed, speed, seconds, robot), 1.0, 0.004) << name_of(turn);
  }
}

/// Seconds of a small turn of a robot with grip, with a cell of straight on either side, whose curvature rises evenly
/// over a share of its first half, stays, and falls: by small steps in which the speed keeps all limits. It begins and
/// ends as fast as that leaves it.
double seconds_by_steps(double rise, const Robot& robot) {
  constexpr int steps = 2000;  // of half the curve, which has a length of 1
  const double peak = pi / 4.0 / (1.0 - rise / 2.0);
  const auto curvature = [&](double place) { return place < rise ? peak * place / rise : peak; };
  double angle = 0.0, x = 0.0, y = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double bend = curvature((i + 0.5) / steps);
    x += std::cos(angle + bend / steps / 2.0) / steps;
    y += std::sin(angle + bend / steps / 2.0) / steps;
    angle += bend / steps;
  }
  // The middle of the curve lies on the line through the corner of both straights at 45 degrees.
  const double scale = robot.cell / 2.0 / (x + y);
  const double step = scale / steps;
  // Backwards from the middle, where it is slowest.
  double square = robot.lateral_acceleration / (peak / scale), seconds = 0.0;
  if (rise >= 1.0) square = std::min(square, robot.yaw_acceleration * rise * scale * scale / peak);
  for (int i = steps; i-- > 0;) {
    const double bend = curvature((i + 0.5) / steps) / scale;
    const double growth = (i + 0.5) / steps < rise ? peak / rise / (scale * scale) : 0.0;
    const double lateral = square * bend;
    double acceleration = std::sqrt(std::max(0.0, robot.grip * robot.grip - lateral * lateral));
    acceleration = std::min({acceleration, robot.acceleration, robot.braking});
    // Seen backwards the curvature falls: the yaw acceleration is that of the speed less that of the curvature.
    acceleration = std::min(acceleration, (robot.yaw_acceleration + square * growth) / bend);
    double next = square + 2.0 * acceleration * step;
    next = std::min(next, robot.lateral_acceleration / bend);
    if (growth > 0.0) next = std::min(next, robot.yaw_acceleration / growth);
    seconds += 2.0 * step / (std::sqrt(square) + std::sqrt(next));
    square = next;
  }
  TurnShape shape;
  shape.turn = Turn::s90;
  return cost_of(shape, std::sqrt(square), std::sqrt(square), 2.0 * seconds, robot);
}

TEST(FreeTurn, IsAsFastAsTheBestOfManySmallTurns) {
  for (const Robot& robot : {grip_robot(), small_grip_robot()}) {
    double best = 1e9;
    for (int i = 1; i <= 100; ++i) best = std::min(best, seconds_by_steps(i / 100.0, robot));
    const FittedTurn free = freed(fitted_turn(Turn::s90, robot), turn_top_speed(Turn::s90, robot), robot);
    EXPECT_LT(cost_of(free, robot), best * 1.002) << robot.name;
    EXPECT_GT(cost_of(free, robot), best * 0.97) << robot.name;
  }
}

/// The paths of one turn share their leads, so that its speeds can follow each other.
TEST(FreeTurn, GetsStraightsWhereOtherPathsBeginEarlier) {
  const Robot robot = grip_robot();
  const FittedTurn plain = fitted_turn(Turn::f180, robot);
  std::vector<FittedTurn> paths = {freed(plain, 3000.0, robot), freed(plain, plain.speed, robot)};
  const std::vector<FittedTurn> before = paths;
  share_leads(paths);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    EXPECT_EQ(paths[i].shape.lead_in, std::min(before[0].shape.lead_in, before[1].shape.lead_in));
    EXPECT_NEAR(paths[i].shape.whole(), before[i].shape.whole(), 1e-9);
    for (double share = 0.0; share <= 1.0; share += 0.1) {
      const PathPoint a = paths[i].shape.at(share * paths[i].shape.whole());
      const PathPoint b = before[i].shape.at(share * before[i].shape.whole());
      EXPECT_NEAR(a.ahead, b.ahead, 1e-6);
      EXPECT_NEAR(a.aside, b.aside, 1e-6);
    }
  }
}

/// A robot searches on the same path whether its turns are free or not.
TEST(FreeTurn, LeavesTheSearchAsItIs) {
  for (const Robot& robot : {grip_robot(), large_robot()})
    EXPECT_EQ(make_drive_model(robot).search, make_drive_model(freed_robot(robot)).search);
}

TEST(FreeTurn, IsDrivenBackwardsOnTheSamePath) {
  const Robot robot = grip_robot();
  const FittedTurn free = freed(fitted_turn(Turn::f135, robot), 3000.0, robot);
  const TurnShape back = backwards(free.shape);
  EXPECT_EQ(back.turn, Turn::out135);
  for (double share = 0.0; share <= 1.0; share += 0.05) {
    const double driven = share * free.shape.length;
    EXPECT_NEAR(back.curvature_at(back.lead_in + driven),
                free.shape.curvature_at(free.shape.lead_in + free.shape.length - driven), 1e-9);
  }
  const PathPoint end = back.at(back.whole() - back.lead_out), node = back.at(back.whole());
  EXPECT_NEAR(std::hypot(node.ahead - end.ahead, node.aside - end.aside), back.lead_out, 1e-6);
}

}  // namespace
}  // namespace labmouse
