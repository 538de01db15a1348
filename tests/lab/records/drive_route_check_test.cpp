#include "labmouse/lab/records/drive_route_check.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "labmouse/mouse/drive/fastest.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using test::Says;
using test::SaysAt;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A route in a maze, by a robot.
struct Course {
  Maze maze;
  std::shared_ptr<const DriveModel> model;
  DriveRoute route{};

  const DriveTables& tables() const { return model->tables; }
  Pose start() const { return {maze.start(), maze.start_heading()}; }

  std::string checked_over(const WallSet& open) const {
    return check_route(route, start(), maze.size(), open, maze.goals(), *model);
  }
  std::string checked() const { return checked_over(maze.open_walls()); }
};

Course fastest(const Maze& maze, const std::string& robot) {
  Course course{maze, test::drive_model(robot)};
  FastestRoutes routes(maze.size(), course.tables());
  routes.fill(maze.open_walls(), maze.goals());
  routes.route_from(course.start(), course.route);
  return course;
}

/// By mm2021 S2 R90 R90; by classic, whose turns have leads, S2 R90 S0 R90 S0.
Course through_ring(const std::string& robot) {
  Course course = fastest(test::ring(), robot);
  EXPECT_EQ(course.route.segments.size(), robot == "classic" ? 5U : 3U);
  return course;
}

/// Nothing stands in it: the start is in the middle, and so is the goal.
Maze open_square(Heading heading) {
  return test::drawn(R"(
    o---o---o---o
    |           |
    o   o   o   o
    | G   S     |
    o   o   o   o
    |           |
    o---o---o---o
  )")
      .with_start({1, 1}, heading);
}

/// All in it is open, and the start is in the lower row: on the left, or on the right.
Maze hall(int start) {
  return test::drawn(R"(
    o---o---o
    |       |
    o   o   o
    | S   G |
    o---o---o
  )")
      .with_start({start, 0}, Heading::north);
}

void append(Course& course, DriveSegment segment, DriveTime time) {
  segment.begin = course.route.segments.empty() ? 0 : course.route.segments.back().end;
  segment.end = course.route.time = segment.begin + time;
  course.route.segments.push_back(segment);
}

void append_straight(Course& course, int units, const DriveNode& from, const DriveNode& to, DriveTime time) {
  DriveSegment segment;
  segment.from = from;
  segment.to = to;
  segment.units = units;
  append(course, segment, time);
}

void append_turn(Course& course, Turn turn, bool left, const DriveNode& from, const DriveNode& to) {
  const auto& turns = course.tables().turns;
  const auto found =
      std::find_if(turns.begin(), turns.end(), [&](const DrivenTurn& each) { return each.turn == turn; });
  DriveSegment segment;
  segment.kind = DriveSegment::Kind::turn;
  segment.from = from;
  segment.to = to;
  segment.turn = static_cast<std::uint16_t>(found - turns.begin());
  segment.left = left;
  append(course, segment, found->time);
}

/// Moves all segments from that one on by so much.
void move_on(DriveRoute& route, std::size_t first, DriveTime by) {
  for (std::size_t i = first; i < route.segments.size(); ++i) {
    route.segments[i].begin += by;
    route.segments[i].end += by;
  }
  route.time += by;
}

/// Leaves one segment out, and its time.
void leave_out(DriveRoute& route, std::size_t index) {
  const DriveTime time = route.segments[index].end - route.segments[index].begin;
  route.segments.erase(route.segments.begin() + static_cast<std::ptrdiff_t>(index));
  move_on(route, index, -time);
}

TEST(DriveRouteCheck, AgreesWithTheFastestRoutes) {
  Rng rng(23);
  int driven = 0;
  for (const char* robot : {"mm2021", "classic", "kerise", "beginner"})
    for (int i = 0; i < test::fewer(40); ++i) {
      const Course course = fastest(test::any_maze(rng, 9), robot);
      if (course.route.time == no_time) continue;
      EXPECT_EQ(course.checked(), "") << test::drawing_of(course.maze);
      driven += course.route.segments.empty() ? 0 : 1;
    }
  EXPECT_GT(driven, test::fewer(10));
}

