// A controller drives moves and routes as they are meant: where they end, how long they take, and what it says of
// walls.
#include "labmouse/controller/controller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/controller/driven.hpp"
#include "tests/controller/robots.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/strategies/allocations.hpp"

namespace labmouse {
namespace {

using test::Driven;
using test::ring;

constexpr Action on = Action::step(0, 1), left = Action::step(-90, 1), right = Action::step(90, 1),
                 back = Action::step(180, 1), stop = Action::step(0, 0);

const std::vector<const DriveModel*> all_models() { return {&test::kerise(), &test::classic(), &test::beginner()}; }

/// Where a mouse is by the edge or the rest that a place names.
Position position_of(const SearchPlace& place, double cell) {
  const Position middle = {(place.pose.cell.x + 0.5) * cell, (place.pose.cell.y + 0.5) * cell};
  if (place.at_rest) return middle;
  const Position way = way_in(place.pose.heading);
  return {middle.x - cell / 2.0 * way.x, middle.y - cell / 2.0 * way.y};
}

/// The true mouse is at its place, to within so many cells, and points where it should.
void expect_at_place(Driven& driven, double cell, double within) {
  const SearchPlace& place = driven.controller().place();
  const Position should = position_of(place, cell), is = driven.body().motion().position;
  EXPECT_NEAR(is.x, should.x, within * cell);
  EXPECT_NEAR(is.y, should.y, within * cell);
  const Position way = way_in(place.pose.heading);
  const Direction& ahead = driven.body().motion().ahead;
  EXPECT_GT(ahead.cosine * way.x + ahead.sine * way.y, 0.998);
}

TEST(Controller, EndsEachMoveWhereTheNextOneBegins) {
  for (const DriveModel* model : all_models()) {
    SCOPED_TRACE(model->robot.name);
    Driven driven(ring(), *model);
    ASSERT_TRUE(driven.drive_on());
    SearchPlace place = driven.controller().place();
    for (const Action& step : {on, on, right, on, right, on, right, stop, back, left, on, left, on, left, on, stop,
                               Action::step(180, 0), on}) {
      place = after_search(place, step);
      ASSERT_TRUE(driven.search(step));
      EXPECT_EQ(driven.controller().place(), place);
      expect_at_place(driven, model->tables.cell, 0.02);
    }
  }
}

TEST(Controller, TurnsOnTheSpotBothWays) {
  Driven driven(ring(), test::kerise());
  ASSERT_TRUE(driven.drive_on());
  for (const int quarters : {90, -90, -90, 180, 90, 90}) {
    ASSERT_TRUE(driven.search(Action::step(quarters, 0)));
    expect_at_place(driven, 90.0, 0.02);
    EXPECT_NEAR(driven.body().motion().speed, 0.0, 3.0);
  }
}

TEST(Controller, TakesTheTimeThatItsSpeedSays) {
  ControllerChoice choice;
  choice.search_speed = 330.0;
  Driven driven(ring(), test::kerise(), no_errors, 1, choice);
  ASSERT_TRUE(driven.drive_on());
  ASSERT_TRUE(driven.search(on));
  for (const Action& step : {on, right, on}) {
    const int before = driven.ticks();
    ASSERT_TRUE(driven.search(step));
    const double length = step.rotation == 0 ? 90.0 : search_manner(test::kerise(), 330.0).turn.whole();
    EXPECT_NEAR(driven.ticks() - before, length / 330.0 * 1000.0, 1.01);
  }
}

TEST(Controller, DashesOverCellsThatItKnows) {
  const Maze maze = test::drawn(R"(
    o---o
    | G |
    o   o
    |   |
    o   o
    |   |
    o   o
    |   |
    o   o
    | S |
    o---o
  )");
  DriveModel model = test::kerise();
  model.robot.known_speed = 900.0;
  model.robot.known_acceleration = 3000.0;
  Driven slow(maze, test::kerise()), fast(maze, model);
  for (Driven* driven : {&slow, &fast}) {
    ASSERT_TRUE(driven->drive_on());
    ASSERT_TRUE(driven->search(on));
    ASSERT_TRUE(driven->search(Action::step(0, 3)));
    expect_at_place(*driven, 90.0, 0.02);
  }
  EXPECT_LT(fast.ticks(), slow.ticks() - 200);
}

TEST(Controller, LooksAboutBeforeItDrives) {
  Driven driven(ring(), test::kerise());
  ASSERT_TRUE(driven.drive_on());
  const WallEvidence evidence = driven.controller().evidence();
  EXPECT_GT(evidence.left, 4 * evidence_a_nat);
  EXPECT_GT(evidence.right, 4 * evidence_a_nat);
  EXPECT_LT(evidence.ahead, -4 * evidence_a_nat);
}

/// With a period of 3 ms the duties change in each third tick alone, and no ToF reading is lost.
TEST(Controller, HoldsItsDutiesForItsPeriod) {
  DriveModel slow = test::kerise();
  slow.robot.hardware->motors.period = 3.0;
  const Hardware& hardware = *slow.robot.hardware;
  Controller controller(slow, hardware, ring().size(), gains_for(hardware, slow.tables.cell));
  test::BodyInAMaze body(ring(), slow.tables.cell, hardware);
  body.put({0, 0}, Heading::north);
  controller.put({{0, 0}, Heading::north});
  Drive last;
  int changed = 0;
  for (int i = 0; i < 300; ++i) {
    const Drive duties = controller.tick(body.sense());
    if (body.sense().tick % 3 != 0) {
      EXPECT_EQ(duties, last) << body.sense().tick;
    }
    changed += duties == last ? 0 : 1;
    body.step(last = duties);
  }
  EXPECT_GT(changed, 50);
}

/// A wall detector that counts new ToF readings.
class RangeCounter final : public ReaderPart {
 public:
  void begin(const Pose&) override {}
  void read(const Sense& sense, const PoseEstimate&) override { news += sense.ranges[0].is_new ? 1 : 0; }
  WallEvidence evidence(const PoseEstimate&) const override { return {}; }

