// The fastest way to drive a turn: that it keeps away from walls, and cannot be driven faster.
#include "labmouse/mouse/robot/fitted_turn.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <tuple>

#include "tests/mouse/drive_robots.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::Says;

constexpr std::array forward_turns = {Turn::f45, Turn::f90, Turn::f135, Turn::f180, Turn::v90, Turn::s90};

/// The walls that each turn needs open, in cells from where it begins: ahead and to the left, from post to post. For
/// V90 in the axes of the maze: it begins at the middle of the wall from (-1/2, 0) to (1/2, 0) and drives north-west.
struct Stretch {
  double x0, y0, x1, y1;
};

std::vector<Stretch> open_stretches(Turn turn) {
  const Stretch front{0.5, -0.5, 0.5, 0.5};
  const Stretch side{0.5, 0.5, 1.5, 0.5};
  const Stretch front_of_side{1.5, 0.5, 1.5, 1.5};
  const Stretch back_of_side{0.5, 0.5, 0.5, 1.5};
  const Stretch far_side{-0.5, 1.5, 0.5, 1.5};
  switch (turn) {
    case Turn::f45:
      return {front, side, front_of_side};
    case Turn::f90:
      return {front, side};
    case Turn::f135:
      return {front, side, back_of_side, far_side};
    case Turn::f180:
      return {front, side, back_of_side};
    case Turn::v90:
      return {front, side, back_of_side, far_side};
    default:
      return {front, side};
  }
}

double gap(double x, double y, const Stretch& wall) {
  const double dx = wall.x1 - wall.x0;
  const double dy = wall.y1 - wall.y0;
  const double share = std::clamp((x - wall.x0) * dx + (y - wall.y0) * dy, 0.0, 1.0);
  return std::hypot(x - wall.x0 - share * dx, y - wall.y0 - share * dy);
}