TEST(DriveRouteCheck, KnowsTheTimeOfEachSegmentToTheMicrosecond) {
  Rng rng(29);
  for (const char* robot : {"mm2021", "classic", "kerise", "beginner"})
    for (int i = 0; i < test::fewer(15); ++i) {
      const Course course = fastest(test::any_maze(rng, 9), robot);
      for (std::size_t segment = 0; segment < course.route.segments.size(); ++segment)
        for (const DriveTime by : {-1, 1}) {
          Course changed = course;
          move_on(changed.route, segment + 1, by);
          changed.route.segments[segment].end += by;
          EXPECT_THAT(changed.checked(), StartsWith("segment " + std::to_string(segment + 1) + " ("));
          EXPECT_THAT(changed.checked(), HasSubstr("): recorded "));
        }
    }
}

TEST(DriveRouteCheck, TellsBothTimes) {
  Course course = through_ring("mm2021");
  course.route.segments[1].end += 1;
  EXPECT_THAT(course.checked(), SaysAt("segment 2 (R90)", "0.375001 s", "0.375000 s"));
}

// The words by which the reasons differ.
constexpr const char* ends_elsewhere = "centre of a goal";
constexpr const char* leads_out = "leaves the maze";
constexpr const char* leads_elsewhere = "recorded end";
constexpr const char* no_begin = "not begin there";
constexpr const char* cannot_begin = "cannot begin";

TEST(DriveRouteCheck, WantsAGoalAtTheEnd) {
  Course course = through_ring("mm2021");
  course.maze = course.maze.with_goals(CellSet::of({2, 2}));
  EXPECT_THAT(course.checked(), HasSubstr(ends_elsewhere));
  // Nor in the middle of a cell: on the far edge of the goal.
  Course edge{open_square(Heading::west), test::drive_model("mm2021")};
  const DriveNode middle = {{1, 1}, Heading::west, Place::centre}, border = {{1, 1}, Heading::west, Place::edge};
  append_straight(edge, 1, middle, border, edge.tables().whole[1]);
  edge.maze = edge.maze.with_goals(CellSet::of({1, 1}));
  EXPECT_THAT(edge.checked(), HasSubstr(ends_elsewhere));
}

TEST(DriveRouteCheck, TakesNoRouteAtAllFromAGoalOnly) {
  Course course{test::ring(), test::drive_model("mm2021")};
  course.route.time = 0;
  EXPECT_THAT(course.checked(), HasSubstr(ends_elsewhere));
  course.maze = course.maze.with_goals(CellSet::of(course.maze.start()));
  EXPECT_EQ(course.checked(), "");
}

TEST(DriveRouteCheck, WantsTheWallsOfTheRouteToBeKnownAndNoOthers) {
  const Course course = through_ring("mm2021");
  const WallSet passed = walls_needed_by(course.route, course.tables());
  EXPECT_EQ(course.checked_over(passed), "");
  EXPECT_EQ(passed.count(), 5);
  passed.for_each([&](Wall wall) {
    WallSet open = course.maze.open_walls();
    open.erase(wall);
    EXPECT_THAT(course.checked_over(open),
                Says(fmt::format("{} side of ({},{})", name_of(wall.side), wall.cell.x, wall.cell.y), "open"));
  });
}

TEST(DriveRouteCheck, KeepsStraightsInTheMaze) {
  for (const Heading heading : all_headings) {
    SCOPED_TRACE(name_of(heading));
    Course course{open_square(heading), test::drive_model("mm2021")};
    const Cell last = neighbour(Cell{1, 1}, heading), outside = neighbour(last, heading);
    const DriveNode from = {{1, 1}, heading, Place::centre};
    // To the goal next to the border; onto the border, and behind it.
    course.maze = course.maze.with_goals(CellSet::of(last));
    append_straight(course, 2, from, {last, heading, Place::centre}, course.tables().whole[2]);
    EXPECT_EQ(course.checked(), "");
    course.route = {};
    append_straight(course, 3, from, {last, heading, Place::edge}, course.tables().whole[3]);
    EXPECT_THAT(course.checked(), SaysAt("segment 1 (S3)", leads_out));
    course.route = {};
    append_straight(course, 4, from, {outside, heading, Place::centre}, course.tables().whole[4]);
    EXPECT_THAT(course.checked(), SaysAt("segment 1 (S4)", leads_out));
  }
}

