#include "labmouse/lab/bounds/drive_bound.hpp"

#include <gtest/gtest.h>

#include "labmouse/contest/drive_gates.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

const DriveModel& mm2021() {
  static const DriveModel model = find_robot("mm2021").model;
  return model;
}

DriveRules rules_of(int divisor, bool gate_to_gate) {
  DriveRules rules;
  rules.time_limit = 600'000'000;
  rules.maze_time_divisor = divisor;
  rules.gate_to_gate = gate_to_gate;
  return rules;
}

TEST(DriveBound, KnowsTheShortestSearch) {
  // Half a cell before the gate, then a cell, a corner, a cell, a corner; and half a cell passed behind it.
  EXPECT_EQ(shortest_search(test::ring(), rules_of(30, true), mm2021().search), 300'000 + 237'000 + 300'000 + 237'000);
  EXPECT_EQ(shortest_search(test::ring(), rules_of(30, false), mm2021().search), 300'000 + 1'074'000 + 150'000);
}

TEST(DriveBound, TakesTheSoonerMiddleOfTheGoal) {
  // Through it, or to rest in it: that can be the sooner one.
  SearchDrive search = mm2021().search;
  search.half_cell = 100'000;
  EXPECT_EQ(shortest_search(test::ring(), rules_of(30, false), search), 100'000 + 1'074'000 + 100'000);
  search.half_cell = 200'000;
  EXPECT_EQ(shortest_search(test::ring(), rules_of(30, false), search), 200'000 + 1'074'000 + 150'000);
}

TEST(DriveBound, KnowsTheShortestSearchHome) {
  // There; back, a corner, a cell, a corner, a cell; a stop in the middle and half a turn.
  const MazeTime there = 1'374'000, back = 3'000'000 + 237'000 + 300'000 + 237'000 + 300'000,
                 stop = 300'000 + 3'000'000;
  EXPECT_EQ(shortest_search_home(test::ring(), mm2021().search), there + back + stop);
}

TEST(DriveBound, DashesOnTheWayHomeAlone) {
  const Maze corridor = test::drawn(R"(
    o---o---o---o---o---o
    | S               G |
    o---o---o---o---o---o
  )");
  SearchDrive search = mm2021().search;
  const MazeTime there = 1'500'000 + 300'000 + 3 * 300'000, stop = 300'000 + 1'500'000;
  EXPECT_EQ(shortest_search_home(corridor, search), there + 3'000'000 + 3 * 300'000 + stop);
  for (std::size_t halves = 1; halves < search.onward.size(); ++halves)
    search.onward[halves] = 100'000 * static_cast<DriveTime>(halves);
  EXPECT_EQ(shortest_search(corridor, rules_of(30, true), search), 3 * 300'000);
  EXPECT_EQ(shortest_search_home(corridor, search), there + 3'000'000 + search.dash(3) + stop);
}

TEST(DriveBound, OfARunIsTheFastestRoute) {
  const DriveBound bound = drive_bound_of(test::ring(), rules_of(0, false), mm2021());
  ASSERT_TRUE(bound.fastest && bound.score);
  EXPECT_EQ(*bound.score, *bound.fastest);
  EXPECT_LT(*drive_bound_of(test::ring(), rules_of(0, true), mm2021()).score, *bound.score);
}

TEST(DriveBound, CanBeTheSearchItself) {
  EXPECT_EQ(drive_bound_of(test::ring(), rules_of(10, true), mm2021()).score, 1'074'000);
  // Where a thousandth counts, the speed run is worth its search: 8,748 ms in the maze count 8.748.
  const MazeTime run = *drive_bound_of(test::ring(), rules_of(0, true), mm2021()).score;
  EXPECT_EQ(drive_bound_of(test::ring(), rules_of(1000, true), mm2021()).score, run + 8'748);
}

TEST(DriveBound, TakesABonusOff) {
  DriveRules rules = rules_of(0, true);
  const MazeTime before = *drive_bound_of(test::ring(), rules, mm2021()).score;
  rules.untouched_bonus = 2'000;
  EXPECT_EQ(drive_bound_of(test::ring(), rules, mm2021()).score, before - 2'000);
}

/// The fastest run in the ring behind the shortest search and way home.
DriveRun run_in_ring() {
  const Maze maze = test::ring();
  FastestRoutes routes(maze.size(), mm2021().tables);
  routes.fill(maze.open_walls(), maze.goals());
  DriveRun run;
  run.begin = 8'748'000;
  routes.route_from({maze.start(), maze.start_heading()}, run.route);
  set_gates(run, maze, mm2021());
  return run;
}

TEST(DriveBound, OfOneRunIsThatOfTheSearch) {
  DriveRules rules = rules_of(0, true);
  rules.most_runs = 1;
  const DriveBound bound = drive_bound_of(test::ring(), rules, mm2021());
  EXPECT_EQ(bound.score, 1'074'000);
  EXPECT_EQ(bound.fastest, run_in_ring().route.time);
  rules.most_runs = 2;
  EXPECT_LT(*drive_bound_of(test::ring(), rules, mm2021()).score, 1'074'000);
}

TEST(DriveBound, OfWhatTheTimeIsTooShortForIsThatOfTheSearchOrNone) {
  const auto bound = [](bool gate_to_gate, MazeTime time_limit) {
    DriveRules rules = rules_of(0, gate_to_gate);
    rules.time_limit = time_limit;
    return drive_bound_of(test::ring(), rules, mm2021());
  };
  const DriveRun run = run_in_ring();
  EXPECT_EQ(bound(true, *run.gate_in).score, *run.gate_in - *run.gate_out);
  EXPECT_EQ(bound(true, *run.gate_in - 1).score, 1'074'000);
  EXPECT_EQ(bound(true, 1'374'000).score, 1'074'000);
  EXPECT_FALSE(bound(true, 1'373'999).score);
  EXPECT_EQ(bound(false, *run.centre).score, run.route.time);
  EXPECT_EQ(bound(false, *run.centre - 1).score, 1'524'000);
  EXPECT_EQ(bound(false, 1'524'000).score, 1'524'000);
  EXPECT_FALSE(bound(false, 1'523'999).score);
  // What could be driven does not depend on the rules.
  EXPECT_EQ(bound(true, 1'373'999).fastest, run.route.time);
}

TEST(DriveBound, IsNoneWithoutARoute) {
  const Maze closed(MazeDraft({3, 3}, MazeDraft::Inside::closed));
  EXPECT_FALSE(drive_bound_of(closed, rules_of(0, true), mm2021()).fastest);
  EXPECT_FALSE(drive_bound_of(closed, rules_of(0, true), mm2021()).score);
  EXPECT_FALSE(shortest_search_home(closed, mm2021().search));
}

TEST(DriveBound, HoldsForEveryMouse) {
  Rng rng(5);
  for (const char* rules : {"all-japan", "thirtieth"})
    for (int i = 0; i < test::some_of(40); ++i) {
      SCOPED_TRACE(i);
      const Maze maze = test::any_maze(rng, 9);
      for (const char* mouse : {"flood", "certify"}) {
        const DriveRecordFile file = test::driven(mouse, maze, i % 2 != 0 ? "classic" : "mm2021", rules);
        const DriveBound bound = drive_bound_of(maze, file.rules, *file.model);
        const DriveScore result = score(file.record, file.rules);
        for (const DriveRunScore& run : result.runs)
          if (bound.fastest && run.rest_to_centre) {
            EXPECT_GE(*run.rest_to_centre, *bound.fastest);
          }
        EXPECT_EQ(replay(file), "");
      }
    }
}

}  // namespace
}  // namespace labmouse
