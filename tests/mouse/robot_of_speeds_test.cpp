// Robots whose turns follow from their limits: each at its own speed and at the slowest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/fitted_turn.hpp"
#include "labmouse/mouse/robot/robot.hpp"
#include "labmouse/mouse/robot/straights.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::Says;

const TurnShape& shape_of(const DriveModel& model, Turn turn) {
  return *std::find_if(model.shapes.begin(), model.shapes.end(), [=](const auto& it) { return it.turn == turn; });
}

TEST(RobotOfSpeeds, DrivesEachTurnAtItsOwnSpeedAndAtTheSlowest) {
  const DriveModel model = make_drive_model(robot_of_the_past(small_robot()));
  ASSERT_EQ(model.error, "");
  std::vector<std::pair<Turn, double>> turns;
  for (const DrivenTurn& turn : model.tables.turns) turns.emplace_back(turn.turn, std::round(turn.speed));
  EXPECT_EQ(turns, (std::vector<std::pair<Turn, double>>{{Turn::f45, 595.0},
                                                         {Turn::f45, 380.0},
                                                         {Turn::f90, 560.0},
                                                         {Turn::f90, 380.0},
                                                         {Turn::f135, 435.0},
                                                         {Turn::f135, 380.0},
                                                         {Turn::f180, 413.0},
                                                         {Turn::f180, 380.0},
                                                         {Turn::v90, 465.0},
                                                         {Turn::v90, 380.0},
                                                         {Turn::s90, 380.0},
                                                         {Turn::out45, 595.0},
                                                         {Turn::out45, 380.0},
                                                         {Turn::out135, 435.0},
                                                         {Turn::out135, 380.0}}));
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    const DrivenTurn& turn = model.tables.turns[i];
    const auto& before = begins_diagonal(turn.turn) ? model.tables.diagonal : model.tables.along;
    const auto& after = ends_diagonal(turn.turn) ? model.tables.diagonal : model.tables.along;
    EXPECT_EQ(before.lanes[turn.from], (Lane{turn.speed, model.shapes[i].lead_in}));
    EXPECT_EQ(after.lanes[turn.to], (Lane{turn.speed, model.shapes[i].lead_out}));
  }
}

std::vector<double> speeds_of(const DriveModel& model, Turn turn) {
  std::vector<double> speeds;
  for (const DrivenTurn& driven : model.tables.turns)
    if (driven.turn == turn) speeds.push_back(std::round(driven.speed * 10.0) / 10.0);
  return speeds;
}

TEST(RobotOfSpeeds, DrivesEachTurnAtSharedLowerSpeeds) {
  // Own speeds of turns: 595, 560, 435, 412.8, 465 and 380 mm/s. The widest gap is split by one that lies within it, or
  // in its middle.
  Robot robot = small_robot();
  robot.speeds = 4;
  const DriveModel four = make_drive_model(robot);
  EXPECT_EQ(speeds_of(four, Turn::f45), (std::vector{595.0, 560.0, 465.0, 380.0}));
  EXPECT_EQ(speeds_of(four, Turn::f90), (std::vector{560.0, 465.0, 380.0}));
  EXPECT_EQ(speeds_of(four, Turn::f135), (std::vector{435.0, 380.0}));
  EXPECT_EQ(speeds_of(four, Turn::s90), (std::vector{380.0}));
  robot.speeds = 6;
  EXPECT_EQ(speeds_of(make_drive_model(robot), Turn::f45), (std::vector{595.0, 560.0, 512.5, 465.0, 412.8, 380.0}));
  robot.speeds = 1;
  const DriveModel one = make_drive_model(robot);
  for (const Turn turn : all_turns) EXPECT_EQ(speeds_of(one, turn), (std::vector{380.0})) << name_of(turn);
}