TEST(DriveRouteCheck, KeepsTurnsInTheMazeBetweenTheirEnds) {
  Course course{hall(0), test::drive_model("mm2021")};
  append_turn(course, Turn::f180, false, {{0, 0}, Heading::north, Place::centre},
              {{1, 0}, Heading::south, Place::centre});
  EXPECT_EQ(course.checked(), "");
  // One row higher both of its ends are inside, and its bend is not.
  course.maze = course.maze.with_start({0, 1}, Heading::north).with_goals(CellSet::of({1, 1}));
  course.route = {};
  append_turn(course, Turn::f180, false, {{0, 1}, Heading::north, Place::centre},
              {{1, 1}, Heading::south, Place::centre});
  EXPECT_THAT(course.checked(), SaysAt("segment 1 (R180)", leads_out));
}

TEST(DriveRouteCheck, WantsTheHeadingAtTheEndOfASegment) {
  Course course = through_ring("mm2021");
  course.route.segments[0].to.heading = Heading::east;
  EXPECT_THAT(course.checked(), SaysAt("segment 1 (S2)", leads_elsewhere));
  course = through_ring("mm2021");
  course.route.segments[1].to.heading = Heading::south;
  EXPECT_THAT(course.checked(), SaysAt("segment 2 (R90)", leads_elsewhere));
}

/// What is said of a turn right behind the first segment, or as the first one.
std::string said_of(Course course, Turn turn, bool left) {
  const auto& segments = course.route.segments;
  const DriveNode start = {course.maze.start(), course.maze.start_heading(), Place::centre};
  const DriveNode from = segments.empty() ? start : segments.back().to;
  append_turn(course, turn, left, from, from);
  return course.checked();
}

TEST(DriveRouteCheck, LetsNoTurnBeginAtTheMiddleOfACellThatBeginsElsewhere) {
  const Course course{hall(0), test::drive_model("mm2021")};
  for (const bool left : {false, true}) {
    for (const Turn turn : {Turn::s90, Turn::v90, Turn::out45, Turn::out135})
      EXPECT_THAT(said_of(course, turn, left), HasSubstr(no_begin)) << name_of(turn);
    for (const Turn turn : {Turn::f45, Turn::f90, Turn::f135, Turn::f180})
      EXPECT_THAT(said_of(course, turn, left), HasSubstr(leads_elsewhere)) << name_of(turn);
  }
  EXPECT_THAT(said_of(course, Turn::s90, false), SaysAt("segment 1 (RS90)", no_begin));
}

TEST(DriveRouteCheck, LetsOnlyTheSmallTurnBeginAtAnEdge) {
  Course course{hall(0), test::drive_model("mm2021")};
  append_straight(course, 1, {{0, 0}, Heading::north, Place::centre}, {{0, 0}, Heading::north, Place::edge},
                  course.tables().start_to(1, 0));
  for (const Turn turn : {Turn::f45, Turn::f90, Turn::f135, Turn::f180})
    EXPECT_THAT(said_of(course, turn, false), HasSubstr(no_begin)) << name_of(turn);
  EXPECT_THAT(said_of(course, Turn::s90, false), SaysAt("segment 2 (RS90)", leads_elsewhere));
}

TEST(DriveRouteCheck, LetsTurnsFromADiagonalToADiagonalBeginOnOneSideOnly) {
  for (const bool left : {false, true}) {
    // Onto the wall between the upper cells, by a turn to the right from the left, or the other way round.
    Course course{hall(left ? 1 : 0), test::drive_model("mm2021")};
    const DriveNode diagonal = {
        {left ? 1 : 0, 1}, left ? Heading::west : Heading::east, left ? Place::right : Place::left};
    append_turn(course, Turn::f45, left, {course.maze.start(), Heading::north, Place::centre}, diagonal);
    // It goes on to the side that it did not come to.
    EXPECT_THAT(said_of(course, Turn::v90, left), HasSubstr(no_begin)) << left;
    EXPECT_THAT(said_of(course, Turn::v90, !left), HasSubstr(leads_elsewhere)) << left;
    for (const Turn turn : {Turn::f45, Turn::f90, Turn::f135, Turn::f180, Turn::s90})
      EXPECT_THAT(said_of(course, turn, left), HasSubstr(no_begin)) << name_of(turn);
    for (const Turn turn : {Turn::out45, Turn::out135})
      EXPECT_THAT(said_of(course, turn, left), HasSubstr(leads_elsewhere)) << name_of(turn);
  }
}

