// What a mouse sees of walls brings it back to where it is, when it takes itself to be elsewhere.
#include "labmouse/controller/corrections.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/controller/driven.hpp"
#include "tests/controller/robots.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

/// How far off an estimate is: along the way north, aside of it, in parts of a cell, and in rad.
struct Off {
  double along = 0.0, aside = 0.0, angle = 0.0;
};

/// Drives north at a steady speed from the middle of the start, really there, while the estimate begins so far off.
Off after(const Maze& maze, const DriveModel& model, int cells, const Off& first, const CorrectionChoice& choice = {},
          const Knowledge* known = nullptr) {
  const Hardware& hardware = *model.robot.hardware;
  const double cell = model.tables.cell, speed = 3.0 * cell;
  test::BodyInAMaze body(maze, cell, hardware, no_errors);
  const Position start = {(maze.start().x + 0.5) * cell, (maze.start().y + 0.5) * cell};
  body.put(start, pi / 2.0);
  Estimator estimator(hardware, cell, 0.2);
  estimator.put({start.x + first.aside * cell, start.y + first.along * cell},
                turned_by(Direction{1.0, 0.0}, first.angle));
  Corrections corrections(hardware, cell, maze.size(), choice);
  Target target;
  target.ahead = {1.0, 0.0};
  while (body.motion().position.y < start.y + cells * cell) {
    const double duty = speed / hardware.motors.drive.gain + hardware.motors.drive.dead_zone +
                        0.01 * (speed - body.motion().speed) / cell;
    EXPECT_NE(body.step({static_cast<float>(duty), static_cast<float>(duty)}), Touch::crash);
    estimator.predict(body.sense());
    target.position = body.motion().position;
    target.speed = body.motion().speed;
    corrections.apply(body.sense(), target, known, estimator);
  }
  const Position off = estimator.position() - body.motion().position;
  return {off.y / cell, off.x / cell, -estimator.ahead().cosine};
}

const Maze& corridor() {
  static const Maze maze = test::drawn(R"(
    o---o---o
    |   |   |
    o   o   o
    |   |   |
    o   o   o
    |   |   |
    o   o   o
    |   |   |
    o   o   o
    | S | G |
    o---o---o
  )");
  return maze;
}

/// Walls end and begin on its right.
const Maze& gaps() {
  static const Maze maze = test::drawn(R"(
    o---o---o
    |       |
    o   o   o
    |       |
    o   o---o
    |   |   |
    o   o   o
    |       |
    o   o---o
    | S | G |
    o---o---o
  )");
  return maze;
}

std::vector<const DriveModel*> all_models() { return {&test::kerise(), &test::classic(), &test::beginner()}; }

TEST(Corrections, ByWallsBringAMouseBackAsideAndTurnItBack) {
  for (const DriveModel* model : all_models())
    for (const double side : {-1.0, 1.0}) {
      SCOPED_TRACE(model->robot.name);
      const Off off = after(corridor(), *model, 3, {0.0, side * 0.03, side * 0.03}, {true, false, false});
      EXPECT_NEAR(off.aside, 0.0, 0.008);
      EXPECT_NEAR(off.angle, 0.0, 0.008);
    }
}

/// Walls on its left alone.
const Maze& one_wall() {
  static const Maze maze = test::drawn(R"(
    o---o---o
    |       |
    o   o   o
    |       |
    o   o   o
    |       |
    o   o   o
    |       |
    o   o   o
    | S   G |
    o---o---o
  )");
  return maze;
}

TEST(Corrections, ByOneWallDoSo) {
  const Off off = after(one_wall(), test::kerise(), 2, {0.0, 0.03, 0.02}, {true, false, false});
  EXPECT_NEAR(off.aside, 0.0, 0.012);
  EXPECT_NEAR(off.angle, 0.0, 0.01);
}

