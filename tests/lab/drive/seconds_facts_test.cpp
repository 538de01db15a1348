// What is known from outside about routes in seconds, held against ours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/routes/route_report.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

DriveRoute route_of(const Maze& maze, const DriveModel& model) {
  FastestRoutes routes(maze.size(), model.tables);
  const Pose start = {maze.start(), maze.start_heading()};
  routes.fill_for(start, maze.open_walls(), maze.goals());
  DriveRoute route;
  routes.route_from(start, route);
  return route;
}

/// The classic contest mazes; under the sanitizers a quarter of them.
std::vector<Maze> classic_mazes() {
  std::vector<Maze> mazes;
  for (const auto& file : test::maze_files())
    if (auto maze = test::maze_in_file(file);
        maze && maze->size() == Size{16, 16} && file.parent_path().filename() == "classic")
      mazes.push_back(*maze);
  std::vector<Maze> some;
  for (std::size_t i = 0; i < mazes.size(); i += test::thorough ? 1 : 4) some.push_back(mazes[i]);
  return some;
}

bool same_way(const DriveRoute& a, const DriveRoute& b) {
  return std::equal(a.segments.begin(), a.segments.end(), b.segments.begin(), b.segments.end(),
                    [](const DriveSegment& x, const DriveSegment& y) { return x.kind == y.kind && x.to == y.to; });
}

// With 287 ms in place of 280 for S90 the fastest routes of 126 of 519 mazes change (MM2021's run parameters).
TEST(Fact, ManyRoutesDependOnTheTimeOfTheSmallTurn) {
  const std::vector<Maze> mazes = classic_mazes();
  if (mazes.empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  Robot robot = find_robot("mm2021").robot;
  robot.fixed->s90 = 280'000;
  const DriveModel before = make_drive_model(robot);
  robot.fixed->s90 = 287'000;
  const DriveModel after = make_drive_model(robot);
  const auto changed = std::count_if(mazes.begin(), mazes.end(), [&](const Maze& maze) {
    return !same_way(route_of(maze, before), route_of(maze, after));
  });
  const double share = static_cast<double>(changed) / static_cast<double>(mazes.size());
  EXPECT_NEAR(share, 126.0 / 519.0, 0.08);
}

// With two speeds a turn and any speed at the end, 85 of 259 routes end too fast to stop before the wall behind.
TEST(Fact, NearlyAThirdOfTheRoutesWouldEndInAWall) {
  LABMOUSE_SKIP_SANITIZED();
  const std::vector<Maze> mazes = classic_mazes();
  if (mazes.empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  Robot robot = robot_of_the_past(find_robot("classic").robot);
  const DriveModel beyond = make_drive_model(robot);
  robot.stop = Stop::goal;
  const DriveModel goal = make_drive_model(robot);
  int routes = 0, later = 0;
  for (const Maze& maze : mazes) {
    const DriveTime least = route_of(maze, beyond).time;
    if (least >= no_time) continue;
    ++routes;
    if (route_of(maze, goal).time > least) ++later;
  }
  EXPECT_NEAR(static_cast<double>(later) / routes, 85.0 / 259.0, 0.05);
}

// The All-Japan final of 2017: the shorter of two routes has 99 cells, the other one 121. With one speed for all turns
// the long one is faster where tyres hold little, and the short one where they hold three g and more; five g were once
// refused.
TEST(Fact, GripDecidesWhichRouteOf2017IsFaster) {
  const auto files = test::maze_files();
  const auto file =
      std::find_if(files.begin(), files.end(), [](const auto& each) { return each.filename() == "japan2017ef.txt"; });
  if (file == files.end()) GTEST_SKIP() << "no japan2017ef.txt in " << test::folder_of_mazes();
  const Maze maze = *test::maze_in_file(*file);
  for (const double g : {1.0, 3.0, 4.0, 5.0, 8.0}) {
    Robot robot = find_robot("classic").robot;
    robot.speeds = 1;
    robot.lateral_acceleration = g * 9810.0;
    const DriveModel model = make_drive_model(robot);
    ASSERT_EQ(model.error, "") << g;
    EXPECT_EQ(RouteReporter(model).report(maze).cells, g < 2.0 ? 121 : 99) << g;
  }
}

// The published curves keep 31 mm from the middle of posts.
TEST(Fact, PublishedCurvesKeepTheirDistance) {
  for (const TurnShape& shape : find_robot("kerise").model.shapes)
    EXPECT_GE(shape.clearance, 30.9) << name_of(shape.turn);
}

// The reference mouse of UKMARS: 400 mm/s in a search and 300 mm/s in its turns, cells of 180 mm, no diagonals.
TEST(Fact, ABeginnersMouseIsSlow) {
  const FoundRobot beginner = find_robot("beginner");
  EXPECT_EQ(beginner.model.search.cell, std::lround(180.0 / 400.0 * 1e6));
  EXPECT_EQ(beginner.robot.search_turn_speed, 300.0);
  EXPECT_EQ(beginner.robot.cell, 180.0);
  for (const DrivenTurn& turn : beginner.model.tables.turns)
    EXPECT_FALSE(begins_diagonal(turn.turn) || ends_diagonal(turn.turn));
}

}  // namespace
}  // namespace labmouse
