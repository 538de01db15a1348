#include "labmouse/mouse/robot/drive_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "labmouse/mouse/drive/fastest.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

/// Limits that are easy to reckon with: a cell of 100 mm, 1000 mm/s, 2000 mm/s² up and down, curves at most 400 mm/s.
Robot plain_robot() {
  Robot robot = published_robot();
  robot.fixed.reset();
  robot.cell = 100.0;
  robot.speed = robot.speed_diagonal = 1000.0;
  robot.acceleration = robot.acceleration_diagonal = robot.braking = robot.braking_diagonal = 2000.0;
  robot.lateral_acceleration = 4000.0;
  robot.yaw_acceleration = 300.0;
  robot.clearance = 15.0;
  robot.run_up = 20.0;
  return robot;
}

DriveRoute straight_on(const DriveModel& model, int cells) {
  DriveSegment segment;
  segment.from = {{0, 0}, Heading::north, Place::centre};
  segment.to = {{0, cells}, Heading::north, Place::centre};
  segment.units = 2 * cells;
  segment.end = model.tables.whole_way(2 * cells, max_drive_side);
  DriveRoute route;
  route.segments = {segment};
  route.time = segment.end;
  return route;
}

TEST(DriveProfile, SpeedsUpFromRestToItsLimit) {
  const DriveModel model = make_drive_model(plain_robot());
  ASSERT_EQ(model.error, "");
  const DriveRoute route = straight_on(model, 5);
  const DriveProfile profile(model, route, 0);
  EXPECT_DOUBLE_EQ(profile.length(), 520.0);
  // 250 mm and half a second to 1000 mm/s, and 270 mm at that.
  EXPECT_NEAR(profile.duration(), 770'000, 1);
  EXPECT_NEAR(profile.distance_at(250'000), 62.5, 1e-3);
  EXPECT_NEAR(profile.speed_at(250'000), 500.0, 1e-2);
  EXPECT_NEAR(profile.speed_at(770'000), 1000.0, 1e-6);
  EXPECT_NEAR(profile.time_at(250.0), 500'000, 2);
  EXPECT_NEAR(profile.time_at(350.0), 600'000, 2);
  // It stands behind the middle of its cell.
  EXPECT_NEAR(profile.spot(0.0).y, 30.0, 1e-9);
  EXPECT_NEAR(profile.spot(520.0).y, 550.0, 1e-9);
}

TEST(DriveProfile, BrakesBeforeATurn) {
  const DriveModel model = make_drive_model(published_robot());
  DriveSegment segment;
  segment.from = {{0, 0}, Heading::north, Place::centre};
  segment.to = {{0, 3}, Heading::north, Place::centre};
  segment.units = 6;
  segment.end = model.tables.along.at(6, 0, 0);
  DriveRoute route;
  route.segments = {segment};
  const DriveProfile profile(model, route, 0);
  EXPECT_NEAR(profile.speed_at(0), 420.0, 1e-9);
  EXPECT_NEAR(profile.speed_at(profile.duration()), 420.0, 1e-6);
  EXPECT_NEAR(profile.distance_at(profile.duration() / 2.0), 135.0, 1e-6);
  EXPECT_NEAR(profile.speed_at(profile.duration() / 2.0), std::sqrt(420.0 * 420.0 + 4200.0 * 270.0), 1.0);
}

/// Every route of some mazes, with each of its profiles.
template <class Check>
void for_each_profile(const DriveModel& model, Check check) {
  Rng rng(5);
  for (int round = 0; round < test::tenth(40); ++round) {
    const Maze maze = test::any_maze(rng, 16);
    FastestRoutes routes(maze.size(), model.tables);
    routes.fill(maze.open_walls(), maze.goals());
    DriveRoute route;
    routes.route_from({maze.start(), maze.start_heading()}, route);
    for (std::size_t i = 0; i < route.segments.size(); ++i) check(route, i, DriveProfile(model, route, i));
  }
}

class Profiles : public testing::TestWithParam<Robot> {};

TEST_P(Profiles, JoinInPlaceDirectionAndSpeed) {
  const DriveModel model = make_drive_model(GetParam());
  ASSERT_EQ(model.error, "");
  for_each_profile(model, [&](const DriveRoute& route, std::size_t i, const DriveProfile& profile) {
    if (i + 1 == route.segments.size()) return;
    const DriveProfile next(model, route, i + 1);
    const DriveSpot end = profile.spot(profile.length()), begin = next.spot(0.0);
    ASSERT_NEAR(end.x, begin.x, 1e-6 * model.tables.cell);
    ASSERT_NEAR(end.y, begin.y, 1e-6 * model.tables.cell);
    ASSERT_NEAR(std::remainder(end.angle - begin.angle, 2 * std::acos(-1.0)), 0.0, 1e-6);
    // Published turns are a little longer or shorter than what their one speed makes of their times.
    if (GetParam().fixed) return;
    ASSERT_NEAR(profile.speed_at(profile.duration()), next.speed_at(0), 0.5);
  });
}

TEST_P(Profiles, SayWhenAndHowFarAlike) {
  const DriveModel model = make_drive_model(GetParam());
  for_each_profile(model, [&](const DriveRoute&, std::size_t, const DriveProfile& profile) {
    for (int part = 0; part <= 8; ++part) {
      const double time = profile.duration() * part / 8.0;
      ASSERT_NEAR(profile.time_at(profile.distance_at(time)), time, 1e-3 * profile.duration() + 1e-6);
    }
    ASSERT_NEAR(profile.distance_at(profile.duration()), profile.length(), 1e-6 * profile.length());
  });
}

INSTANTIATE_TEST_SUITE_P(Robots, Profiles,
                         testing::Values(published_robot(), small_robot(), large_robot(), fan_robot(),
                                         unstopped_robot(), grip_robot(), small_grip_robot()),
                         [](const auto& robot) { return robot.param.name; });

}  // namespace
}  // namespace labmouse