/// Distance to everything that may stand between the posts at (i + 1/2, j + 1/2), by 20,000 samples.
double sampled_clearance(const TurnShape& shape, double cell) {
  std::vector<Stretch> walls;
  for (double x = -2.5; x < 4.0; ++x)
    for (double y = -2.5; y < 4.0; ++y) {
      walls.push_back({x, y, x + 1.0, y});
      walls.push_back({x, y, x, y + 1.0});
    }
  for (const Stretch& open : open_stretches(shape.turn))
    std::erase_if(walls, [&](const Stretch& wall) { return std::memcmp(&wall, &open, sizeof wall) == 0; });
  double nearest = 100.0;
  for (int i = 0; i <= 20'000; ++i) {
    const PathPoint point = shape.at(shape.whole() * i / 20'000);
    double x = point.ahead / cell;
    double y = point.aside / cell;
    if (shape.turn == Turn::s90) x += 0.5;
    if (shape.turn == Turn::v90) {
      const double root = std::sqrt(0.5);
      std::tie(x, y) = std::pair(0.5 + (x - y) * root, (x + y) * root);
    }
    for (const Stretch& wall : walls) nearest = std::min(nearest, gap(x, y, wall));
  }
  return nearest * cell;
}

TEST(FittedTurn, KeepsItsClearanceOfPostsAndWalls) {
  LABMOUSE_SKIP_SANITIZED();
  for (const Robot& robot : {small_robot(), large_robot(), fan_robot(), jerk_robot(), large_jerk_robot()})
    for (const Turn turn : forward_turns) {
      const FittedTurn fitted = fitted_turn(turn, robot);
      const double sampled = sampled_clearance(fitted.shape, robot.cell);
      EXPECT_NEAR(fitted.shape.clearance, sampled, 0.001) << robot.name << " " << name_of(turn);
      EXPECT_GE(sampled, robot.clearance) << robot.name << " " << name_of(turn);
    }
}

TEST(FittedTurn, FitsNoMoreWhen5MillimetresASecondFaster) {
  for (const Robot& robot : {small_robot(), large_robot(), fan_robot(), large_jerk_robot()})
    for (const Turn turn : forward_turns) {
      if (turn == Turn::f180) continue;
      const FittedTurn fitted = fitted_turn(turn, robot);
      const TurnShape faster = shape_at(turn, fitted.speed + 5.0, curve_limits(robot), robot.cell);
      EXPECT_TRUE(faster.lead_in < 0.0 || faster.lead_out < 0.0 ||
                  sampled_clearance(faster, robot.cell) < robot.clearance)
          << robot.name << " " << name_of(turn);
    }
}

TEST(FittedTurn, IsNeverFasterThanItsStraights) {
  Robot robot = large_robot();
  robot.speed = 1203.0;
  robot.speed_diagonal = 1001.0;
  EXPECT_EQ(fitted_turn(Turn::f45, robot).speed, 1000.0);
  EXPECT_EQ(fitted_turn(Turn::f90, robot).speed, 1200.0);
  EXPECT_EQ(fitted_turn(Turn::v90, robot).speed, 1000.0);
  robot.speed = 900.5;
  const FittedTurn around_post = fitted_turn(Turn::f180, robot);
  EXPECT_EQ(around_post.speed, 900.5);
  EXPECT_NEAR(width_of(around_post.shape), robot.cell, 1e-9);
}

/// Figures of a first model, which tested posts only. The walls about a turn change none of these speeds.
struct Example {
  Turn turn;
  double speed, milliseconds, lead_in, lead_out;
};

void expect_examples(const Robot& robot, const std::vector<Example>& examples) {
  for (const Example& example : examples) {
    const FittedTurn fitted = fitted_turn(example.turn, robot);
    const std::string it = robot.name + " " + std::string(name_of(example.turn));
    EXPECT_EQ(std::round(fitted.speed), example.speed) << it;
    EXPECT_NEAR(fitted.shape.length / fitted.speed * 1e3, example.milliseconds, 0.6) << it;
    EXPECT_NEAR(fitted.shape.lead_in, example.lead_in, 0.6) << it;
    EXPECT_NEAR(fitted.shape.lead_out, example.lead_out, 0.6) << it;
  }
}

TEST(FittedTurn, DrivesTheKnownExamples) {
  expect_examples(small_robot(), {{Turn::f45, 595, 144, 0, 19},
                                  {Turn::f90, 560, 254, 1, 1},
                                  {Turn::f135, 435, 299, 8, 0},
                                  {Turn::f180, 413, 372, 45, 45},
                                  {Turn::v90, 465, 220, 0, 0}});
  expect_examples(large_robot(), {{Turn::f45, 1325, 129, 0, 38},
                                  {Turn::f90, 1275, 226, 0, 0},
                                  {Turn::f135, 970, 263, 25, 10},
                                  {Turn::f180, 946, 332, 90, 90},
                                  {Turn::v90, 1035, 195, 3, 3}});
  Robot fan = fan_robot();
  fan.speed_diagonal = 3000.0;
  for (const auto& [turn, speed, milliseconds] : {std::tuple{Turn::f45, 2365, 73},
                                                  {Turn::f90, 2240, 128},
                                                  {Turn::f135, 1685, 147},
                                                  {Turn::f180, 1641, 187},
                                                  {Turn::v90, 1795, 108}}) {
    const FittedTurn fitted = fitted_turn(turn, fan);
    EXPECT_EQ(std::round(fitted.speed), speed) << name_of(turn);
    EXPECT_NEAR(fitted.shape.length / fitted.speed * 1e3, milliseconds, 0.6) << name_of(turn);
  }
}

TEST(FittedTurn, OfASlowRobotIsOnThePathOfAFasterOne) {
  const Robot robot = slow_robot();
  const FittedTurn fitted = fitted_turn(Turn::f135, robot);
  EXPECT_EQ(fitted.error, "");
  EXPECT_EQ(fitted.speed, 50.0);
  EXPECT_LT(shape_at(Turn::f135, 50.0, curve_limits(robot), robot.cell).length, fitted.shape.length);
  EXPECT_GE(sampled_clearance(fitted.shape, robot.cell), robot.clearance);
}

TEST(FittedTurn, TakesThePathThatIsGiven) {
  Robot robot = large_robot();
  robot.layouts[static_cast<unsigned>(Turn::f90)].given = 800.0;
  const FittedTurn fitted = fitted_turn(Turn::f90, robot);
  EXPECT_EQ(fitted.speed, 800.0);
  EXPECT_EQ(fitted.shape.length, shape_at(Turn::f90, 800.0, curve_limits(robot), robot.cell).length);
  robot.layouts[static_cast<unsigned>(Turn::f180)].given = 30.0;
  EXPECT_EQ(fitted_turn(Turn::f180, robot).shape.lead_in, 30.0);
  robot.layouts[static_cast<unsigned>(Turn::f90)].given = 2000.0;
  EXPECT_THAT(fitted_turn(Turn::f90, robot).error, Says("90", "2000 mm/s", "mm"));
  robot.layouts[static_cast<unsigned>(Turn::f135)].given = 300.0;
  EXPECT_THAT(fitted_turn(Turn::f135, robot).error, Says("135", "300 mm/s", "clearance of 45 mm"));
}

TEST(FittedTurn, ShortensTheLeadsAroundAPostWhereTheWallAheadIsNear) {
  Robot robot = large_robot();
  robot.yaw_acceleration = 50.0;
  const TurnShape shape = fitted_turn(Turn::f180, robot).shape;
  EXPECT_LT(shape.lead_in, 90.0);
  EXPECT_EQ(shape.lead_in, shape.lead_out);
  EXPECT_NEAR(shape.clearance, sampled_clearance(shape, robot.cell), 0.001);
  EXPECT_GE(shape.clearance, robot.clearance);
}

TEST(FittedTurn, SaysInMillimetresWhatDoesNotFit) {
  Robot robot = large_robot();
  robot.clearance = 70.0;
  EXPECT_THAT(fitted_turn(Turn::f45, robot).error, Says("turn 45 ", "180 mm", "70 mm", "80 mm/s", "63.6 mm"));
  robot.clearance = 100.0;
  EXPECT_THAT(fitted_turn(Turn::f180, robot).error, Says("turn 180 ", "180 mm", "100 mm", "946 mm/s", "79.1 mm"));
}

}  // namespace
}  // namespace labmouse
