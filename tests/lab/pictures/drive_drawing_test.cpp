#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/robot/drive_profile.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"
#include "tests/lab/xml_scanner.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

DriveRoute fastest_route(const Maze& maze, const DriveModel& model) {
  FastestRoutes routes(maze.size(), model.tables);
  routes.fill(maze.open_walls(), maze.goals());
  DriveRoute route;
  routes.route_from({maze.start(), maze.start_heading()}, route);
  return route;
}

/// Each segment begins where the one before it ends, in its direction, and the last one ends in the middle of its cell.
void expect_joined(const DriveRoute& route, const DriveModel& model) {
  constexpr double near = 1e-9;  // cells
  const double cell = model.tables.cell;
  std::optional<DriveSpot> before;
  for (std::size_t i = 0; i < route.segments.size(); ++i) {
    const DriveProfile profile(model, route, i);
    const DriveSpot begin = profile.spot(0.0);
    if (before) {
      EXPECT_LT(std::hypot(begin.x - before->x, begin.y - before->y) / cell, near) << "segment " << i;
      EXPECT_LT(std::abs(std::remainder(begin.angle - before->angle, 2.0 * std::numbers::pi)), near) << "segment " << i;
    }
    before = profile.spot(profile.length());
  }
  if (!before) return;
  const HalfPoint end = half_point(route.segments.back().to);
  EXPECT_LT(std::hypot(before->x / cell - end.x / 2.0, before->y / cell - end.y / 2.0), near);
}

TEST(DriveDrawing, JoinsTheSegmentsOfRoutesInRealMazes) {
  const auto files = test::maze_files();
  if (files.empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  for (const char* robot : {"mm2021", "classic", "half", "kerise", "beginner"}) {
    const auto model = test::drive_model(robot);
    for (std::size_t i = 0; i < files.size(); i += test::slowness)
      if (const auto maze = test::maze_in_file(files[i]);
          maze && maze->size().width <= max_drive_side && maze->size().height <= max_drive_side) {
        SCOPED_TRACE(files[i]);
        expect_joined(fastest_route(*maze, *model), *model);
        if (HasFailure()) return;
      }
  }
}

TEST(DriveDrawing, JoinsTheSegmentsOfRoutesInMazesByDice) {
  const auto model = test::drive_model("classic");
  Rng rng(21);
  for (int i = 0; i < test::some_of(200); ++i) {
    SCOPED_TRACE(i);
    expect_joined(fastest_route(test::any_maze(rng, 12), *model), *model);
    if (HasFailure()) return;
  }
}

TEST(DriveDrawing, OfARouteIsAPictureWithALegend) {
  const auto model = test::drive_model("mm2021");
  const Maze maze = test::ring();
  const std::string svg = draw_route(maze, fastest_route(maze, *model), *model, "a <ring>");
  EXPECT_EQ(XmlScanner(svg).complaint(), "");
  EXPECT_THAT(svg, HasSubstr("<title>a &lt;ring&gt;</title>"));
  EXPECT_THAT(svg, HasSubstr(" m/s</text>"));
  EXPECT_THAT(svg, HasSubstr("stroke-speed7"));
  EXPECT_THAT(svg, Not(HasSubstr("searching")));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(DriveDrawing, OfAContestShowsItsSearch) {
  const std::string svg = draw_contest(test::driven("flood"));
  EXPECT_EQ(XmlScanner(svg).complaint(), "");
  EXPECT_THAT(svg, HasSubstr("<title>flood in ring: "));
  EXPECT_THAT(svg, HasSubstr("searching"));
  EXPECT_THAT(svg, HasSubstr("stroke-speed1"));
}

TEST(DriveDrawing, TakesContestsWithoutASpeedRun) {
  DriveRecordFile file = test::driven("flood");
  file.record.runs.resize(1);
  file.record.outcome = DriveOutcome::out_of_time;
  EXPECT_THAT(draw_contest(file), HasSubstr("searching"));
  file.record.runs.clear();
  EXPECT_THAT(draw_contest(file), HasSubstr("out of time</title>"));
}

}  // namespace
}  // namespace labmouse
