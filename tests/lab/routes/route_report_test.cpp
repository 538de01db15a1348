#include "labmouse/lab/routes/route_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::HasSubstr;

const DriveModel& mm2021() {
  static const DriveModel model = find_robot("mm2021").model;
  return model;
}

RouteReport report_of(std::string_view drawing) { return route_report(test::drawn(drawing), mm2021()); }

constexpr std::string_view corner = R"(
    o---o---o
    |     G |
    o   o---o
    | S |   |
    o---o---o
)";

TEST(RouteReport, OfACornerIsOneTurn) {
  const RouteReport report = report_of(corner);
  EXPECT_EQ(notation_of(report.route, mm2021().tables), "R90");
  EXPECT_EQ(report.route.time, 375'000);
  EXPECT_EQ(report.cells, 2);
  EXPECT_EQ(report.fewest_cells, 2);
  EXPECT_EQ(report.fewest_cells_time, 375'000);
  // S1 RS90 S1: 45 mm from 420 mm/s to 420 mm/s at 4,200 mm/s² take 2 (sqrt(420² + 4,200 · 45) - 420) / 4,200 s.
  EXPECT_EQ(report.small_turns, 2 * 87'849 + 287'500);
  EXPECT_NEAR(*report.gain_over(report.small_turns), 1.0 - 375'000.0 / 463'198.0, 1e-12);
  // Half a cell before the gate of the start, and half a cell behind that of the goal.
  EXPECT_GT(report.gate_to_gate, 100'000);
  EXPECT_LT(report.gate_to_gate, 275'000);
}

TEST(RouteReport, NamesAllPieces) {
  const RouteReport report = report_of(R"(
      o---o---o---o---o
      |         G |   |
      o   o---o---o---o
      |           |   |
      o---o---o   o---o
      |           |   |
      o   o---o---o---o
      | S |   |   |   |
      o---o---o---o---o
  )");
  EXPECT_EQ(notation_of(report.route, mm2021().tables), "R90 L180 R180 S2");
  EXPECT_EQ(report.cells, 9);
}

TEST(RouteReport, LeavesStraightsOutThatAreOnlyLeads) {
  const DriveTables& tables = mm2021().tables;
  DriveRoute route;
  const DriveNode centre = {{0, 0}, Heading::north, Place::centre}, edge = {{0, 0}, Heading::north, Place::right};
  route.segments.push_back({DriveSegment::Kind::straight, centre, centre, 0, 1000, 0, 0, false});
  route.segments.push_back({DriveSegment::Kind::turn, centre, edge, 1000, 2000, 0, 0, false});
  route.segments.push_back({DriveSegment::Kind::straight, edge, edge, 2000, 3000, 4, 0, false});
  EXPECT_EQ(notation_of(route, tables), "R45 D4");
  EXPECT_EQ(notation_of(route.segments[0], tables), "S0");
}

TEST(RouteReport, SaysWhyThereIsNoRoute) {
  EXPECT_THAT(route_report(Maze(MazeDraft({33, 2}, MazeDraft::Inside::open)), mm2021()).error, Says("33x2", "32x32"));
  const RouteReport closed = report_of(R"(
      o---o---o
      | S   G |
      o---o---o
  )");
  EXPECT_THAT(closed.error, Says("no route", "north", "start (0,0)"));
}

TEST(RouteReport, OfAStartInAGoalTakesNoTime) {
  MazeDraft draft({2, 2}, MazeDraft::Inside::open);
  draft.add_goal({0, 0});
  const RouteReport report = route_report(Maze(draft), mm2021());
  EXPECT_EQ(report.error, "");
  EXPECT_EQ(report.route.time, 0);
  EXPECT_EQ(report.gate_to_gate, 0);
  EXPECT_EQ(report.gain_over(report.small_turns), std::nullopt);
  EXPECT_THAT(table_of(report, {"here", Maze(draft)}, mm2021()), HasSubstr("\n0.000 s from "));
}

/// The fastest of all routes of the fewest cells, each by itself.
class EveryShortestWay {
 public:
  EveryShortestWay(const Maze& maze, const DriveModel& model, int fewest)
      : maze_(maze), routes_(maze.size(), model.tables), fewest_(fewest) {
    go(maze.start(), {}, 0);
  }
  DriveTime best = no_time;

 private:
  void go(Cell cell, const WallSet& passages, int cells) {
    if (cells == fewest_ && maze_.is_goal(cell)) {
      routes_.fill(passages, maze_.goals());
      best = std::min(best, routes_.time_from({maze_.start(), maze_.start_heading()}));
    }
    if (cells == fewest_) return;
    for (const Heading heading : all_headings) {
      if (!maze_.is_open(cell, heading)) continue;
      WallSet more = passages;
      more.insert(wall_at(cell, heading));
      go(neighbour(cell, heading), more, cells + 1);
    }
  }

  const Maze& maze_;
  FastestRoutes routes_;
  int fewest_;
};

TEST(RouteReport, FindsTheFastestRouteOfTheFewestCells) {
  LABMOUSE_SKIP_SANITIZED();
  Rng rng(3);
  int known = 0;
  for (int i = 0; i < test::fewer(200); ++i) {
    SCOPED_TRACE(i);
    const Maze maze = test::any_maze(rng, 6);
    const RouteReport report = route_report(maze, mm2021());
    if (!report.error.empty() || report.fewest_cells > 9) continue;
    EXPECT_GE(report.cells, report.fewest_cells);
    if (report.route.time == 0 || !report.fewest_cells_time) continue;
    ++known;
    EXPECT_EQ(*report.fewest_cells_time, EveryShortestWay(maze, mm2021(), report.fewest_cells).best);
  }
  EXPECT_GT(known, test::fewer(50));
}

TEST(RouteReport, IsATable) {
  const NamedMaze maze = {"corner", test::drawn(corner)};
  const std::string table = table_of(route_report(maze.maze, mm2021()), maze, mm2021());
  EXPECT_THAT(table, Says("corner: ", "mm2021", "90 mm\n"));
  EXPECT_THAT(table, HasSubstr("  1  R90    (0,0) N        (1,1) E            387   387    375.0    0.375\n"));
  EXPECT_THAT(table, Says("\nR90\n\n0.375 s ", "420 mm/s"));
  EXPECT_THAT(table, HasSubstr("\nwithout diagonals: 0.375 s, 0.0 % gained\nwith search turns (S90) only: 0.463 s, "
                               "19.0 % gained\nfewest cells: 2, as this route\n"));
}

TEST(RouteReport, SumsUpManyMazes) {
  const std::vector<NamedMaze> mazes = {{"corner", test::drawn(corner)},
                                        {"large", Maze(MazeDraft({33, 2}, MazeDraft::Inside::open))}};
  std::vector<RouteReport> reports;
  for (const NamedMaze& maze : mazes) reports.push_back(route_report(maze.maze, mm2021()));
  const std::string text = summary_of(reports, mazes, mm2021());
  EXPECT_THAT(text, HasSubstr("   0.375    0.375      0.0    0.463     19.0        2        2      0.0  corner\n"));
  EXPECT_THAT(text,
              HasSubstr("    none        -        -        -        -        -        -        -  large: is 33x2"));
  EXPECT_THAT(text,
              HasSubstr("   0.375    0.375      0.0    0.463     19.0        2        2        -  median of 1 maze\n"));
  EXPECT_THAT(text, HasSubstr("0 of them (0.0 %)"));
  const auto json = nlohmann::json::parse(json_of(reports, mazes, mm2021()));
  EXPECT_EQ(json["mazes"][0]["time_us"], 375'000);
  EXPECT_EQ(json["mazes"][0]["segments"][0]["piece"], "R90");
  EXPECT_EQ(json["mazes"][0]["segments"][0]["to"], nlohmann::json::parse(R"([1, 1, "east", "centre"])"));
  EXPECT_TRUE(json["mazes"][1].contains("error"));
}

}  // namespace
}  // namespace labmouse