TEST(RobotOfSpeeds, HasEveryLaneOnce) {
  for (const Robot& robot : {small_robot(), large_robot(), fan_robot()}) {
    const DriveTables tables = make_drive_model(robot_of_the_past(robot)).tables;
    for (const StraightTimes* straights : {&tables.along, &tables.diagonal}) {
      EXPECT_EQ(straights->between.size(), 65 * straights->count() * straights->count());
      for (std::size_t i = 0; i < straights->count(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(straights->lanes[i] == straights->lanes[j]);
    }
    EXPECT_EQ(tables.start.size(), 65 * tables.along.count());
    EXPECT_EQ(tables.finish.size(), 65 * tables.along.count());
    EXPECT_EQ(tables.whole.size(), 65U);
  }
}

/// The time over a length by its speeds: as fast as the limits let it from both ends, in 100,000 steps, shorter where
/// it may be slow.
double stepped_seconds(double length, double from, double to, const StraightLimits& limits) {
  const int steps = 100'000;
  double seconds = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double share = (i + 0.5) / steps;
    const double step = length * 2.0 * share / steps;
    const double done = length * share * share;
    const double up = std::sqrt(from * from + 2.0 * limits.acceleration * done);
    const double down = std::sqrt(to * to + 2.0 * limits.braking * (length - done));
    seconds += step / std::min({limits.speed, up, down});
  }
  return seconds;
}

TEST(RobotOfSpeeds, TakesTheTimeOfItsSpeedsOverEveryStraight) {
  LABMOUSE_SKIP_SANITIZED();
  Robot robot = large_robot();
  robot.braking = 7000.0;
  robot.braking_diagonal = 12'000.0;
  const DriveTables tables = make_drive_model(robot).tables;
  const auto check = [&](const StraightTimes& straights, double unit, const StraightLimits& limits) {
    for (const int units : {0, 1, 2, 5, 20, 64})
      for (std::size_t from = 0; from < straights.count(); ++from)
        for (std::size_t to = 0; to < straights.count(); ++to) {
          const Lane& before = straights.lanes[from];
          const Lane& after = straights.lanes[to];
          const double length = units * unit + before.lead + after.lead;
          const double gain = after.speed * after.speed - before.speed * before.speed;
          const bool possible = gain <= 2.0 * limits.acceleration * length && -gain <= 2.0 * limits.braking * length;
          ASSERT_EQ(straights.at(units, from, to) < no_time, possible) << units << ": " << from << " to " << to;
          if (!possible) continue;
          ASSERT_NEAR(straights.at(units, from, to), stepped_seconds(length, before.speed, after.speed, limits) * 1e6,
                      2.0)
              << units << ": " << from << " to " << to;
        }
  };
  check(tables.along, 90.0, limits_along(robot));
  check(tables.diagonal, 180.0 / std::sqrt(2.0), limits_diagonal(robot));
}

TEST(RobotOfSpeeds, StartsAtRestWithARunUpAndEndsAtAnySpeed) {
  const Robot robot = robot_of_the_past(large_robot());
  const DriveTables tables = make_drive_model(robot).tables;
  const StraightLimits limits = limits_along(robot);
  for (const int units : {0, 1, 2, 30, 64})
    for (std::size_t lane = 0; lane < tables.along.count(); ++lane) {
      const auto [speed, lead] = tables.along.lanes[lane];
      const double length = units * 90.0 + lead;
      const bool possible = speed * speed <= 2.0 * robot.acceleration * (length + robot.run_up);
      ASSERT_EQ(tables.start_to(units, lane) < no_time, possible);
      if (possible) {
        EXPECT_NEAR(tables.start_to(units, lane), stepped_seconds(length + robot.run_up, 0.0, speed, limits) * 1e6,
                    2.0);
      }
      EXPECT_NEAR(tables.finish_from(units, lane, 0), stepped_seconds(length, speed, 1e6, limits) * 1e6, 2.0);
    }
  EXPECT_EQ(tables.whole[0], 100'000);     // 50 mm at 10 m/s²
  EXPECT_EQ(tables.whole[30], 1'066'667);  // 300 ms and 450 mm to 3 m/s, 2300 mm at that
}

TEST(RobotOfSpeeds, EndsAtASpeedThatItStopsFrom) {
  LABMOUSE_SKIP_SANITIZED();
  const Robot robot = large_robot();
  const DriveTables tables = make_drive_model(robot).tables;
  const StraightLimits limits = limits_along(robot);
  // From 3 m/s it stops in 450 mm: two and a half cells of 180 mm.
  ASSERT_EQ(tables.rooms(), 4);
  for (int room = 0; room < 6; ++room) {
    const double end = std::sqrt(std::min(9e6, 2.0 * robot.braking * room * 180.0));
    for (const int units : {0, 1, 2, 7, 30, 64})
      for (std::size_t lane = 0; lane < tables.along.count(); ++lane) {
        const auto [speed, lead] = tables.along.lanes[lane];
        const double length = units * 90.0 + lead;
        const double reached = std::sqrt(speed * speed + 2.0 * robot.acceleration * length);
        const bool possible = speed * speed <= end * end + 2.0 * robot.braking * length;
        ASSERT_EQ(tables.finish_from(units, lane, room) < no_time, possible);
        if (!possible) continue;
        // From the slower end on.
        const double seconds =
            reached <= end ? stepped_seconds(length, speed, 1e6, limits)
                           : stepped_seconds(length, end, speed, {limits.speed, limits.braking, limits.acceleration});
        EXPECT_NEAR(tables.finish_from(units, lane, room), seconds * 1e6, 2.0);
      }
  }
  EXPECT_EQ(tables.whole_way(0, 1), 100'000);       // 50 mm to 1 m/s
  EXPECT_NEAR(tables.whole_way(0, 0), 141'421, 1);  // and to rest again
  Robot weak = robot;
  weak.braking = 3000.0;
  // From S90 into the goal it has half a cell and the lead to stop.
  const DriveTables slower = make_drive_model(weak).tables;
  const auto small = std::find_if(slower.turns.rbegin(), slower.turns.rend(),
                                  [](const DrivenTurn& turn) { return turn.turn == Turn::s90; });
  EXPECT_LT(slower.finish_from(1, small->to, 0), no_time);
  EXPECT_EQ(small->speed, 735.0);
}

TEST(RobotOfSpeeds, DashesOverKnownCells) {
  Robot robot = small_robot();
  EXPECT_FALSE(make_drive_model(robot).search.dashes());
  robot.known_speed = 600.0;
  robot.known_acceleration = 3000.0;
  const SearchDrive search = make_drive_model(robot).search;
  ASSERT_TRUE(search.dashes());
  EXPECT_EQ(search.cell, 300'000);
  EXPECT_EQ(search.dash(1), 300'000);
  const StraightLimits limits = {600.0, 3000.0, 3000.0};
  for (int cells = 2; cells <= max_drive_side; ++cells)
    EXPECT_NEAR(search.dash(cells), *seconds_between(cells * robot.cell, 300.0, 300.0, limits) * 1e6, 1.01) << cells;
  robot.known_acceleration = 0.0;
  robot.braking = 2000.0;
  EXPECT_NEAR(make_drive_model(robot).search.dash(4),
              *seconds_between(4 * robot.cell, 300.0, 300.0, {600.0, 2000.0, 2000.0}) * 1e6, 1.01);
}

TEST(RobotOfSpeeds, RefusesDashesThatAreNone) {
  Robot robot = small_robot();
  robot.known_speed = 300.0;
  EXPECT_NE(make_drive_model(robot).error.find("search.known_speed"), std::string::npos);
  robot.known_speed = 0.0;
  robot.known_acceleration = 3000.0;
  EXPECT_NE(make_drive_model(robot).error.find("search.known_acceleration"), std::string::npos);
}

TEST(RobotOfSpeeds, DerivesItsSearch) {
  const DriveModel model = make_drive_model(small_robot());
  EXPECT_EQ(model.search.cell, 300'000);
  EXPECT_NEAR(model.search.turn, shape_of(model, Turn::s90).whole() / 300.0 * 1e6, 0.51);
  // 300 mm/s after 71.429 ms and 10.714 mm, the other 34.286 mm in 114.286 ms.
  EXPECT_EQ(model.search.half_cell, 185'714);
  // A quarter: 100 ms up to 10 rad/s, as much down, 0.5708 rad between; a half turn 1.5708 rad more.
  EXPECT_EQ(model.search.quarter, 257'080);
  EXPECT_EQ(model.search.back, 2 * 185'714 + 414'159);
  Robot slow_brakes = small_robot();
  slow_brakes.braking = 1500.0;
  EXPECT_EQ(make_drive_model(slow_brakes).search.half_cell, 250'000);
}

/// Seconds over a lead, in small steps: from the edge of the cell at one speed, changed as late as possible.
double lead_seconds(double lead, double edge, double curve, double rate) {
  constexpr int steps = 100'000;
  double seconds = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double left = lead * (i + 0.5) / steps;  // to the curve
    const double change = 2.0 * rate * left;
    const double speed = curve < edge ? std::min(edge, std::sqrt(curve * curve + change))
                                      : std::max(edge, std::sqrt(std::max(0.0, curve * curve - change)));
    seconds += lead / steps / speed;
  }
  return seconds;
}

TEST(RobotOfSpeeds, ChangesItsSpeedForTheTurnsOfItsSearch) {
  Robot robot = large_robot();
  robot.braking = 7000.0;
  const SearchDrive before = make_drive_model(robot).search;
  for (const double speed : {300.0, 400.0, 520.0, 600.0}) {
    robot.search_turn_speed = speed;
    const DriveModel model = make_drive_model(robot);
    ASSERT_EQ(model.error, "");
    const TurnShape own = shape_at(Turn::s90, speed, curve_limits(robot), robot.cell);
    const bool slower = speed < robot.search_speed;
    const double expected = lead_seconds(own.lead_in, 500.0, speed, slower ? robot.braking : robot.acceleration) +
                            own.length / speed +
                            lead_seconds(own.lead_out, 500.0, speed, slower ? robot.acceleration : robot.braking);
    EXPECT_NEAR(model.search.turn, expected * 1e6, 2.0) << speed;
    EXPECT_EQ(model.search.cell, before.cell);
    EXPECT_EQ(model.search.back, before.back);
  }
}

TEST(RobotOfSpeeds, ChangesItsSpeedWithinTheCellOfATurn) {
  Robot robot = large_robot();
  // Quicker than in a run: there S90 is driven at 850 mm/s at most.
  robot.search_speed = 800.0, robot.search_turn_speed = 860.0;
  EXPECT_THAT(make_drive_model(robot).error, Says("S90", "860 mm/s", "search.turn_speed"));
  robot.search_speed = 200.0, robot.search_turn_speed = 800.0;  // 30 mm of speeding up, and as much to brake
  EXPECT_THAT(make_drive_model(robot).error, Says("200 mm/s", "800 mm/s", "30 mm", "search.turn_speed"));
  robot.search_speed = 1300.0, robot.search_turn_speed = 750.0;
  EXPECT_THAT(make_drive_model(robot).error, Says("1300 mm/s", "750 mm/s", "search.turn_speed"));
}

TEST(RobotOfSpeeds, DrivesOnlyTheTurnsThatItHas) {
  Robot robot = large_robot();
  robot.layouts[static_cast<unsigned>(Turn::f45)].driven = false;
  robot.layouts[static_cast<unsigned>(Turn::f180)].driven = false;
  for (const DrivenTurn& turn : make_drive_model(robot).tables.turns)
    EXPECT_TRUE(turn.turn != Turn::f45 && turn.turn != Turn::out45 && turn.turn != Turn::f180) << name_of(turn.turn);
  const DriveTables square = make_drive_model(square_robot()).tables;
  for (const DrivenTurn& turn : square.turns) EXPECT_FALSE(begins_diagonal(turn.turn) || ends_diagonal(turn.turn));
  EXPECT_EQ(make_drive_model(robot_of_the_past(square_robot())).tables.turns.size(), 5U);  // S90, 90 and 180 twice
  EXPECT_EQ(square.diagonal.count(), 0U);
}

TEST(RobotOfSpeeds, HasASpeedThatItReachesFromRest) {
  const Robot robot = strong_robot();
  const DriveTables tables = make_drive_model(robot).tables;
  const auto small = std::find_if(tables.turns.rbegin(), tables.turns.rend(),
                                  [](const DrivenTurn& turn) { return turn.turn == Turn::s90; });
  EXPECT_LT(tables.start_to(1, small->from), no_time);
  // 140 mm and the lead at 10 m/s²: 1673 mm/s and a little.
  // To stop it has the way from the wall only: 90 mm and the lead.
  EXPECT_EQ(small->speed, 1340.0);
  Robot unstopped = robot;
  unstopped.stop = Stop::beyond;
  EXPECT_EQ(speeds_of(make_drive_model(unstopped), Turn::s90).back(), 1670.0);
  EXPECT_GT(fitted_turn(Turn::s90, robot).speed, 2500.0);
}

TEST(RobotOfSpeeds, IsRefusedInItsOwnUnits) {
  const auto error = [](auto change) {
    Robot robot = large_robot();
    change(robot);
    return make_drive_model(robot).error;
  };
  EXPECT_THAT(error([](Robot& robot) { robot.clearance = 64.0; }), Says("clearance of 64 mm", "180 mm", "63.6 mm"));
  EXPECT_EQ(error([](Robot& robot) { robot.clearance = 63.63; }), "");
  EXPECT_THAT(error([](Robot& robot) { robot.yaw_acceleration = 0.5, robot.search_speed = 10.0; }),
              Says("turn S90 ", "180 mm", "40 mm/s", "50 mm/s", "yaw acceleration"));
  EXPECT_EQ(error([](Robot& robot) { robot.yaw_acceleration = 100.0; }), "");
  EXPECT_THAT(error([](Robot& robot) { robot.yaw_acceleration = 0.0001; }),
              Says("turn 45 ", "180 mm", "5 mm/s", "yaw acceleration"));
  EXPECT_EQ(error([](Robot& robot) { robot.acceleration = 2500.0; }), "");
  EXPECT_THAT(error([](Robot& robot) { robot.acceleration = 8.0, robot.search_speed = 30.0; }),
              Says("start cell", "50 mm/s", "acceleration", "run-up"));
  EXPECT_THAT(error([](Robot& robot) { robot.search_speed = 900.0; }),
              Says("search speed", "900 mm/s", "S90", "850 mm/s"));
  EXPECT_THAT(error([](Robot& robot) { robot.braking = 1000.0; }),
              Says("search speed", "500 mm/s", "half a cell", "424 mm/s"));
  EXPECT_THAT(error([](Robot& robot) { robot.pivot_speed = 0.0; }), Says("pivot speed", "greater than 0"));
  EXPECT_THAT(error([](Robot& robot) { robot.lateral_acceleration = 0.0; }),
              Says("lateral acceleration", "greater than 0"));
  EXPECT_THAT(error([](Robot& robot) { robot.speeds = 9; }), Says("1 to 8", "9"));
  EXPECT_THAT(error([](Robot& robot) { robot.speeds = 0; }), Says("1 to 8", "0"));
  EXPECT_THAT(error([](Robot& robot) { robot.run_up = -1.0; }), Says("run-up", "0 or more"));
  EXPECT_THAT(error([](Robot& robot) { robot.run_up = 90.0; }), Says("run-up of 90 mm", "start cell"));
}

TEST(RobotOfSpeeds, IsRefusedForWhatIsInItsWay) {
  Robot robot = large_robot();
  robot.yaw_speed = 0.1;
  EXPECT_THAT(make_drive_model(robot).error, Says("yaw speed", "0.1 rad/s", "curve.yaw_speed"));
  robot.yaw_speed = 7.0;
  ASSERT_EQ(make_drive_model(robot).error, "");
  robot.yaw_jerk = 100.0;
  EXPECT_THAT(make_drive_model(robot).error, Says("yaw jerk", "100 rad/s³", "curve.yaw_jerk"));
  robot.yaw_acceleration = 1.0;  // and that is not enough either
  EXPECT_THAT(make_drive_model(robot).error, testing::Not(Says("yaw jerk")));
}

TEST(RobotOfSpeeds, HasTheSameNumbersOnEveryPlatform) {
  EXPECT_EQ(make_drive_model(published_robot()).tables.hash, 17765994016381339539U);
  // Those of records that were written before there was a choice.
  EXPECT_EQ(make_drive_model(robot_of_the_past(small_robot())).tables.hash, 1207968012835192590U);
  EXPECT_EQ(make_drive_model(robot_of_the_past(large_robot())).tables.hash, 2475079842104813547U);
}

}  // namespace
}  // namespace labmouse
