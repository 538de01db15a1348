// The curves of turns: that they are smooth and lead from node to node.
#include "labmouse/mouse/robot/turn_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/mouse/robot/angles.hpp"
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
  for (const Robot& robot : {published_robot(), small_robot(), large_robot(), fan_robot()}) {
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

TEST(Angles, AreThoseOfTheStandardLibraryButForTheLastBits) {
  for (double angle = -20.0; angle < 20.0; angle += 0.001) {
    const Direction direction = direction_of(angle);
    ASSERT_NEAR(direction.sine, std::sin(angle), 4e-16) << angle;
    ASSERT_NEAR(direction.cosine, std::cos(angle), 4e-16) << angle;
  }
  static_assert(direction_of(0.0).sine == 0.0 && direction_of(0.0).cosine == 1.0);
}

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
      ASSERT_LE(b.angle - a.angle, it.shape.peak * step * (1.0 + 1e-6)) << words(it) << " at " << i;
    }
    const double middle = it.shape.lead_in + it.shape.length / 2.0;
    EXPECT_NEAR(it.shape.at(middle - 1e-12).ahead, it.shape.at(middle + 1e-12).ahead, it.robot.cell * 1e-9);
    EXPECT_NEAR(it.shape.at(middle - 1e-12).aside, it.shape.at(middle + 1e-12).aside, it.robot.cell * 1e-9);
  }
}

TEST(TurnShape, TurnsNoHarderThanTheRobotMay) {
  for (const TurnOfRobot& it : all_turns_of_all_robots()) {
    if (it.robot.fixed) continue;
    const double yaw_rate = it.shape.peak * it.turn.speed;
    EXPECT_LE(yaw_rate * it.turn.speed, it.robot.lateral_acceleration * (1.0 + 1e-12)) << words(it);
    EXPECT_LE(yaw_rate / (it.shape.ramp / it.turn.speed), it.robot.yaw_acceleration * (1.0 + 1e-12)) << words(it);
    EXPECT_NEAR(it.turn.time, it.shape.length / it.turn.speed * 1e6, 0.51) << words(it);
  }
}

TEST(TurnShape, IsTheSamePathForwardsAndBack) {
  for (const Robot& robot : {published_robot(), large_robot()}) {
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
