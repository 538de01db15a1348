#include <gtest/gtest.h>

#include <map>

#include "tests/strategies/wanderers.hpp"

namespace labmouse {
namespace {

TEST(RandomMove, DrawsEveryTurnEquallyOftenAndGoesACell) {
  const Maze open = Maze(MazeDraft({9, 9}, MazeDraft::Inside::open)).with_start({4, 3}, Heading::north);
  std::map<std::pair<int, int>, int> drawn;
  for (std::uint64_t seed = 1; seed <= 1200; ++seed) {
    const Action first = test::wander(random_move_mouse, open, seed, {}, 1).steps.front().action;
    ++drawn[{first.rotation, first.movement}];
  }
  EXPECT_EQ(drawn.size(), 3U);
  for (const int rotation : {-90, 0, 90}) EXPECT_NEAR((drawn[{rotation, 1}]), 400, 80) << rotation;
}

TEST(RandomMove, TurnsAndStaysWhereItDrewAWall) {
  const Maze cell = Maze(MazeDraft({1, 1}, MazeDraft::Inside::closed)).with_goals(CellSet::all({1, 1}));
  std::set<int> rotations;
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const Action action = test::wander(random_move_mouse, cell, seed).steps.front().action;
    EXPECT_EQ(action.movement, 0);
    rotations.insert(action.rotation);
  }
  EXPECT_EQ(rotations, (std::set{-90, 0, 90}));
}

TEST(RandomMove, MarksEveryCellInWhichItStands) {
  const Maze maze = test::wandering_ground();
  for (const char* coverage : {"0", "0.5", "1"}) {
    const RunRecord record = test::wander(random_move_mouse, maze, 1, {{"coverage", coverage}});
    CellSet marked;
    bool goal = false;
    test::in_search_run(record, [&](const StepRecord& step) {
      marked.insert(step.pose.cell);
      goal |= maze.is_goal(step.pose.cell);
      const bool enough = goal && marked.count() >= std::stod(coverage) * maze.size().area();
      ASSERT_EQ(step.action.kind == Action::Kind::reset, enough) << "step " << step.step;
    });
    EXPECT_EQ(record.outcome, Outcome::finished);
  }
}

TEST(RandomMove, RacesWhereItWalked) { test::expect_speed_runs_where_it_walked(random_move_mouse); }

}  // namespace
}  // namespace labmouse
