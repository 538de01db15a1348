#include "labmouse/contest/drive_gates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/robot/drive_profile.hpp"
#include "tests/contest/scripted.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using test::ring;

constexpr Action on = Action::step(0, 1), right = Action::step(90, 1), back = Action::step(180, 1);

/// Cells in 300 ms, small turns in 237, back in 3 s.
const DriveModel& published() {
  static const DriveModel model = make_drive_model(published_robot());
  return model;
}

DriveRules rules_with(MazeTime time_limit, bool gate_to_gate) {
  DriveRules rules;
  rules.time_limit = time_limit;
  rules.gate_to_gate = gate_to_gate;
  return rules;
}

TEST(DriveScore, CountsARunThatEndsJustInTime) {
  DriveRun run;
  run.kind = DriveRun::Kind::speed;
  run.begin = 1'000;
  run.gate_out = 3'000;
  run.gate_in = 9'000;
  run.centre = run.end = 10'000;
  DriveRecord record;
  record.runs = {run};
  EXPECT_EQ(score(record, rules_with(9'000, true)).value(), 6'000);
  EXPECT_FALSE(score(record, rules_with(8'999, true)).best);
  EXPECT_EQ(score(record, rules_with(10'000, false)).value(), 9'000);
  EXPECT_FALSE(score(record, rules_with(9'999, false)).best);
}

TEST(Drive, IsOutOfTimeWhereTheGateCameInTimeAndTheMiddleDidNot) {
  const auto held = [](const DriveRules& rules) {
    test::Scripted mouse({on, on, right, on, right, Action::reset()});
    return drive(ring(), rules, published(), mouse);
  };
  const DriveRecord late = held(rules_with(1'500'000, false));
  EXPECT_EQ(late.runs.front().gate_in, 1'374'000);
  EXPECT_EQ(late.runs.front().centre, 1'674'000);
  EXPECT_EQ(late.outcome, DriveOutcome::out_of_time);
  EXPECT_EQ(held(rules_with(1'500'000, true)).outcome, DriveOutcome::finished);
  EXPECT_EQ(held(rules_with(1'673'999, false)).outcome, DriveOutcome::out_of_time);
  EXPECT_EQ(held(rules_with(1'674'000, false)).outcome, DriveOutcome::finished);
}

TEST(DriveGates, OfASearchAreThoseThatItPassesFirst) {
  // Out of the start, into it and out again; into the goal, through it, back into it, out and into it once more.
  test::Scripted mouse({on, back, back, on, right, on, right, on, back, on, back, Action::reset()});
  const DriveRecord record = drive(ring(), rules_with(100'000'000, true), published(), mouse);
  const DriveRun& search = record.runs.front();
  ASSERT_EQ(search.moves.size(), 11U);
  EXPECT_EQ(search.moves[2].from, (Pose{{0, 0}, Heading::south}));
  EXPECT_EQ(search.moves[8].to, (Pose{{2, 1}, Heading::north}));
  EXPECT_EQ(search.moves[10].to, (Pose{{2, 1}, Heading::south}));
  EXPECT_EQ(search.gate_out, 300'000);
  EXPECT_EQ(search.gate_in, 300'000 + 2 * 3'000'000 + 300'000 + 237'000 + 300'000 + 237'000);
  EXPECT_EQ(search.centre, *search.gate_in + 150'000);
}

/// The time in a segment at which a mouse comes beyond a gate, between one at which it is not and one at which it is.
template <class Beyond>
MazeTime moment(const DriveProfile& profile, double before, double behind, Beyond beyond) {
  const auto beyond_at = [&](double time) { return beyond(profile.spot(profile.distance_at(time))); };
  EXPECT_FALSE(beyond_at(before));
  EXPECT_TRUE(beyond_at(behind));
  for (int halving = 0; halving < 60; ++halving)
    (beyond_at((before + behind) / 2) ? behind : before) = (before + behind) / 2;
  return static_cast<MazeTime>(std::llround(behind));
}

/// The first segment of a route at whose end a mouse is beyond a gate, and when in the run it comes there.
struct Passing {
  std::size_t segment = 0;
  MazeTime time = 0;
};

template <class Beyond>
Passing passing(const DriveModel& model, const DriveRoute& route, Beyond beyond) {
  for (std::size_t i = 0; i < route.segments.size(); ++i) {
    const DriveProfile profile(model, route, i);
    if (beyond(profile.spot(profile.length())))
      return {i, route.segments[i].begin + moment(profile, 0.0, profile.duration(), beyond)};
  }
  ADD_FAILURE() << "no gate is passed";
  return {};
}

/// The fastest run in a maze that is known, by itself.
DriveRun fast_run(const Maze& maze, const DriveModel& model) {
  FastestRoutes routes(maze.size(), model.tables);
  routes.fill(maze.open_walls(), maze.goals());
  DriveRun run;
  run.kind = DriveRun::Kind::speed;
  run.begin = 7'000'000;
  routes.route_from({maze.start(), maze.start_heading()}, run.route);
  set_gates(run, maze, model);
  return run;
}

/// The first moment at which beyond(spot) holds, by looking everywhere.
template <class Beyond>
MazeTime looked_for(const DriveModel& model, const DriveRoute& route, Beyond beyond) {
  constexpr double step = 0.2;  // mm
  for (std::size_t i = 0; i < route.segments.size(); ++i) {
    const DriveProfile profile(model, route, i);
    for (double driven = step; driven < profile.length() + step; driven += step)
      if (const double at = std::min(driven, profile.length()); beyond(profile.spot(at)))
        return route.segments[i].begin + static_cast<MazeTime>(profile.time_at(at));
  }
  return route.time;
}

TEST(DriveGates, AreWhereLookingEverywhereFindsThem) {
  Rng rng(31);
  for (const Robot& robot : {published_robot(), large_robot()}) {
    const DriveModel model = make_drive_model(robot);
    const double side = robot.cell;
    for (int i = 0; i < test::tenth(40); ++i) {
      const Maze maze = test::any_maze(rng, 8);
      const DriveRun run = fast_run(maze, model);
      if (run.route.segments.empty()) continue;
      const auto cell_of = [&](const DriveSpot& spot) {
        return Cell{static_cast<int>(std::floor(spot.x / side)), static_cast<int>(std::floor(spot.y / side))};
      };
      const MazeTime out =
          looked_for(model, run.route, [&](const DriveSpot& spot) { return cell_of(spot) != maze.start(); });
      const MazeTime in =
          looked_for(model, run.route, [&](const DriveSpot& spot) { return maze.is_goal(cell_of(spot)); });
      // A step lasts a few milliseconds where the mouse starts.
      EXPECT_NEAR(static_cast<double>(*run.gate_out - run.begin), static_cast<double>(out), 10'000);
      EXPECT_NEAR(static_cast<double>(*run.gate_in - run.begin), static_cast<double>(in), 10'000);
    }
  }
}

TEST(DriveGates, InsideACurveAreKnownToTheMicrosecond) {
  for (const Robot& robot : {published_robot(), large_robot()}) {
    SCOPED_TRACE(robot.name);
    const DriveModel model = make_drive_model(robot);
    const double cell = robot.cell;
    // The last corner leads from the upper right cell into the goal.
    const DriveRun run = fast_run(ring(), model);
    const auto in_goal = [&](const DriveSpot& spot) { return spot.x > 2 * cell && spot.y > cell && spot.y < 2 * cell; };
    const Passing in = passing(model, run.route, in_goal);
    EXPECT_EQ(run.route.segments[in.segment].kind, DriveSegment::Kind::turn);
    EXPECT_EQ(*run.gate_in - run.begin, in.time);
    const Passing out = passing(model, run.route, [&](const DriveSpot& spot) { return spot.y > cell; });
    EXPECT_EQ(*run.gate_out - run.begin, out.time);
    EXPECT_EQ(*run.centre - run.begin, run.route.time);
  }
}

TEST(DriveGates, OfOneTurnLieInsideOfItAtBothEnds) {
  const Maze maze = test::drawn(R"(
    o---o---o
    |     G |
    o   o---o
    | S |   |
    o---o---o
  )");
  const DriveRun run = fast_run(maze, published());
  ASSERT_EQ(run.route.segments.size(), 1U);
  const Passing out = passing(published(), run.route, [](const DriveSpot& spot) { return spot.y > 90.0; });
  const Passing in = passing(published(), run.route, [](const DriveSpot& spot) { return spot.x > 90.0; });
  EXPECT_EQ(*run.gate_out - run.begin, out.time);
  EXPECT_EQ(*run.gate_in - run.begin, in.time);
}

DriveSegment half_turn(const DriveNode& from, const DriveNode& to, DriveTime begin) {
  const auto& turns = published().tables.turns;
  const auto found =
      std::find_if(turns.begin(), turns.end(), [](const DrivenTurn& turn) { return turn.turn == Turn::f180; });
  DriveSegment segment;
  segment.kind = DriveSegment::Kind::turn;
  segment.turn = static_cast<std::uint16_t>(found - turns.begin());
  segment.from = from;
  segment.to = to;
  segment.begin = begin;
  segment.end = begin + found->time;
  return segment;
}

TEST(DriveGates, OfARunAreThoseThatItPassesFirst) {
  const Maze maze = test::drawn(R"(
    o---o---o
    | G     |
    o   o   o
    |       |
    o   o   o
    | S   G |
    o   o   o
    |       |
    o---o---o
  )");
  // Up, and down into the goal beside the start; round into the start again, and straight on to the other goal.
  const DriveNode up = {{0, 1}, Heading::north, Place::centre}, down = {{1, 1}, Heading::south, Place::centre};
  const DriveSegment first = half_turn(up, down, 0), second = half_turn(down, up, first.end);
  DriveSegment straight;
  straight.from = up;
  straight.to = {{0, 3}, Heading::north, Place::centre};
  straight.units = 4;
  straight.begin = second.end;
  straight.end = straight.begin + published().tables.finish_from(4, 0, 0);
  DriveRun run;
  run.begin = 1'000;
  run.route.segments = {first, second, straight};
  run.route.time = straight.end;
  set_gates(run, maze, published());
  const DriveProfile turn(published(), run.route, 0);
  const auto above = [](const DriveSpot& spot) { return spot.y > 180.0; };
  const auto beside = [](const DriveSpot& spot) { return spot.x > 90.0 && spot.y < 180.0; };
  EXPECT_EQ(*run.gate_out - run.begin, moment(turn, 0.0, first.end / 2.0, above));
  EXPECT_EQ(*run.gate_in - run.begin, moment(turn, first.end / 2.0, first.end, beside));
  EXPECT_EQ(run.centre, run.begin + straight.end);
}

}  // namespace
}  // namespace labmouse
