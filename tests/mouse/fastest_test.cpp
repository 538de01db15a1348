// The planner of the world in seconds against the plain search from coordinates: every time at every node, and the
// routes.
#include "labmouse/mouse/drive/fastest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "labmouse/lab/robots/robot_files.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/mouse/plain_fastest.hpp"
#include "tests/mouse/robot_parameters.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using test::PrintRobot;

/// As test::slowness. The plain planner takes long.
const int rarely = test::slowness == 1 ? 1 : 2 * test::slowness;

struct NamedRobot {
  const char* name;
  Robot (*make)();
  int every = 1;  ///< so many-th of the mazes
};

Pose start_of(const Maze& maze) { return {maze.start(), maze.start_heading()}; }

bool fits(const Maze& maze) { return maze.size().width <= max_drive_side && maze.size().height <= max_drive_side; }

/// Every time at every node where a turn can end, and the time from the start.
void expect_same_times(const FastestRoutes& routes, const test::PlainFastest& plain, const Maze& maze,
                       const DriveTables& tables) {
  for (int index = 0; index < maze.size().area(); ++index)
    for (const Heading heading : all_headings)
      for (const Place place : all_places) {
        const DriveNode node = {maze.size().cell_at(index), heading, place};
        for (std::size_t lane = 0; lane < (node.diagonal() ? tables.diagonal : tables.along).count(); ++lane) {
          if (!plain.turn_ends(node, lane)) continue;
          ASSERT_EQ(routes.rolling(node, lane), plain.rolling(node, lane))
              << "at (" << int{node.cell.x} << "," << int{node.cell.y} << ") " << name_of(heading) << " "
              << name_of(place) << " lane " << lane;
        }
      }
  EXPECT_EQ(routes.time_from(start_of(maze)), plain.time_from(start_of(maze)));
}

/// From several starts, in turn: the search for one of them finds the same route as the one for all nodes.
void expect_same_routes(FastestRoutes& some, const FastestRoutes& all, const Maze& maze, Rng& rng) {
  for (int i = 0; i < 3; ++i) {
    Pose start = start_of(maze);
    if (i > 0) start.cell = maze.size().cell_at(rng.below(maze.size().area()));
    if (i > 0) start.heading = all_headings[static_cast<std::size_t>(rng.below(4))];
    DriveRoute one, other;
    some.fill_for(start, maze.open_walls(), maze.goals());
    some.route_from(start, one);
    all.route_from(start, other);
    ASSERT_EQ(one, other) << "from (" << int{start.cell.x} << "," << int{start.cell.y} << ") "
                          << name_of(start.heading);
  }
}

/// A route hangs together, its times add up, and it can be driven where the walls that it passes are open, and only
/// there.
void expect_good_route(FastestRoutes& routes, const DriveTables& tables, const Maze& maze) {
  DriveRoute route;
  routes.route_from(start_of(maze), route);
  ASSERT_EQ(route.time, routes.time_from(start_of(maze)));
  if (route.time == no_time || route.time == 0) {
    EXPECT_TRUE(route.segments.empty());
    return;
  }
  EXPECT_EQ(route.segments.front().from, (DriveNode{maze.start(), maze.start_heading(), Place::centre}));
  EXPECT_TRUE(maze.is_goal(route.segments.back().to.cell));
  EXPECT_EQ(route.segments.back().to.place, Place::centre);
  EXPECT_EQ(route.segments.back().end, route.time);
  DriveTime clock = 0;
  for (std::size_t i = 0; i < route.segments.size(); ++i) {
    EXPECT_EQ(route.segments[i].begin, clock);
    if (i > 0) {
      EXPECT_EQ(route.segments[i].from, route.segments[i - 1].to);
    }
    clock = route.segments[i].end;
  }
  const WallSet walls = walls_needed_by(route, tables);
  walls.for_each([&](Wall wall) { EXPECT_TRUE(maze.open_walls().contains(wall)); });
  routes.fill(walls, maze.goals());
  EXPECT_EQ(routes.time_from(start_of(maze)), route.time);
}

