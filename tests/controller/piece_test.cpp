// Pieces of a way end where they should, and their targets move as they say.
#include "labmouse/controller/piece.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "labmouse/hardware/sense.hpp"
#include "tests/controller/robots.hpp"

namespace labmouse {
namespace {

constexpr Direction north{1.0, 0.0}, east{0.0, 1.0};

const TurnShape& shape_of(Turn turn, const DriveModel& model = test::kerise()) {
  return *std::find_if(model.shapes.begin(), model.shapes.end(), [&](const TurnShape& it) { return it.turn == turn; });
}

/// Walks a piece in ticks to its end, and checks that each target's speeds are those of the way from the one before.
Target walked(const Piece& piece) {
  PieceWalk walk(piece);
  while (walk.left() > 0.0) {
    const Target before = walk.target();
    const double step = std::min(tick_seconds, walk.left());
    walk.step(tick_seconds);
    const Target& after = walk.target();
    const Position way = after.position - before.position;
    EXPECT_NEAR(std::hypot(way.x, way.y) / step, std::abs(before.speed + after.speed) / 2.0, 6.0);
    const double turn = after.ahead.sine * before.ahead.cosine - after.ahead.cosine * before.ahead.sine;
    EXPECT_NEAR(turn / step, (before.turning + after.turning) / 2.0, 0.3);
  }
  return walk.target();
}

void expect_at(const Target& target, const Position& position, double angle) {
  EXPECT_NEAR(target.position.x, position.x, 1e-3);
  EXPECT_NEAR(target.position.y, position.y, 1e-3);
  EXPECT_NEAR(std::remainder(std::atan2(target.ahead.sine, target.ahead.cosine) - angle, 2.0 * pi), 0.0, 5e-6);
}

TEST(Piece, AStraightEndsAheadOfItsBeginning) {
  const Target end = walked(Piece::straight({45.0, 90.0}, north, Ramps(135.0, 0.0, 300.0, {600.0, 3000.0, 3000.0})));
  expect_at(end, {45.0, 225.0}, pi / 2.0);
  EXPECT_NEAR(end.speed, 300.0, 1e-9);
}

TEST(Piece, BackwardsEndsBehindItAndLooksAhead) {
  const Target end = walked(Piece::backwards({45.0, 90.0}, east, Ramps(24.0, 0.0, 0.0, {150.0, 1000.0, 1000.0})));
  expect_at(end, {21.0, 90.0}, 0.0);
}

TEST(Piece, ACurveEndsAtTheEndOfItsShape) {
  for (const Turn turn : {Turn::s90, Turn::f90, Turn::f180, Turn::v90, Turn::f45, Turn::f135})
    for (const bool left : {true, false}) {
      for (const DriveModel* model : {&test::kerise(), &test::free_classic()}) {
        const TurnShape& shape = shape_of(turn, *model);
        const Target end = walked(Piece::curve({900.0, 900.0}, east, shape, left, Ramps(shape.whole(), 300.0)));
        const double side = left ? 1.0 : -1.0;
        expect_at(end, {900.0 + shape.end.ahead, 900.0 + side * shape.end.aside}, side * shape.end.angle);
      }
    }
}

TEST(Piece, ASearchTurnLeadsFromEdgeToEdge) {
  const TurnShape& shape = shape_of(Turn::s90);
  const Target end = walked(Piece::curve({135.0, 90.0}, north, shape, false, Ramps(shape.whole(), 300.0)));
  // From the south edge of a cell to the east one.
  expect_at(end, {180.0, 135.0}, 0.0);
}

TEST(Piece, APivotTurnsOnTheSpot) {
  const Ramps ramps(pi / 2.0, 0.0, 0.0, {10.0, 100.0, 100.0});
  expect_at(walked(Piece::pivot({45.0, 45.0}, north, true, ramps)), {45.0, 45.0}, pi);
  expect_at(walked(Piece::pivot({45.0, 45.0}, north, false, ramps)), {45.0, 45.0}, 0.0);
}

TEST(Piece, ARestStays) {
  const Target end = walked(Piece::rest({45.0, 45.0}, north, 0.1));
  expect_at(end, {45.0, 45.0}, pi / 2.0);
  EXPECT_EQ(end.speed, 0.0);
}

TEST(PieceWalk, DoesNotDependOnHowItIsCutIntoSteps) {
  const TurnShape& shape = shape_of(Turn::f90);
  const Piece piece = Piece::curve({0.0, 0.0}, east, shape, true, Ramps(shape.whole(), 400.0));
  PieceWalk fine(piece), coarse(piece);
  while (fine.left() > 0.0) fine.step(0.0001);
  while (coarse.left() > 0.0) coarse.step(0.001);
  EXPECT_NEAR(fine.target().position.x, coarse.target().position.x, 0.01);
  EXPECT_NEAR(fine.target().position.y, coarse.target().position.y, 0.01);
}

}  // namespace
}  // namespace labmouse
