#include "labmouse/lab/routes/route_regions.hpp"

#include <gtest/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/robots/robot_family.hpp"
#include "labmouse/lab/routes/route_report.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

Maze maze_called(const std::string& name) { return *maze_named(name); }

RegionOrder order_of_grip(double from, double to) {
  RegionOrder order;
  order.across = {"curve.lateral_acceleration", from, to};
  order.sharpness = test::thorough ? 1e-3 : 1e-2;
  if (!test::thorough) order.samples = 9;
  return order;
}

/// One plan as `labmouse route` makes it: the walls of the fastest route, or nothing for a robot that is refused.
struct SinglePlan {
  bool refused = true;
  WallSet walls;
  DriveTime time = no_time;
};
SinglePlan single_plan(const Maze& maze, const RobotFamily& family, std::vector<RobotNumber> numbers) {
  const RobotResult robot = family.with(numbers);
  if (!robot.robot) return {};
  const RouteReport report = route_report(maze, robot.model);
  return {false, walls_of(report.route), report.route.time};
}

void expect_region_holds(const SinglePlan& plan, const RouteRegion& region, const RouteRegions& all) {
  ASSERT_EQ(plan.refused, region.route == RouteRegion::refused);
  if (plan.refused) return;
  EXPECT_EQ(plan.walls, all.routes[static_cast<std::size_t>(region.route)].walls);
}

class RouteRegionsTest : public ::testing::Test {
 protected:
  const Maze maze = maze_called("contest-01");
  const RobotFamily classic = *find_robot_family("classic").family;
};

TEST_F(RouteRegionsTest, BothSidesOfEachBorderAreSinglePlansAndClose) {
  LABMOUSE_SKIP_SANITIZED();
  const RegionOrder order = order_of_grip(2'000, 40'000);
  const RouteRegions found = find_regions(maze, classic, order);
  ASSERT_EQ(found.rows.size(), 1U);
  const auto& regions = found.rows.front().regions;
  ASSERT_GE(regions.size(), 3U) << "a refused robot, one route, and another";
  EXPECT_EQ(regions.front().from, order.across.from);
  EXPECT_EQ(regions.back().to, order.across.to);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (const auto& [value, time] :
         {std::pair(regions[i].from, regions[i].time_from), std::pair(regions[i].to, regions[i].time_to)}) {
      const SinglePlan plan = single_plan(maze, classic, {{order.across.key, value}});
      expect_region_holds(plan, regions[i], found);
      EXPECT_EQ(plan.time, time);
    }
    if (i == 0) continue;
    EXPECT_NE(regions[i].route, regions[i - 1].route);
    EXPECT_GT(regions[i].from, regions[i - 1].to);
    EXPECT_LE(regions[i].from - regions[i - 1].to, order.sharpness * (order.across.to - order.across.from));
  }
}

TEST_F(RouteRegionsTest, SinglePlansAtRandomValuesLieInTheirRegions) {
  LABMOUSE_SKIP_SANITIZED();
  const RegionOrder order = order_of_grip(2'000, 40'000);
  const RouteRegions found = find_regions(maze, classic, order);
  Rng rng(7);
  int inside = 0;
  for (int i = 0; i < 60; ++i) {
    const double value = order.across.from + rng.below(38'000);
    for (const RouteRegion& region : found.rows.front().regions) {
      if (value < region.from || value > region.to) continue;
      ++inside;
      expect_region_holds(single_plan(maze, classic, {{order.across.key, value}}), region, found);
    }
  }
  EXPECT_GE(inside, 55);
}

TEST_F(RouteRegionsTest, RowsOfASecondNumberHoldInSinglePlans) {
  LABMOUSE_SKIP_SANITIZED();
  RegionOrder order = order_of_grip(4'000, 16'000);
  order.along = VariedNumber{"straight.acceleration", 4'000, 16'000};
  order.samples = 7;
  order.rows = 4;
  const RouteRegions found = find_regions(maze, classic, order);
  ASSERT_EQ(found.rows.size(), 4U);
  EXPECT_EQ(found.rows.front().at, 4'000);
  EXPECT_EQ(found.rows.back().at, 16'000);
  for (const RegionRow& row : found.rows)
    for (const RouteRegion& region : row.regions)
      for (const double value : {region.from, region.to, region.from + (region.to - region.from) * 0.37})
        expect_region_holds(single_plan(maze, classic, {{order.across.key, value}, {order.along->key, row.at}}), region,
                            found);
}

TEST_F(RouteRegionsTest, TheRunnerUpIsSlowerAndNoOther) {
  const RouteRegions found = find_regions(maze, classic, order_of_grip(4'000, 12'000));
  ASSERT_GE(found.routes.size(), 2U);
  for (const RouteRegion& region : found.rows.front().regions) {
    ASSERT_TRUE(region.runner_up);
    EXPECT_NE(region.runner_up->route, region.route);
    EXPECT_GE(region.runner_up->loss, 0.0);
  }
}

TEST_F(RouteRegionsTest, ThreadsMakeNoDifference) {
  LABMOUSE_SKIP_SANITIZED();
  RegionOrder order = order_of_grip(2'000, 40'000);
  order.jobs = 1;
  const std::string alone = json_of(find_regions(maze, classic, order), order, "contest-01", "classic");
  order.jobs = 4;
  EXPECT_EQ(json_of(find_regions(maze, classic, order), order, "contest-01", "classic"), alone);
}

TEST_F(RouteRegionsTest, WhatIsRefusedEverywhereHasNoRoutes) {
  const RouteRegions found = find_regions(maze, classic, order_of_grip(1, 50));
  EXPECT_TRUE(found.routes.empty());
  ASSERT_EQ(found.rows.front().regions.size(), 1U);
  EXPECT_FALSE(found.rows.front().regions.front().refusal.empty());
}

TEST(VariedNumber, IsAKeyAndARange) {
  const VariedNumberResult read = read_varied_number("curve.lateral_acceleration=5000:7e4");
  ASSERT_EQ(read.error, "");
  EXPECT_EQ(read.number.key, "curve.lateral_acceleration");
  EXPECT_EQ(read.number.from, 5'000);
  EXPECT_EQ(read.number.to, 70'000);
}

TEST(VariedNumber, IsRefusedWithAReason) {
  for (const char* text :
       {"", "curve.lateral_acceleration", "curve.lateral_acceleration=5000",
        "curve.lateral_acceleration=5000:", "curve.lateral_acceleration=7000:5000",
        "curve.lateral_acceleration=5000:5000", "curve.lateral_acceleration=5000:nan",
        "curve.lateral_acceleration=5000:7000 ", "curve.grips=1:2", "curve.speeds=1:6", "diagonals=0:1", "stop=1:2"})
    EXPECT_NE(read_varied_number(text).error, "") << text;
}

TEST(RegionLetters, GoOnBehindZ) {
  EXPECT_EQ(letter_of(0), "A");
  EXPECT_EQ(letter_of(25), "Z");
  EXPECT_EQ(letter_of(26), "A1");
}

}  // namespace
}  // namespace labmouse