class AnyRobot : public testing::TestWithParam<NamedRobot> {
 protected:
  AnyRobot() : model_(make_drive_model(GetParam().make())) { EXPECT_EQ(model_.error, ""); }

  void expect_exact(const Maze& maze) {
    FastestRoutes routes(maze.size(), model_.tables);
    routes.fill(maze.open_walls(), maze.goals());
    const test::PlainFastest plain(maze.size(), model_.tables, maze.open_walls(), maze.goals());
    expect_same_times(routes, plain, maze, model_.tables);
    FastestRoutes& some =
        some_.try_emplace({maze.size().width, maze.size().height}, maze.size(), model_.tables).first->second;
    expect_same_routes(some, routes, maze, rng_);
    expect_good_route(routes, model_.tables, maze);
  }

  DriveModel model_;
  Rng rng_{6};
  /// By size: for one start after another.
  std::map<std::pair<int, int>, FastestRoutes> some_;
};

TEST_P(AnyRobot, IsPlannedForExactlyInEmptyMazes) {
  for (const Size size : {Size{1, 1}, Size{2, 2}, Size{3, 7}, Size{16, 16}, Size{17, 5}, Size{32, 32}})
    if (test::slowness == 1 || size.area() < (test::sanitized ? 200 : 1000))
      expect_exact(Maze(MazeDraft(size, MazeDraft::Inside::open)));
}

TEST_P(AnyRobot, IsPlannedForExactlyInMazesByDice) {
  LABMOUSE_SKIP_SANITIZED();
  Rng rng(7);
  for (int i = 0; i < std::max(1, 2000 / rarely); i += GetParam().every) {
    SCOPED_TRACE(i);
    expect_exact(test::any_maze(rng, i % 10 == 0 ? 32 : 14));
    if (HasFailure()) return;
  }
}