TEST(DriveRouteCheck, WantsSegmentsToJoin) {
  Course course = through_ring("mm2021");
  course.route.segments[1].from.cell = {0, 2};
  EXPECT_THAT(course.checked(), SaysAt("segment 2 (R90)", "begin where"));
  course = through_ring("mm2021");
  course.maze = course.maze.with_start({0, 0}, Heading::east);
  EXPECT_THAT(course.checked(), SaysAt("segment 1 (S2)", "begin where"));
  course = through_ring("mm2021");
  move_on(course.route, 1, 1);
  EXPECT_THAT(course.checked(), SaysAt("segment 2 (R90)", "begin when"));
  course = through_ring("mm2021");
  move_on(course.route, 0, 1);
  EXPECT_THAT(course.checked(), SaysAt("segment 1 (S2)", "begin when"));
}

TEST(DriveRouteCheck, TakesOneStraightForTwo) {
  Course course{open_square(Heading::west), test::drive_model("mm2021")};
  const DriveNode from = {{1, 1}, Heading::west, Place::centre}, to = {{0, 1}, Heading::west, Place::centre};
  const DriveNode between = {{1, 1}, Heading::west, Place::edge};
  append_straight(course, 2, from, to, course.tables().whole[2]);
  EXPECT_EQ(course.checked(), "");
  course.route = {};
  append_straight(course, 1, from, between, course.tables().whole[1]);
  append_straight(course, 1, between, to, course.tables().whole[1]);
  EXPECT_THAT(course.checked(), SaysAt("segment 2 (S1)", "another straight"));
}

TEST(DriveRouteCheck, LetsATurnWithALeadBeginBehindAStraightOnly) {
  // Without the straight of no length between two turns.
  Course course = through_ring("classic");
  EXPECT_EQ(course.checked(), "");
  leave_out(course.route, 2);
  EXPECT_THAT(course.checked(), SaysAt("segment 3 (R90)", cannot_begin));
  // Nor from rest.
  course = through_ring("classic");
  course.maze = course.maze.with_start({0, 1}, Heading::north);
  leave_out(course.route, 0);
  EXPECT_THAT(course.checked(), SaysAt("segment 1 (R90)", cannot_begin));
  // Turns without leads follow each other, and begin a route.
  Course fixed = through_ring("mm2021");
  fixed.maze = fixed.maze.with_start({0, 1}, Heading::north);
  leave_out(fixed.route, 0);
  EXPECT_EQ(fixed.checked(), "");
}

TEST(DriveRouteCheck, WantsTheLeadOfTheLastTurn) {
  Course course = through_ring("classic");
  leave_out(course.route, 4);
  EXPECT_THAT(course.checked(), Says("route ends", "turn"));
}

TEST(DriveRouteCheck, LetsNoSpeedChangeAtOnce) {
  Course course = through_ring("classic");
  const auto& turns = course.tables().turns;
  // The second corner is taken as slowly as the robot can; nothing is left to brake on before it.
  DriveSegment& corner = course.route.segments[3];
  ASSERT_EQ(turns[corner.turn].turn, Turn::f90);
  ASSERT_EQ(turns[corner.turn + 1U].turn, Turn::f90);
  ASSERT_LT(turns[corner.turn + 1U].speed, turns[corner.turn].speed);
  corner.turn = static_cast<std::uint16_t>(corner.turn + 1);
  EXPECT_THAT(course.checked(), SaysAt("segment 3 (S0)", "change its speed"));
}

}  // namespace
}  // namespace labmouse
