#include "labmouse/lab/drive_bound.hpp"

#include <gtest/gtest.h>

#include "tests/lab/drive_record_fixture.hpp"
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

TEST(DriveBound, KnowsTheShortestSearchHome) {
  // There; back, a corner, a cell, a corner, a cell; a stop in the middle and half a turn.
  const MazeTime there = 1'374'000, back = 3'000'000 + 237'000 + 300'000 + 237'000 + 300'000, stop = 300'000 + 3'000'000;
  EXPECT_EQ(shortest_search_home(test::ring(), mm2021().search), there + back + stop);
}

TEST(DriveBound, OfARunIsTheFastestRoute) {
  const DriveBound bound = drive_bound_of(test::ring(), rules_of(0, false), mm2021());
  ASSERT_TRUE(bound.fastest && bound.score);
  EXPECT_EQ(*bound.score, *bound.fastest);
  EXPECT_LT(*drive_bound_of(test::ring(), rules_of(0, true), mm2021()).score, *bound.score);
}

TEST(DriveBound, CanBeTheSearchItself) {
  EXPECT_EQ(drive_bound_of(test::ring(), rules_of(10, true), mm2021()).score, 1'074'000);
  // Where a thousandth counts, the fast run is worth its search: 8,748 ms in the maze count 8.748.
  const MazeTime run = *drive_bound_of(test::ring(), rules_of(0, true), mm2021()).score;
  EXPECT_EQ(drive_bound_of(test::ring(), rules_of(1000, true), mm2021()).score, run + 8'748);
}

TEST(DriveBound, TakesABonusOff) {
  DriveRules rules = rules_of(0, true);
  const MazeTime before = *drive_bound_of(test::ring(), rules, mm2021()).score;
  rules.untouched_bonus = 2'000;
  EXPECT_EQ(drive_bound_of(test::ring(), rules, mm2021()).score, before - 2'000);
}

TEST(DriveBound, IsNoneWithoutARoute) {
  const Maze closed(MazeDraft({3, 3}, MazeDraft::Inside::closed));
  EXPECT_FALSE(drive_bound_of(closed, rules_of(0, true), mm2021()).fastest);
  EXPECT_FALSE(drive_bound_of(closed, rules_of(0, true), mm2021()).score);
  EXPECT_FALSE(shortest_search_home(closed, mm2021().search));
}

TEST(DriveBound, HoldsForEveryMouse) {
  Dice dice(5);
  for (const char* rules : {"all-japan", "thirtieth"})
    for (int i = 0; i < 30; ++i) {
      SCOPED_TRACE(i);
      const Maze maze = test::any_maze(dice, 9);
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
