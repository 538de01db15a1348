// The curves of turns: that they are smooth and lead from node to node.
#include "labmouse/mouse/robot/turn_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/functions/angles.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/turn_room.hpp"
#include "tests/mouse/drive_robots.hpp"

namespace labmouse {
namespace {

constexpr std::array forward_turns = {Turn::f45, Turn::f90, Turn::f135, Turn::f180, Turn::v90, Turn::s90};

struct TurnOfRobot {
  Robot robot;
  DrivenTurn turn;
  TurnShape shape;
};

std::vector<TurnOfRobot> all_turns_of_all_robots() {
  std::vector<TurnOfRobot> all;
  for (const Robot& robot :
       {published_robot(), small_robot(), large_robot(), fan_robot(), jerk_robot(), large_jerk_robot(), square_robot(),
        slow_robot(), strong_robot(), with_profile(large_robot(), TurnProfile::sine),
        with_profile(large_jerk_robot(), TurnProfile::cubic), with_profile(large_robot(), TurnProfile::free),
        with_profile(large_jerk_robot(), TurnProfile::free)}) {
    const DriveModel model = make_drive_model(robot);
    EXPECT_EQ(model.error, "") << robot.name;
    EXPECT_EQ(model.shapes.size(), model.tables.turns.size());
    for (std::size_t i = 0; i < model.shapes.size(); ++i)
      all.push_back({robot, model.tables.turns[i], model.shapes[i]});
  }
  return all;
}

bool back(Turn turn) { return turn == Turn::out45 || turn == Turn::out135; }

std::string words(const TurnOfRobot& it) { return it.robot.name + " " + std::string(name_of(it.turn.turn)); }

TEST(TurnRoom, JoinsNodesThatTheTurnLeadsBetween) {
  for (const Turn turn : forward_turns) {
    const TurnRoom room = room_of(turn);
    EXPECT_EQ(room.from.diagonal(), begins_diagonal(turn));
    EXPECT_EQ(room.to.diagonal(), ends_diagonal(turn));
    EXPECT_EQ((eighths(room.from) + 8 - eighths(turn)) % 8, eighths(room.to)) << name_of(turn);
    // A node lies on open walls only.
    for (const DriveNode& node : {room.from, room.to}) {
      if (!node.diagonal()) continue;
      for (const Wall wall :
           {wall_at(node.cell, node.heading), wall_at(neighbour(node.cell, node.heading), node.second())})
        EXPECT_NE(std::find(room.open.begin(), room.open.end(), wall), room.open.end()) << name_of(turn);
    }
  }
}

TEST(TurnShape, EndsOnItsNode) {
  for (const TurnOfRobot& it : all_turns_of_all_robots()) {
    const TurnRoom room = room_of(it.turn.turn);
    const bool left = !back(it.turn.turn);
    const DriveNode from = left ? room.from : reversed(room.to);
    const HalfPoint to = half_point(left ? room.to : room.from);
    const PathPoint last = it.shape.at(it.shape.whole());
    const MazePoint end = maze_point(from, left, last, it.robot.cell);
    EXPECT_NEAR(end.x, to.x / 2.0, 1e-9) << words(it);
    EXPECT_NEAR(end.y, to.y / 2.0, 1e-9) << words(it);
    EXPECT_NEAR(last.angle, eighths(it.turn.turn) * pi / 4.0, 1e-12) << words(it);
    EXPECT_GE(it.shape.lead_in, 0.0) << words(it);
    EXPECT_GE(it.shape.lead_out, 0.0) << words(it);
  }
}

TEST(TurnShape, IsOneSmoothPathOfTheLengthItNames) {
  for (const TurnOfRobot& it : all_turns_of_all_robots()) {
    const int steps = 4000;
    const double step = it.shape.whole() / steps;
    for (int i = 0; i < steps; ++i) {
      const PathPoint a = it.shape.at(step * i);
      const PathPoint b = it.shape.at(step * (i + 1));
      ASSERT_NEAR(std::hypot(b.ahead - a.ahead, b.aside - a.aside), step, step * 1e-4) << words(it) << " at " << i;
      const double middle = (a.angle + b.angle) / 2.0;
      ASSERT_NEAR(b.ahead - a.ahead, step * std::cos(middle), step * 1e-4) << words(it) << " at " << i;
      ASSERT_NEAR(b.aside - a.aside, step * std::sin(middle), step * 1e-4) << words(it) << " at " << i;
      ASSERT_LE(b.angle - a.angle, it.shape.ramp.peak * step * (1.0 + 1e-6)) << words(it) << " at " << i;
    }
    const double middle = it.shape.lead_in + it.shape.length / 2.0;
    EXPECT_NEAR(it.shape.at(middle - 1e-12).ahead, it.shape.at(middle + 1e-12).ahead, it.robot.cell * 1e-9);
    EXPECT_NEAR(it.shape.at(middle - 1e-12).aside, it.shape.at(middle + 1e-12).aside, it.robot.cell * 1e-9);
  }
}

TEST(TurnShape, TurnsNoHarderThanTheRobotMay) {
  for (const TurnOfRobot& it : all_turns_of_all_robots()) {
    if (it.robot.fixed) continue;
    const double yaw_rate = it.shape.ramp.peak * it.turn.speed;
    EXPECT_LE(yaw_rate * it.turn.speed, it.robot.lateral_acceleration * (1.0 + 1e-12)) << words(it);
    if (it.robot.profile != TurnProfile::trapezoid) continue;  // see RisesAndFallsWithinTheLimitsAtEachMoment
    const double onset = it.shape.ramp.onset / it.turn.speed, rise = it.shape.ramp.length / it.turn.speed;
    const double yaw_acceleration = yaw_rate / (rise - onset);
    EXPECT_LE(yaw_acceleration, it.robot.yaw_acceleration * (1.0 + 1e-12)) << words(it);
    if (it.robot.yaw_speed > 0.0) {
      EXPECT_LE(yaw_rate, it.robot.yaw_speed * (1.0 + 1e-12)) << words(it);
    }
    if (it.robot.yaw_jerk > 0.0) {
      EXPECT_LE(yaw_acceleration / onset, it.robot.yaw_jerk * (1.0 + 1e-12)) << words(it);
    }
    EXPECT_NEAR(it.turn.time, it.shape.length / it.turn.speed * 1e6, 0.51) << words(it);
  }
}

/// The largest differences of the angle along a path, step by step, are what the limits say: of first order those of
/// the yaw speed, of second of the yaw acceleration, of third of the yaw jerk.
TEST(TurnShape, RisesAndFallsWithinTheLimitsAtEachMoment) {
  for (const Robot& robot :
       {jerk_robot(), large_jerk_robot(), with_profile(large_jerk_robot(), TurnProfile::sine),
        with_profile(large_jerk_robot(), TurnProfile::cubic), with_profile(smooth_robot(), TurnProfile::sine)}) {
    const DriveModel model = make_drive_model(robot);
    for (std::size_t i = 0; i < model.shapes.size(); ++i) {
      const DrivenTurn& turn = model.tables.turns[i];
      const TurnShape& shape = model.shapes[i];
      constexpr double tick = 1e-4;  // seconds
      std::array<double, 4> angles{};
      double fastest = 0.0, hardest = 0.0, sharpest = 0.0;
      for (double time = 0.0; time < shape.whole() / turn.speed; time += tick) {
        std::rotate(angles.rbegin(), angles.rbegin() + 1, angles.rend());
        angles[0] = shape.at(time * turn.speed).angle;
        fastest = std::max(fastest, (angles[0] - angles[1]) / tick);
        hardest = std::max(hardest, std::abs(angles[0] - 2.0 * angles[1] + angles[2]) / (tick * tick));
        sharpest = std::max(sharpest,
                            std::abs(angles[0] - 3.0 * angles[1] + 3.0 * angles[2] - angles[3]) / (tick * tick * tick));
      }
      EXPECT_LE(fastest, (robot.yaw_speed > 0.0 ? robot.yaw_speed : 1e9) * 1.001)
          << robot.name << " " << name_of(turn.turn);
      EXPECT_LE(hardest, robot.yaw_acceleration * 1.001) << robot.name << " " << name_of(turn.turn);
      EXPECT_LE(sharpest, robot.yaw_jerk * 1.01) << robot.name << " " << name_of(turn.turn);
      if (i > 0 && model.tables.turns[i - 1].turn == turn.turn) continue;  // the slower one
      // The yaw acceleration of a sine or a cubic is limited by either.
      EXPECT_TRUE(sharpest > 0.9 * robot.yaw_jerk ||
                  (robot.profile != TurnProfile::trapezoid && hardest > 0.999 * robot.yaw_acceleration))
          << robot.name << " " << name_of(turn.turn);
      EXPECT_TRUE(robot.profile != TurnProfile::trapezoid || fastest > 0.99 * robot.yaw_speed ||
                  hardest > 0.99 * robot.yaw_acceleration || fastest * turn.speed > 0.99 * robot.lateral_acceleration)
          << robot.name << " " << name_of(turn.turn);
    }
  }
}

/// Ramps to 1/100 rad/mm over 90 mm, against closed forms of their curvature and its slope; the angle by Simpson's
/// rule, and the place by small steps.
TEST(TurnProfile, IsAStraightLineACosineWaveOrACubic) {
  constexpr double length = 90.0, peak = 0.01;
  const auto curvature = [](TurnProfile profile, double u) {
    if (profile == TurnProfile::sine) return peak * (1.0 - std::cos(std::acos(-1.0) * u)) / 2.0;
    return profile == TurnProfile::cubic ? peak * (3.0 * u * u - 2.0 * u * u * u) : peak * u;
  };
  for (const TurnProfile profile : {TurnProfile::trapezoid, TurnProfile::sine, TurnProfile::cubic}) {
    SCOPED_TRACE(name_of(profile));
    const RampPath ramp{length, profile == TurnProfile::trapezoid ? 0.0 : length / 2.0, peak, profile};
    constexpr int steps = 9000;
    constexpr double step = length / steps, tiny = 1e-4;
    PathPoint point;
    for (int i = 0; i < steps; ++i) {
      const double u = static_cast<double>(i) / steps, half = 0.5 / steps;
      const double first = curvature(profile, u), middle = curvature(profile, u + half),
                   last = curvature(profile, u + 2.0 * half);
      const double angle = point.angle + step / 24.0 * (5.0 * first + 8.0 * middle - last);
      point.ahead += step * std::cos(angle);
      point.aside += step * std::sin(angle);
      point.angle += step / 6.0 * (first + 4.0 * middle + last);
      if (i % 900 != 899) continue;
      const double way = step * (i + 1);
      EXPECT_NEAR(ramp.at(way).ahead, point.ahead, 1e-6) << way;
      EXPECT_NEAR(ramp.at(way).aside, point.aside, 1e-6) << way;
      EXPECT_NEAR(ramp.at(way).angle, point.angle, 1e-12) << way;
      EXPECT_NEAR(ramp.curvature_at(way), last, 1e-15) << way;
      const double before = curvature(profile, (way - 2.0 * tiny) / length);
      EXPECT_NEAR(ramp.growth_at(way - tiny), (last - before) / (2.0 * tiny), 1e-9) << way;
    }
    EXPECT_NEAR(ramp.at(length).angle, peak * length / 2.0, 1e-15);
  }
}

/// A rise to 8 rad/s at 100 rad/s²: with a sine it lasts pi/2 times as long as with a steady yaw acceleration, and with
/// a cubic 3/2 times; with a yaw jerk of 1000 rad/s³ longer still.
TEST(TurnProfile, LastsAsLongAsItsHighestYawAccelerationAndJerkAsk) {
  CurveLimits limits{1e6, 100.0, 0.0, 0.0};
  const auto seconds = [&](TurnProfile profile) {
    limits.profile = profile;
    return ramp_to(8.0, limits).seconds;
  };
  EXPECT_DOUBLE_EQ(seconds(TurnProfile::trapezoid), 0.08);
  EXPECT_DOUBLE_EQ(seconds(TurnProfile::sine), 0.04 * pi);
  EXPECT_DOUBLE_EQ(seconds(TurnProfile::cubic), 0.12);
  limits.yaw_jerk = 1000.0;
  EXPECT_DOUBLE_EQ(seconds(TurnProfile::trapezoid), 2.0 * std::sqrt(0.008));
  EXPECT_DOUBLE_EQ(seconds(TurnProfile::sine), pi * std::sqrt(0.004));
  EXPECT_DOUBLE_EQ(seconds(TurnProfile::cubic), std::sqrt(0.048));
  for (const TurnProfile profile : {TurnProfile::trapezoid, TurnProfile::sine, TurnProfile::cubic})
    for (const double jerk : {0.0, 1000.0, 1e5}) {
      limits = {1e6, 100.0, 0.0, jerk, profile};
      const YawRamp half = ramp_of_half(pi / 2.0, limits);
      EXPECT_NEAR(half.rate * half.seconds, pi / 2.0, 1e-12) << name_of(profile) << " " << jerk;
      EXPECT_NEAR(ramp_to(half.rate, limits).seconds, half.seconds, 1e-12) << name_of(profile) << " " << jerk;
    }
}

/// A table of turns of a half-size robot as published (kerise-v4, 2021): each at the speed for which its path was
/// computed, with its straights.
TEST(TurnShape, TakesThePublishedTimes) {
  const CurveLimits limits = {1e6, 113.097, 9.42478, 3769.91};
  struct Published {
    Turn turn;
    double cell, speed, before, after, milliseconds;
  };
  for (const Published& published : {Published{Turn::s90, 90, 265.749, 1.0, 1.0, 287.526},
                                     {Turn::f45, 90, 411.636, 2.574, 21.213, 257.131},
                                     {Turn::f90, 90, 422.783, 20.0, 20.0, 374.611},
                                     {Turn::f135, 90, 353.609, 21.863, 14.142, 465.154},
                                     {Turn::f180, 90, 412.228, 24.0, 24.0, 563.107},
                                     {Turn::v90, 90, 289.908, 15.640, 15.640, 387.894},
                                     // K90, which nobody drives here: as V90 in cells of twice the size.
                                     {Turn::v90, 180, 754.969, 2.279, 2.279, 286.038}}) {
    TurnShape shape = shape_at(published.turn, published.speed, limits, published.cell);
    if (published.turn == Turn::f180) {
      EXPECT_NEAR(width_of(shape), published.cell, 0.001);
      shape.lead_in = shape.lead_out = published.before;
    }
    EXPECT_NEAR(shape.lead_in, published.before, 0.001) << name_of(published.turn);
    EXPECT_NEAR(shape.lead_out, published.after, 0.001) << name_of(published.turn);
    EXPECT_NEAR(shape.whole() / published.speed * 1e3, published.milliseconds, 0.002) << name_of(published.turn);
  }
}

TEST(TurnShape, IsTheSamePathForwardsAndBack) {
  for (const Robot& robot : {published_robot(), large_robot(), jerk_robot()}) {
    const DriveModel model = make_drive_model(robot);
    const auto shape_of = [&](Turn turn) {
      return *std::find_if(model.shapes.begin(), model.shapes.end(), [=](const auto& it) { return it.turn == turn; });
    };
    for (const Turn turn : {Turn::f45, Turn::f135}) {
      const TurnShape in = shape_of(turn);
      const TurnShape out = shape_of(reversed(turn));
      const TurnRoom room = room_of(turn);
      for (double share = 0.0; share <= 1.0; share += 0.125) {
        const MazePoint a = maze_point(room.from, true, in.at(in.whole() * share), robot.cell);
        const MazePoint b = maze_point(reversed(room.to), false, out.at(out.whole() * (1.0 - share)), robot.cell);
        EXPECT_NEAR(a.x, b.x, 1e-9) << name_of(turn);
        EXPECT_NEAR(a.y, b.y, 1e-9) << name_of(turn);
      }
    }
  }
}

}  // namespace
}  // namespace labmouse
