// The manoeuvre of real logs: straight, half a turn, straight, at 600 mm/s on a floor without walls, driven with the
// gains of those logs and with ours. How far the mouse believes to be from where it should be is what the logs say,
// too.
//
// Source: 22 logs of 2021 of a half-size mouse (kerikun11/micromouse-kerise-v4, docs/explanation/physical-model.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "labmouse/controller/axis_control.hpp"
#include "labmouse/controller/estimator.hpp"
#include "labmouse/controller/piece.hpp"
#include "labmouse/controller/tracker.hpp"
#include "labmouse/functions/whole.hpp"
#include "tests/body/body_in_a_maze.hpp"
#include "tests/body/plain_mouse.hpp"
#include "tests/controller/robots.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

/// Root mean squares over a run, in mm, degrees and rad/s.
struct PositionErrors {
  double aside = 0.0, along = 0.0, heading = 0.0, yaw_on_straights = 0.0;
};

/// The gains of the mouse of the logs (its src/config/model.h).
Gains gains_of_the_logs() {
  Gains gains;
  gains.drive = {0.0004, 0.1};
  gains.turn = {0.03, 3.0};
  gains.drive_model = {5400.0, 0.18, 0.0};
  gains.turn_model = {100.0, 0.12, 0.0};
  gains.speed_filter = 0.2;
  gains.tracker = {6.0, 0.6, 90.0, 0.001, 0.5};
  return gains;
}

/// Straight up to its speed, a cell at it, half a turn to the left, and a cell.
std::vector<Piece> pieces(const Position& start) {
  constexpr double speed = 600.0, cell = 90.0;
  const DriveModel& model = test::kerise();
  const TurnShape& shape = *std::find_if(model.shapes.begin(), model.shapes.end(),
                                         [](const TurnShape& it) { return it.turn == Turn::f180; });
  const double rate = model.robot.acceleration, up = speed * speed / 2.0 / rate;
  const Direction north{1.0, 0.0}, south{-1.0, 0.0};
  const Position fast = {start.x, start.y + up}, turn = {start.x, fast.y + cell};
  return {Piece::rest(start, north, 0.05), Piece::straight(start, north, Ramps(up, 0.0, speed, {speed, rate, rate})),
          Piece::straight(fast, north, Ramps(cell, speed)),
          Piece::curve(turn, north, shape, true, Ramps(shape.whole(), speed)),
          Piece::straight({turn.x - cell, turn.y}, south, Ramps(cell, speed))};
}

/// Beginning with the first piece that moves. A mouse that knows of no slip takes all of a turn for one of its way.
PositionErrors drive(const Gains& gains, bool knows_slip, std::uint64_t seed) {
  const Hardware& hardware = *test::kerise().robot.hardware;
  Hardware book = hardware;
  if (!knows_slip) book.tyres.stiffness = 1e9;
  const Position start = {1500.0, 1500.0};
  // Cells of a metre: nothing is in the way.
  test::BodyInAMaze body(test::hall(4), 1000.0, hardware, {}, seed);
  Estimator estimator(book, 90.0, gains.speed_filter);
  Tracker tracker(gains.tracker);
  AxisControl control(gains, hardware.motors);
  body.put(start, pi / 2.0);
  estimator.put(start, {1.0, 0.0});
  PositionErrors squares;
  int ticks = 0, straight_ticks = 0;
  for (const Piece& piece : pieces(start)) {
    PieceWalk walk(piece);
    while (walk.left() > 0.0) {
      walk.step(tick_seconds);
      Sense sense = body.sense();
      if (!knows_slip)
        sense.acceleration[1] = static_cast<std::int16_t>(estimator.speed() * sense.gyro * hardware.sensors.gyro_step /
                                                          hardware.sensors.acceleration_step);
      estimator.predict(sense);
      const Target& target = walk.target();
      const PoseEstimate estimate = estimator.estimate();
      const Command command = tracker.follow(target, {estimate.position, estimate.way(), estimate.speed});
      EXPECT_NE(
          body.step(control.control(command, estimator.speed(), estimator.turning(), body.sense().millivolts / 1000.0)),
          Touch::crash);
      if (piece.kind == Piece::Kind::rest) continue;
      const Position off = estimator.position() - target.position;
      const Direction way = estimate.way();
      squares.aside += square(off.y * target.ahead.cosine - off.x * target.ahead.sine);
      squares.along += square(off.x * target.ahead.cosine + off.y * target.ahead.sine);
      squares.heading += square(std::asin(way.sine * target.ahead.cosine - way.cosine * target.ahead.sine));
      ++ticks;
      if (piece.kind != Piece::Kind::straight) continue;
      squares.yaw_on_straights += square(estimator.turning());
      ++straight_ticks;
    }
  }
  return {std::sqrt(squares.aside / ticks), std::sqrt(squares.along / ticks),
          std::sqrt(squares.heading / ticks) * 180.0 / pi, std::sqrt(squares.yaw_on_straights / straight_ticks)};
}

double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  return numbers[numbers.size() / 2];
}

PositionErrors medians(const Gains& gains, bool knows_slip) {
  std::vector<double> aside, along, heading, yaw;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::sanitized ? 20 : test::some_of(400)); ++seed) {
    const PositionErrors position_lost = drive(gains, knows_slip, seed);
    aside.push_back(position_lost.aside);
    along.push_back(position_lost.along);
    heading.push_back(position_lost.heading);
    yaw.push_back(position_lost.yaw_on_straights);
  }
  return {median(aside), median(along), median(heading), median(yaw)};
}

/// In the bands of the logs from 10 to 90 %, but for their upper ends, which are failures: 2.3 mm, 3.0 mm and 2.3
/// degrees are those of 48 logs of a later mouse that has none.
void expect_as_in_logs(const PositionErrors& position_lost) {
  EXPECT_GT(position_lost.aside, 0.33);
  EXPECT_LT(position_lost.aside, 2.3);
  EXPECT_GT(position_lost.along, 0.33);
  EXPECT_LT(position_lost.along, 3.0);
  EXPECT_GT(position_lost.heading, 0.6);
  EXPECT_LT(position_lost.heading, 2.3);
}

TEST(Manoeuvre, GoesAsInTheLogsWithTheirGains) {
  const PositionErrors position_lost = medians(gains_of_the_logs(), false);
  expect_as_in_logs(position_lost);
  EXPECT_GT(position_lost.yaw_on_straights, 0.21);
  EXPECT_LT(position_lost.yaw_on_straights, 0.71);
}

TEST(Manoeuvre, GoesAsInTheLogsWithOurGains) {
  expect_as_in_logs(medians(gains_for(*test::kerise().robot.hardware, 90.0), true));
}

}  // namespace
}  // namespace labmouse