TEST_P(AnyRobot, IsPlannedForExactlyInRealMazes) {
  const auto files = test::maze_files();
  if (files.empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  for (std::size_t i = 0; i < files.size(); i += static_cast<std::size_t>(rarely * GetParam().every))
    if (const auto maze = test::maze_in_file(files[i]); maze && fits(*maze)) {
      SCOPED_TRACE(files[i]);
      expect_exact(*maze);
    }
}

Robot mm2021() { return find_robot("mm2021").robot; }
Robot classic() { return find_robot("classic").robot; }
Robot half() { return find_robot("half").robot; }
Robot kerise() { return find_robot("kerise").robot; }
Robot beginner() { return find_robot("beginner").robot; }

INSTANTIATE_TEST_SUITE_P(
    Robots, AnyRobot,
    testing::Values(NamedRobot{"mm2021", mm2021}, NamedRobot{"half", half, 2}, NamedRobot{"classic", classic, 2},
                    NamedRobot{"fan", fan_robot, 4}, NamedRobot{"weak_brakes", weak_brakes, 4},
                    NamedRobot{"kerise", kerise}, NamedRobot{"beginner", beginner, 4},
                    NamedRobot{"slow", slow_robot, 4}, NamedRobot{"strong", strong_robot, 4},
                    NamedRobot{"unstopped", unstopped_robot, 8}, NamedRobot{"grip", grip_robot, 8},
                    NamedRobot{"small_grip", small_grip_robot, 8}, NamedRobot{"speeds_1", robot_of_speeds<1>, 2},
                    NamedRobot{"speeds_2", robot_of_speeds<2>, 8}, NamedRobot{"speeds_4", robot_of_speeds<4>, 8},
                    NamedRobot{"speeds_8", robot_of_speeds<8>, 8}, NamedRobot{"large_jerk", large_jerk_robot, 16},
                    NamedRobot{"weak", weak_robot, 16}, NamedRobot{"choosy", choosy_robot, 16}),
    PrintRobot());

/// The search must not lean on how the times of a robot come about.
DriveTables shaken(DriveTables tables, Rng& rng) {
  const bool gaps = rng.chance(1, 3);
  const auto shake = [&](std::vector<DriveTime>& times) {
    for (DriveTime& time : times)
      if (time < no_time)
        time = gaps && rng.chance(1, 50) ? no_time : time / 100 * (80 + rng.below(40)) + rng.below(100);
  };
  for (auto* times : {&tables.along.between, &tables.diagonal.between, &tables.start, &tables.finish, &tables.whole})
    shake(*times);
  for (DrivenTurn& turn : tables.turns) {
    turn.time = turn.time / 100 * (20 + rng.below(180)) + 1'000;
    if (turn.turn != Turn::v90) continue;
    turn.from = static_cast<std::uint8_t>(rng.below(static_cast<int>(tables.diagonal.count())));
    turn.to = static_cast<std::uint8_t>(rng.below(static_cast<int>(tables.diagonal.count())));
  }
  return tables;
}

TEST(ShakenTables, ArePlannedForExactly) {
  Rng rng(10);
  const DriveModel model = make_drive_model(large_robot());
  for (int i = 0; i < std::max(1, 300 / rarely); ++i) {
    SCOPED_TRACE(i);
    const DriveTables tables = shaken(model.tables, rng);
    const Maze maze = i % 10 == 0 ? Maze(MazeDraft({9, 9}, MazeDraft::Inside::open)) : test::any_maze(rng, 14);
    FastestRoutes routes(maze.size(), tables), some(maze.size(), tables);
    routes.fill(maze.open_walls(), maze.goals());
    expect_same_times(routes, test::PlainFastest(maze.size(), tables, maze.open_walls(), maze.goals()), maze, tables);
    expect_same_routes(some, routes, maze, rng);
    if (testing::Test::HasFailure()) return;
  }
}

/// Times of a few units each: where all of them count, and many are equal.
DriveTables coarse(DriveTables tables) {
  const auto round_up = [](DriveTime& time) { time = time < no_time ? (time + 49'999) / 50'000 : no_time; };
  for (auto* times : {&tables.along.between, &tables.diagonal.between, &tables.start, &tables.finish, &tables.whole})
    std::for_each(times->begin(), times->end(), round_up);
  for (DrivenTurn& turn : tables.turns) round_up(turn.time);
  return tables;
}

TEST(CoarseTimes, ArePlannedForExactly) {
  LABMOUSE_SKIP_SANITIZED();
  Rng rng(12);
  for (const Robot& robot : {published_robot(), small_robot(), large_robot()}) {
    const DriveTables tables = coarse(make_drive_model(robot).tables);
    for (int i = 0; i < std::max(1, 1000 / rarely); ++i) {
      SCOPED_TRACE(i);
      const Maze maze = test::any_maze(rng, 14);
      FastestRoutes routes(maze.size(), tables), some(maze.size(), tables);
      routes.fill(maze.open_walls(), maze.goals());
      expect_same_times(routes, test::PlainFastest(maze.size(), tables, maze.open_walls(), maze.goals()), maze, tables);
      expect_same_routes(some, routes, maze, rng);
      if (testing::Test::HasFailure()) return;
    }
  }
}

/// Turns that last far less than a straight, or far more: all that a search may wait for lies near, or far.
TEST(OddTurns, ArePlannedForExactly) {
  Rng rng(11);
  for (const DriveTime time : {1'000, 20'000, 5'000'000}) {
    Robot robot = published_robot();
    robot.fixed = FixedTimes{200.0, time, time + 300, time + 700, time + 900, time + 500, std::min(time, 400'000)};
    const DriveModel model = make_drive_model(robot);
    ASSERT_EQ(model.error, "");
    for (int i = 0; i < std::max(1, 100 / rarely); ++i) {
      SCOPED_TRACE(i);
      const Maze maze = test::any_maze(rng, i % 10 == 0 ? 32 : 14);
      FastestRoutes routes(maze.size(), model.tables), some(maze.size(), model.tables);
      routes.fill(maze.open_walls(), maze.goals());
      expect_same_times(routes, test::PlainFastest(maze.size(), model.tables, maze.open_walls(), maze.goals()), maze,
                        model.tables);
      expect_same_routes(some, routes, maze, rng);
      if (testing::Test::HasFailure()) return;
    }
  }
}

/// The same tables with every lane twice.
StraightTimes doubled(const StraightTimes& table) {
  StraightTimes twice;
  twice.lanes = {table.lanes[0], table.lanes[0]};
  for (const DriveTime time : table.between) twice.between.insert(twice.between.end(), 4, time);
  return twice;
}

TEST(EqualSpeeds, InManyLanesAreAsOneSpeed) {
  const DriveModel model = make_drive_model(published_robot());
  DriveTables many = model.tables;
  many.along = doubled(model.tables.along);
  many.diagonal = doubled(model.tables.diagonal);
  for (auto* times : {&many.start, &many.finish}) {
    std::vector<DriveTime> twice;
    for (const DriveTime time : *times) twice.insert(twice.end(), 2, time);
    *times = twice;
  }
  Rng rng(8);
  for (int i = 0; i < std::max(1, 200 / rarely); ++i) {
    const Maze maze = test::any_maze(rng, 32);
    FastestRoutes one(maze.size(), model.tables), lanes(maze.size(), many);
    one.fill(maze.open_walls(), maze.goals());
    lanes.fill(maze.open_walls(), maze.goals());
    ASSERT_EQ(one.time_from(start_of(maze)), lanes.time_from(start_of(maze))) << i;
    DriveRoute first, second;
    one.route_from(start_of(maze), first);
    lanes.route_from(start_of(maze), second);
    ASSERT_EQ(first.segments, second.segments) << i;
  }
}

/// A robot need not have all turns.
TEST(SomeTurns, ArePlannedForExactly) {
  for (const Robot& robot : {published_robot(), small_robot()}) {
    DriveModel model = make_drive_model(robot);
    std::erase_if(model.tables.turns, [](const DrivenTurn& turn) { return turn.turn != Turn::s90; });
    Rng rng(9);
    for (int i = 0; i < std::max(1, 100 / rarely); ++i) {
      SCOPED_TRACE(i);
      const Maze maze = test::any_maze(rng, 14);
      FastestRoutes routes(maze.size(), model.tables);
      routes.fill(maze.open_walls(), maze.goals());
      const test::PlainFastest plain(maze.size(), model.tables, maze.open_walls(), maze.goals());
      expect_same_times(routes, plain, maze, model.tables);
      expect_good_route(routes, model.tables, maze);
    }
  }
}

/// More starts than are kept, of mazes of several sizes.
TEST(FastestRoutes, AreTheSameByBoundsThatOthersFound) {
  for (const char* name : {"mm2021", "kerise"}) {
    Rng rng(23);
    DriveModel model = find_robot(name).model;
    share_route_tables(model);
    for (int i = 0; i < test::tenth(60); ++i) {
      const Maze maze = test::any_maze(rng, i % 10 == 0 ? 20 : 9);
      // The same starts again and again, and others.
      const int cell = rng.chance(2, 3) ? rng.below(std::min(3, maze.size().area())) : rng.below(maze.size().area());
      const Pose start = {maze.size().cell_at(cell), all_headings[static_cast<std::size_t>(rng.below(2))]};
      FastestRoutes sharing(maze.size(), route_tables_of(model)), alone(maze.size(), model.tables);
      sharing.fill_for(start, maze.open_walls(), maze.goals());
      alone.fill(maze.open_walls(), maze.goals());
      DriveRoute one, other;
      sharing.route_from(start, one);
      alone.route_from(start, other);
      ASSERT_EQ(one, other);
    }
  }
}

/// By the times over more passages, cut short anywhere, and with limits at and about the time of the route. Fills over
/// passages that are not among those come in between.
TEST(FastestRoutes, AreTheSameByBoundsOverMorePassages) {
  for (const char* name : {"mm2021", "kerise", "classic", "beginner"}) {
    Rng rng(24);
    DriveModel model = find_robot(name).model;
    share_route_tables(model);
    for (int i = 0; i < test::tenth(100); ++i) {
      SCOPED_TRACE(i);
      const Maze maze = test::any_maze(rng, i % 10 == 0 ? 20 : 9);
      const Pose start = {maze.size().cell_at(rng.below(maze.size().area())),
                          all_headings[static_cast<std::size_t>(rng.below(4))]};
      FastestRoutes aimed(maze.size(), route_tables_of(model)), alone(maze.size(), model.tables);
      alone.fill(maze.open_walls(), maze.goals());
      DriveRoute route, through_open, other;
      alone.route_from(start, route);
      alone.fill(WallSet::all(maze.size()), maze.goals());
      alone.route_from(start, through_open);
      WallSet more = maze.open_walls();
      WallSet::all(maze.size()).for_each([&](Wall wall) {
        if (rng.chance(1, 5)) more.insert(wall);
      });
      const auto part = [&](int percent) {
        return route.time < no_time ? static_cast<DriveTime>(std::int64_t{route.time} * percent / 100) : no_time;
      };
      aimed.aim(start, more, rng.chance(1, 4) ? no_time : part(rng.below(150)));
      for (const DriveTime limit : {no_time, route.time, part(130)}) {
        aimed.fill_for(start, maze.open_walls(), maze.goals(), limit);
        aimed.route_from(start, other);
        ASSERT_EQ(other, route);
        if (rng.chance(1, 2)) continue;
        aimed.fill_for(start, WallSet::all(maze.size()), maze.goals());
        aimed.route_from(start, other);
        ASSERT_EQ(other, through_open);
        if (rng.chance(1, 2)) aimed.aim(start, more, part(110));
      }
      if (route.time == 0) continue;
      aimed.fill_for(start, maze.open_walls(), maze.goals(), route.time - 1);
      EXPECT_GE(aimed.time_from(start), route.time);
    }
  }
}

TEST(FastestRoutes, DriveStraightDownACorridor) {
  MazeDraft draft({1, 4}, MazeDraft::Inside::open);
  draft.add_goal({0, 3});
  const Maze maze(draft);
  const DriveModel model = make_drive_model(published_robot());
  FastestRoutes routes(maze.size(), model.tables);
  routes.fill(maze.open_walls(), maze.goals());
  DriveRoute route;
  routes.route_from(start_of(maze), route);
  ASSERT_EQ(route.segments.size(), 1U);
  EXPECT_EQ(route.segments[0].units, 6);
  EXPECT_EQ(route.time, model.tables.along.at(6, 0, 0));
}

TEST(FastestRoutes, StandStillInAGoal) {
  MazeDraft draft({2, 2}, MazeDraft::Inside::open);
  draft.add_goal({0, 0});
  const Maze maze(draft);
  const DriveModel model = make_drive_model(published_robot());
  FastestRoutes routes(maze.size(), model.tables);
  routes.fill(maze.open_walls(), maze.goals());
  DriveRoute route;
  routes.route_from(start_of(maze), route);
  EXPECT_EQ(route.time, 0);
  EXPECT_TRUE(route.segments.empty());
}

/// Best times that were published for real mazes, with turns for searching in the same graph where that helps.
TEST(FastestRoutes, TakeThePublishedTimes) {
  const DriveModel model = make_drive_model(mm2021());
  int found = 0;
  for (const auto& file : test::maze_files()) {
    const std::string name = file.filename();
    const DriveTime expected = name == "87us1.txt"                       ? 10'423
                               : name == "alljapan-030-2009-exp-fin.txt" ? 8'623
                               : name == "alljapan-046-2025-exp-fin.txt" ? 6'701
                               : name == "alljapan-044-2023-exp-fin.txt" ? 6'560  // 6,588 without S90
                               : name == "alljapan-032-2011-exp-fin.txt" ? 6'662  // 6,675 without S90
                                                                         : 0;
    if (expected == 0) continue;
    ++found;
    const Maze maze = *test::maze_in_file(file);
    FastestRoutes routes(maze.size(), model.tables);
    routes.fill(maze.open_walls(), maze.goals());
    EXPECT_EQ((routes.time_from(start_of(maze)) + 500) / 1000, expected) << name;
  }
  if (found == 0) GTEST_SKIP() << "none of these mazes in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
}

}  // namespace
}  // namespace labmouse
