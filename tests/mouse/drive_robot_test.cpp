// A robot's tables of whole microseconds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/robot.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;

void expect_no_gain_by_splitting(const DriveTables& tables) {
  for (const StraightTimes* straights : {&tables.along, &tables.diagonal}) {
    ASSERT_EQ(straights->between.size(), 65U);
    for (int a = 0; a <= 64; ++a)
      for (int b = 0; a + b <= 64; ++b)
        EXPECT_LE(straights->at(a + b, 0, 0), straights->at(a, 0, 0) + straights->at(b, 0, 0)) << a << " + " << b;
  }
}

TEST(FixedRobot, HasOneLaneAndTheTimesGiven) {
  const DriveModel model = make_drive_model(published_robot());
  ASSERT_EQ(model.error, "");
  EXPECT_EQ(model.tables.along.lanes, (std::vector<Lane>{{420.0, 0.0}}));
  EXPECT_EQ(model.tables.diagonal.lanes, (std::vector<Lane>{{420.0, 0.0}}));
  std::vector<DriveTime> times;
  for (const DrivenTurn& turn : model.tables.turns) times.push_back(turn.time);
  EXPECT_EQ(times, (std::vector<DriveTime>{257'000, 375'000, 465'000, 563'000, 388'000, 280'000, 257'000, 465'000}));
  EXPECT_EQ(model.tables.shortest_turn(), 257'000);
  EXPECT_EQ(model.search, published_robot().search);
}

TEST(FixedRobot, DrivesStraightsByTrapezoids) {
  const DriveTables tables = make_drive_model(published_robot()).tables;
  EXPECT_EQ(tables.along.at(0, 0, 0), 0);
  // Half a cell: up to sqrt(420² + 4200 * 45) = 604.483 mm/s and back, 2 * 184.483 / 4200 s.
  EXPECT_EQ(tables.along.at(1, 0, 0), 87'849);
  // 64 half cells, 2880 mm: 2 * 1080 / 4200 s on ramps of 493.714 mm in all, the rest at 1500 mm/s.
  EXPECT_EQ(tables.along.at(64, 0, 0), 2'105'143);
  // Half a diagonal, 63.640 mm: up to sqrt(420² + 3600 * 63.640) and back.
  EXPECT_EQ(tables.diagonal.at(1, 0, 0), 120'439);
  EXPECT_EQ(tables.start, tables.along.between);
  EXPECT_EQ(tables.finish, tables.along.between);
  EXPECT_EQ(tables.whole, tables.along.between);
}

TEST(FixedRobot, NeverGainsBySplittingAStraight) {
  // At one speed everywhere a half cell lasts 104651.16 us; four of them, each rounded down, would beat 418604.65 us.
  Robot steady = published_robot();
  steady.speed = steady.speed_diagonal = steady.fixed->speed = 430.0;
  EXPECT_EQ(make_drive_model(steady).tables.along.at(4, 0, 0), 4 * 104'651);
  for (const Robot& robot : {published_robot(), steady}) expect_no_gain_by_splitting(make_drive_model(robot).tables);
}

TEST(FixedRobot, HasAHashOfAllItsNumbers) {
  const DriveTables tables = make_drive_model(published_robot()).tables;
  EXPECT_EQ(tables.hash, hash_of(tables));
  const auto changed = [&](auto change) {
    DriveTables other = tables;
    change(other);
    return hash_of(other) != tables.hash;
  };
  EXPECT_TRUE(changed([](DriveTables& other) { ++other.along.between[7]; }));
  EXPECT_TRUE(changed([](DriveTables& other) { ++other.diagonal.between[64]; }));
  EXPECT_TRUE(changed([](DriveTables& other) { ++other.start[0]; }));
  EXPECT_TRUE(changed([](DriveTables& other) { ++other.finish[0]; }));
  EXPECT_TRUE(changed([](DriveTables& other) { ++other.whole[0]; }));
  EXPECT_TRUE(changed([](DriveTables& other) { ++other.turns[3].time; }));
  EXPECT_TRUE(changed([](DriveTables& other) { other.turns[3].to = 1; }));
  EXPECT_TRUE(changed([](DriveTables& other) { other.turns[3].speed += 0.001; }));
  EXPECT_TRUE(changed([](DriveTables& other) { other.along.lanes[0].lead += 0.001; }));
  EXPECT_TRUE(changed([](DriveTables& other) { other.diagonal.lanes[0].speed += 0.001; }));
  EXPECT_TRUE(changed([](DriveTables& other) { other.cell += 0.001; }));
}

TEST(FixedRobot, IsRefusedWhereTimesWouldLeaveTheirRange) {
  const auto error = [](auto change) {
    Robot robot = published_robot();
    change(robot);
    return make_drive_model(robot).error;
  };
  EXPECT_THAT(error([](Robot& robot) { robot.fixed->speed = 49.5; }), Says("speed at nodes", "49.5 mm/s", "50 mm/s"));
  EXPECT_EQ(error([](Robot& robot) { robot.fixed->speed = 50.0; }), "");
  EXPECT_THAT(error([](Robot& robot) { robot.fixed->speed = robot.speed_diagonal = 40.0; }),
              Says("straights", "50 mm/s", "40 mm/s"));
  EXPECT_THAT(error([](Robot& robot) { robot.fixed->v90 = 999; }), Says("V90", "0.999 ms", "1 ms"));
  EXPECT_THAT(error([](Robot& robot) { robot.fixed->speed = 1201.0; }),
              Says("speed at nodes", "1201 mm/s", "1500 mm/s", "1200 mm/s"));
  EXPECT_THAT(error([](Robot& robot) { robot.braking = 0.0; }), Says("brakings", "greater than 0"));
}

}  // namespace
}  // namespace labmouse
