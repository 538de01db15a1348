#include "labmouse/mouse/drive/route_passages.hpp"

#include <gtest/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

constexpr Size size{5, 3};

/// A corridor north, then east through the goal (2,2) to (3,2), a loop beside it, and a dead end south of (3,1).
WallSet corridor_with_dead_end() {
  WallSet walls;
  for (const Cell cell : {Cell{0, 0}, Cell{0, 1}, Cell{1, 1}, Cell{3, 0}}) walls.insert({cell, Heading::north});
  for (const Cell cell : {Cell{0, 1}, Cell{0, 2}, Cell{1, 2}, Cell{2, 2}, Cell{3, 0}})
    walls.insert({cell, Heading::east});
  return walls;
}

TEST(PassagesOfRoutes, AreThoseOutsideOfDeadEnds) {
  WallSet left = corridor_with_dead_end();
  left.erase({{3, 0}, Heading::north});
  left.erase({{3, 0}, Heading::east});
  EXPECT_EQ(passages_of_routes(size, corridor_with_dead_end(), {0, 0}, CellSet::of({2, 2})), left);
}

TEST(PassagesOfRoutes, KeepTheRoomBeyondTheGoal) {
  const WallSet left = passages_of_routes(size, corridor_with_dead_end(), {0, 0}, CellSet::of({1, 2}));
  EXPECT_TRUE(left.contains({{1, 2}, Heading::east}));
  EXPECT_TRUE(left.contains({{2, 2}, Heading::east}));
}

TEST(PassagesOfRoutes, HaveTheSameFastestRoutes) {
  Rng rng(23);
  const DriveModel model = make_drive_model(large_robot());
  for (int round = 0; round < 40; ++round) {
    const Maze maze = test::any_maze(rng, 16);
    const Pose start = {maze.start(), maze.start_heading()};
    FastestRoutes routes(maze.size(), model.tables);
    routes.fill(maze.open_walls(), maze.goals());
    const DriveTime time = routes.time_from(start);
    const WallSet walls = routes.walls_from(start);
    routes.fill(passages_of_routes(maze.size(), maze.open_walls(), maze.start(), maze.goals()), maze.goals());
    EXPECT_EQ(routes.time_from(start), time);
    EXPECT_EQ(routes.walls_from(start), walls);
  }
}

}  // namespace
}  // namespace labmouse