  int news = 0;
};

TEST(Controller, MissesNoToFReadingBetweenItsPeriods) {
  DriveModel slow = test::kerise();
  slow.robot.hardware->motors.period = 3.0;
  const Hardware& hardware = *slow.robot.hardware;
  RangeCounter reader;
  ControllerParts parts;
  parts.reader = &reader;
  Controller controller(slow, hardware, ring().size(), gains_for(hardware, slow.tables.cell), {}, parts);
  test::BodyInAMaze body(ring(), slow.tables.cell, hardware);
  body.put({0, 0}, Heading::north);
  controller.put({{0, 0}, Heading::north});
  int read = 0;
  for (int i = 0; i < 330; ++i) {
    read += body.sense().ranges[0].is_new ? 1 : 0;
    body.step(controller.tick(body.sense()));
  }
  EXPECT_GT(read, 25);
  EXPECT_NEAR(reader.news, read, 1);
}

TEST(Controller, ReadsTheWallsAboutEachCell) {
  for (const DriveModel* model : all_models()) {
    SCOPED_TRACE(model->robot.name);
    Driven driven(ring(), *model);
    ASSERT_TRUE(driven.drive_on());
    for (const Action& step : {on, on, right, on, right, on, right}) {
      ASSERT_TRUE(driven.search(step));
      const Pose pose = driven.controller().place().pose;
      const WallEvidence evidence = driven.controller().evidence();
      const auto expect = [&](Evidence read, Heading side) {
        const bool stands = !driven.maze().is_open(pose.cell, side);
        // An infrared sensor alone is less sure of a wall that is a cell away.
        const bool sure = side != pose.heading || !model->robot.hardware->sensors.rangers.empty();
        EXPECT_GT(stands ? read : -read, (sure ? 4 : 1) * evidence_a_nat)
            << name_of(side) << " of " << int(pose.cell.x) << "," << int(pose.cell.y);
      };
      expect(evidence.left, left_of(pose.heading));
      expect(evidence.ahead, pose.heading);
      expect(evidence.right, right_of(pose.heading));
    }
  }
}

/// The route to the goal of a maze of which all is known.
DriveRoute fastest(const Maze& maze, const DriveModel& model) {
  FastestRoutes routes(maze.size(), route_tables_of(model));
  const Pose start = {maze.start(), maze.start_heading()};
  routes.fill_for(start, maze.open_walls(), maze.goals());
  DriveRoute route;
  routes.route_from(start, route);
  return route;
}

TEST(Controller, DrivesARouteInItsTimeToItsEnd) {
  for (const DriveModel* model : all_models()) {
    SCOPED_TRACE(model->robot.name);
    Driven driven(ring(), *model);
    ASSERT_TRUE(driven.drive_on());
    const DriveRoute route = fastest(ring(), *model);
    ASSERT_FALSE(route.segments.empty());
    driven.controller().run(route);
    int first = 0, last = 0;
    ASSERT_TRUE(driven.drive_on([&] {
      if (first == 0 && driven.controller().running()) first = driven.ticks();
      const Cell cell = driven.body().field().cell_at(driven.body().motion().position);
      if (last == 0 && ring().is_goal(cell)) last = driven.ticks();
    }));
    ASSERT_GT(last, first);
    // The route's clock stops in the goal cell's middle or at its edge: half a cell of a stopping mouse between them.
    EXPECT_NEAR(last - first, static_cast<double>(route.time) / 1000.0,
                0.15 * static_cast<double>(route.time) / 1000.0);
    EXPECT_NEAR(driven.body().motion().speed, 0.0, 10.0);
    EXPECT_EQ(driven.controller().place().pose.cell, ring().goals().contains({2, 1}) ? Cell(2, 1) : Cell());
    EXPECT_TRUE(driven.controller().place().at_rest);
  }
}

TEST(Controller, TakesNothingFromTheHeapOnceItIsMade) {
  Driven driven(ring(), test::kerise(), {});
  const DriveRoute route = fastest(ring(), test::kerise());
  const Knowledge known(ring().size());
  driven.controller().know(&known);
  const long before = test::allocations();
  EXPECT_TRUE(driven.drive_on());
  for (const Action& step : {on, on, right, on, right, stop, back, left, on}) EXPECT_TRUE(driven.search(step));
  static_cast<void>(driven.controller().evidence());
  driven.put({ring().start(), ring().start_heading()});
  EXPECT_TRUE(driven.drive_on());
  driven.controller().run(route);
  driven.drive_on();
  EXPECT_EQ(test::allocations(), before);
}

/// How bytes are counted is the compiler's; the order is that of a small chip's memory.
TEST(Controller, FitsTheMemoryOfAChip) { EXPECT_LT(sizeof(Controller), 12'000U); }

TEST(Controller, BeginsAnewWhereItIsPut) {
  Driven driven(ring(), test::kerise());
  ASSERT_TRUE(driven.drive_on());
  ASSERT_TRUE(driven.search(on));
  ASSERT_TRUE(driven.search(on));
  driven.put({ring().start(), ring().start_heading()});
  ASSERT_TRUE(driven.drive_on());
  EXPECT_EQ(driven.controller().place(), (SearchPlace{{ring().start(), ring().start_heading()}, true}));
  for (const Action& step : {on, on, right}) ASSERT_TRUE(driven.search(step));
  expect_at_place(driven, 90.0, 0.02);
}

}  // namespace
}  // namespace labmouse
