#include "labmouse/contest/lap_route.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_gates.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/robot/drive_profile.hpp"
#include "tests/contest/scripted.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/mouse/drive_robots.hpp"

namespace labmouse {
namespace {

Maze open_maze(Size size) { return Maze(MazeDraft(size, MazeDraft::Inside::open)); }

DriveRules lap_rules(MazeTime time_limit, int laps) {
  DriveRules rules;
  rules.counts = Counted::lap;
  rules.time_limit = time_limit;
  rules.most_runs = laps;
  return rules;
}

/// All robots for tests whose turns follow from their limits or are published, as models.
const std::vector<DriveModel>& models() {
  static const std::vector<DriveModel> all = {make_drive_model(published_robot()), make_drive_model(small_robot()),
                                              make_drive_model(large_robot()), make_drive_model(fan_robot())};
  return all;
}

/// A run of laps with its gates.
DriveRun laps_in(const Maze& maze, const DriveModel& model, int laps) {
  DriveRun run;
  run.kind = DriveRun::Kind::laps;
  run.route = lap_route(maze, model, laps);
  set_gates(run, maze, model);
  return run;
}

/// The time of each lap.
std::vector<MazeTime> lap_times(const DriveRun& run) {
  std::vector<MazeTime> times;
  MazeTime begin = run.gate_out.value();
  for (const MazeTime end : run.laps) {
    times.push_back(end - begin);
    begin = end;
  }
  return times;
}

/// The time of a lap with these turns at its four corners; no_time where it cannot be driven.
DriveTime time_with(const DriveTables& tables, Size size, const std::array<std::size_t, 4>& turns) {
  DriveTime time = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const DrivenTurn &before = tables.turns[turns[i]], &next = tables.turns[turns[(i + 1) % 4]];
    const auto reach = [](const DrivenTurn& turn) { return turn.turn == Turn::f90 ? 2 : 1; };
    const int units = 2 * ((i % 2 == 0 ? size.height : size.width) - 1) - reach(before) - reach(next);
    const DriveTime straight = units < 0 ? no_time : tables.along.at(units, before.to, next.from);
    if (straight >= no_time) return no_time;
    time += straight + next.time;
  }
  return time;
}

/// The fastest of all laps that can be repeated, tried one by one.
DriveTime fastest_of_all(const DriveTables& tables, Size size) {
  std::vector<std::size_t> turns;
  for (std::size_t i = 0; i < tables.turns.size(); ++i)
    if (tables.turns[i].turn == Turn::f90 || tables.turns[i].turn == Turn::s90) turns.push_back(i);
  DriveTime best = no_time;
  for (const std::size_t a : turns)
    for (const std::size_t b : turns)
      for (const std::size_t c : turns)
        for (const std::size_t d : turns) best = std::min(best, time_with(tables, size, {a, b, c, d}));
  return best;
}

TEST(LapRoute, HasTheFastestTurnsOfAll) {
  for (const DriveModel& model : models())
    for (const Size size : {Size{2, 2}, Size{3, 3}, Size{4, 7}, Size{9, 5}}) {
      SCOPED_TRACE(model.robot.name + " " + std::to_string(size.width));
      const DriveTime least = fastest_of_all(model.tables, size);
      ASSERT_LT(least, no_time);
      EXPECT_EQ(flying_lap(open_maze(size), model), least);
      const auto times = lap_times(laps_in(open_maze(size), model, 4));
      ASSERT_EQ(times.size(), 4U);
      EXPECT_EQ(times[1], least);
      EXPECT_EQ(times[2], least);
    }
}

TEST(LapRoute, TakesTheTimeOfItsStraightsAndTurns) {
  // Between two small turns at 420 mm/s the robot speeds up and brakes at 4200 mm/s² over 8 half cells of 45 mm. With
  // large turns of 375 ms the lap would be longer.
  const double straight = 2.0 * (std::sqrt(420.0 * 420.0 + 4200.0 * 360.0) - 420.0) / 4200.0;
  const double wide = 2.0 * (std::sqrt(420.0 * 420.0 + 4200.0 * 270.0) - 420.0) / 4200.0;
  const double lap = 4.0 * (straight + 0.280), wide_lap = 4.0 * (wide + 0.375);
  ASSERT_LT(lap, wide_lap);
  EXPECT_NEAR(flying_lap(open_maze({6, 6}), models()[0]) / 1e6, lap, 4e-6);
}

TEST(LapRoute, PassesTheGateWhenTheMiddleOfTheRobotLeavesTheStartCell) {
  const DriveModel& model = models()[2];
  const DriveRun run = laps_in(open_maze({5, 5}), model, 3);
  std::vector<MazeTime> gates = run.laps;
  gates.insert(gates.begin(), run.gate_out.value());
  ASSERT_EQ(gates.size(), 4U);
  for (const MazeTime gate : gates) {
    std::size_t i = 0;
    while (run.route.segments[i].end < gate) ++i;
    const DriveProfile profile(model, run.route, i);
    const DriveSpot spot = profile.spot(profile.distance_at(static_cast<double>(gate - run.route.segments[i].begin)));
    EXPECT_NEAR(spot.y, model.tables.cell, 0.01);
    EXPECT_GT(spot.x, 0.0);
    EXPECT_LT(spot.x, model.tables.cell);
  }
}

TEST(LapRoute, LeadsClockwiseThroughTheRingAndStopsBehindTheGate) {
  for (const DriveModel& model : models()) {
    const Maze maze = open_maze({6, 4});
    const DriveRoute route = lap_route(maze, model, 2);
    for (std::size_t i = 1; i < route.segments.size(); ++i) {
      EXPECT_EQ(route.segments[i].from, route.segments[i - 1].to);
      EXPECT_EQ(route.segments[i].begin, route.segments[i - 1].end);
      EXPECT_FALSE(route.segments[i].left);
    }
    EXPECT_EQ(walls_of(route), ring_of({6, 4}));
    EXPECT_EQ(route.segments.front().from, (DriveNode{{0, 0}, Heading::north, Place::centre}));
    EXPECT_EQ(route.segments.back().to, (DriveNode{{0, 1}, Heading::north, Place::centre}));
    EXPECT_LE(stopping_room(route, model.tables), 2);
  }
}

TEST(LapRoute, BeginsInAnyCornerThatHeadsClockwise) {
  const DriveModel& model = models()[1];
  const Maze maze = open_maze({7, 4});
  const DriveTime lap = flying_lap(maze, model);
  for (const Pose start : {Pose{{0, 3}, Heading::east}, Pose{{6, 3}, Heading::south}, Pose{{6, 0}, Heading::west}}) {
    const Maze turned = maze.with_start(start.cell, start.heading);
    EXPECT_EQ(flying_lap(turned, model), lap);
    EXPECT_EQ(lap_times(laps_in(turned, model, 3)).at(1), lap);
  }
  for (const Pose start : {Pose{{0, 3}, Heading::south}, Pose{{0, 0}, Heading::east}, Pose{{0, 1}, Heading::north},
                           Pose{{3, 2}, Heading::north}}) {
    const Maze turned = maze.with_start(start.cell, start.heading);
    EXPECT_FALSE(starts_on_ring(turned));
    EXPECT_EQ(lap_route(turned, model, 3).time, no_time);
  }
  EXPECT_FALSE(starts_on_ring(open_maze({1, 5})));
}

TEST(LapRoute, NeedsTheRingOpenAllRound) {
  EXPECT_EQ(closed_on_ring(open_maze({4, 4})), std::nullopt);
  MazeDraft draft({4, 4}, MazeDraft::Inside::open);
  draft.close({1, 1}, Heading::north);
  EXPECT_EQ(closed_on_ring(Maze(draft)), std::nullopt);
  draft.close({1, 0}, Heading::east);
  EXPECT_EQ(closed_on_ring(Maze(draft)), wall_at({1, 0}, Heading::east));
  EXPECT_EQ(lap_route(Maze(draft), models()[0], 1).time, no_time);
  // The first one clockwise.
  draft.close({3, 1}, Heading::north);
  EXPECT_EQ(closed_on_ring(Maze(draft)), wall_at({3, 1}, Heading::north));
}

TEST(LapContest, CountsTheFastestLapInTime) {
  const Maze maze = open_maze({6, 6});
  const DriveModel& model = models()[2];
  const auto held = [&](MazeTime time_limit, int laps) {
    test::Scripted mouse({});
    return drive(maze, lap_rules(time_limit, laps), model, mouse);
  };
  const DriveRecord record = held(180'000'000, 5);
  ASSERT_EQ(record.runs.size(), 1U);
  const DriveRun& run = record.runs.front();
  EXPECT_EQ(run.kind, DriveRun::Kind::laps);
  EXPECT_EQ(run.laps.size(), 5U);
  EXPECT_TRUE(ring_of(maze.size()) == run.open || run.open.contains(wall_at({3, 0}, Heading::east)));
  EXPECT_EQ(record.outcome, DriveOutcome::finished);
  const DriveScore scored = score(record, lap_rules(180'000'000, 5));
  const MazeTime first = run.laps[0] - *run.gate_out;
  EXPECT_EQ(scored.value(), std::min<MazeTime>(first, flying_lap(maze, model)));
  // As if the first lap were slow: it counts where the second comes too late.
  DriveRecord slow = record;
  *slow.runs.front().gate_out -= 1'000'000;
  EXPECT_EQ(score(slow, lap_rules(run.laps[1], 5)).value(), flying_lap(maze, model));
  EXPECT_EQ(score(slow, lap_rules(run.laps[1], 5)).runs.at(0).lap, 2);
  EXPECT_EQ(score(slow, lap_rules(run.laps[1] - 1, 5)).value(), first + 1'000'000);
  EXPECT_EQ(score(slow, lap_rules(run.laps[1] - 1, 5)).runs.at(0).lap, 1);
  EXPECT_FALSE(score(record, lap_rules(run.laps[0] - 1, 5)).best);
  EXPECT_EQ(held(run.laps[0] - 1, 5).outcome, DriveOutcome::out_of_time);
  EXPECT_EQ(held(180'000'000, 1).runs.front().laps.size(), 1U);
  // By rules that count runs, laps do not count.
  DriveRules runs = lap_rules(180'000'000, 5);
  runs.counts = Counted::run;
  EXPECT_FALSE(score(record, runs).best);
}

TEST(LapContest, HasNoRunWhereNoLapCanBeDriven) {
  test::Scripted mouse({});
  const DriveRecord record =
      drive(test::ring().with_start({1, 1}, Heading::north), lap_rules(180'000'000, 5), models()[0], mouse);
  EXPECT_TRUE(record.runs.empty());
  EXPECT_EQ(record.outcome, DriveOutcome::out_of_time);
}

}  // namespace
}  // namespace labmouse