TEST(Corrections, ByEdgesBringAMouseBackAlong) {
  for (const DriveModel* model : all_models())
    for (const double side : {-1.0, 1.0}) {
      SCOPED_TRACE(model->robot.name);
      // An edge by itself could as well say that the mouse looks elsewhere; the wall to its left says that it does not.
      const Off off = after(gaps(), *model, 4, {side * 0.03, 0.0, 0.0}, {true, true, false});
      EXPECT_NEAR(off.along, 0.0, 0.008);
    }
}

TEST(Corrections, ByAWallAheadBringAMouseBackAlong) {
  for (const DriveModel* model : all_models()) {
    if (model->robot.hardware->sensors.rangers.empty()) continue;
    SCOPED_TRACE(model->robot.name);
    const Off off = after(corridor(), *model, 4, {0.03, 0.0, 0.0}, {false, false, true});
    EXPECT_NEAR(off.along, 0.0, 0.012);
  }
}

TEST(Corrections, ByToFSensorsBringAMouseBackAside) {
  DriveModel model = test::kerise();
  Sensors& sensors = model.robot.hardware->sensors;
  sensors.infrared.clear();
  sensors.rangers = {{{12.0, 12.0, 1.5708}, 255.0, 11.0}, {{12.0, -12.0, -1.2}, 255.0, 11.0}};
  for (const double aside : {-0.05, 0.05}) {
    EXPECT_NEAR(after(corridor(), model, 4, {0.0, aside, 0.0}).aside, 0.0, 0.012) << aside;
    EXPECT_NEAR(after(corridor(), model, 4, {0.0, aside, 0.0}, {false, true, true}).aside, aside, 0.002) << aside;
  }
}

TEST(Corrections, AreNotMadeWhereTheyAreNotChosen) {
  const Off first = {0.02, 0.02, 0.01};
  const Off off = after(gaps(), test::kerise(), 4, first, {false, false, false});
  EXPECT_NEAR(off.along, first.along, 0.002);
  EXPECT_NEAR(off.angle, first.angle, 0.001);
  // A hundredth of a rad over four cells.
  EXPECT_NEAR(off.aside, first.aside - 4.0 * first.angle, 0.003);
}

TEST(Corrections, LeaveAMouseWhereItIsRight) {
  for (const DriveModel* model : all_models())
    for (const Maze* maze : {&corridor(), &gaps()}) {
      SCOPED_TRACE(model->robot.name);
      const Off off = after(*maze, *model, 4, {});
      EXPECT_NEAR(off.along, 0.0, 0.005);
      EXPECT_NEAR(off.aside, 0.0, 0.003);
      EXPECT_NEAR(off.angle, 0.0, 0.003);
    }
}

TEST(Corrections, DoNotTakeForAWallWhatIsKnownToBeNone) {
  // Told that nothing stands to its right, a mouse goes by the walls on its left alone.
  Knowledge known(corridor().size());
  for (int y = 0; y < 5; ++y) static_cast<void>(known.learn({{0, y}, Heading::north}, {0, y < 4 ? 1 : 0, 1}));
  const auto driven = [](const Knowledge* told) {
    return after(corridor(), test::kerise(), 3, {0.0, 0.03, 0.0}, {true, false, false}, told).aside;
  };
  EXPECT_NE(driven(&known), driven(nullptr));
}

TEST(Corridor, IsTheRowOrColumnAlongWhichAMouseDrives) {
  Target target;
  target.position = {135.0, 250.0};
  const auto towards = [&](double degrees) {
    target.ahead = direction_of(degrees * pi / 180.0);
    return corridor_of(target, 90.0);
  };
  ASSERT_TRUE(towards(90.0));
  EXPECT_EQ(towards(90.0)->axis, Heading::north);
  EXPECT_EQ(towards(90.0)->cell, Cell(1, 2));
  EXPECT_EQ(towards(3.0)->axis, Heading::east);
  EXPECT_EQ(towards(-95.0)->axis, Heading::south);
  EXPECT_EQ(towards(175.0)->axis, Heading::west);
  EXPECT_FALSE(towards(45.0));
  EXPECT_FALSE(towards(20.0));
}

}  // namespace
}  // namespace labmouse
