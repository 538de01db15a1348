#include "labmouse/mouse/route.hpp"

#include <gtest/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {

void PrintTo(const Move& move, std::ostream* out) { *out << move.cells << ' ' << name_of(move.direction); }

namespace {

/// An open floor of nine by nine cells and one cell to go to, in strides of three.
class OnAnOpenFloor : public testing::Test {
 protected:
  void goal(Cell cell) { goals({cell}); }
  void goals(std::initializer_list<Cell> cells) {
    CellSet set;
    for (const Cell cell : cells) set.insert(cell);
    field_.fill(floor_, set);
  }
  Move first_move(Heading heading) { return next_move(field_, floor_, {{4, 4}, heading}).value(); }

  WallSet floor_ = WallSet::all({9, 9});
  DistanceField field_{{9, 9}, strides(3)};
};

TEST_F(OnAnOpenFloor, OfEqualMovesAheadIsFirst) {
  goal({6, 6});
  EXPECT_EQ(first_move(Heading::north), (Move{Heading::north, 2}));
  EXPECT_EQ(first_move(Heading::east), (Move{Heading::east, 2}));
}

TEST_F(OnAnOpenFloor, ThenLeft) {
  goal({2, 2});
  EXPECT_EQ(first_move(Heading::north), (Move{Heading::west, 2}));
  goal({6, 6});
  EXPECT_EQ(first_move(Heading::south), (Move{Heading::east, 2}));
}

TEST_F(OnAnOpenFloor, LeftIsBeforeRight) {
  goals({{2, 4}, {6, 4}});
  EXPECT_EQ(first_move(Heading::north), (Move{Heading::west, 2}));
  EXPECT_EQ(first_move(Heading::south), (Move{Heading::east, 2}));
}

TEST_F(OnAnOpenFloor, AheadIsBeforeBack) {
  goals({{4, 2}, {4, 6}});
  EXPECT_EQ(first_move(Heading::north), (Move{Heading::north, 2}));
  EXPECT_EQ(first_move(Heading::south), (Move{Heading::south, 2}));
}

TEST_F(OnAnOpenFloor, ThenRight) {
  goal({6, 2});
  EXPECT_EQ(first_move(Heading::north), (Move{Heading::east, 2}));
}

TEST_F(OnAnOpenFloor, ThenBack) {
  goal({4, 2});
  EXPECT_EQ(first_move(Heading::north), (Move{Heading::south, 2}));
}

TEST_F(OnAnOpenFloor, OfEqualLengthsTheLongestIsFirst) {
  goal({4, 8});
  EXPECT_EQ(first_move(Heading::north), (Move{Heading::north, 3}));
}

TEST_F(OnAnOpenFloor, AMoveDoesNotGoBeyondWhatTheRouteNeeds) {
  goal({4, 5});
  EXPECT_EQ(first_move(Heading::west), (Move{Heading::north, 1}));
}

TEST_F(OnAnOpenFloor, WhoIsThereHasNoMoveAndStays) {
  goal({4, 4});
  EXPECT_EQ(next_move(field_, floor_, {{4, 4}, Heading::north}), std::nullopt);
  EXPECT_EQ(step_along(field_, floor_, {{4, 4}, Heading::north}), Action::step(0, 0));
}

TEST(Route, BehindAWallIsNoWay) {
  const Maze maze = test::drawn(R"(
    o---o---o---o
    | S     | G |
    o---o---o---o
  )");
  DistanceField field(maze.size(), strides());
  field.fill(maze.open_walls(), maze.goals());
  EXPECT_EQ(next_move(field, maze.open_walls(), {{0, 0}, Heading::north}), std::nullopt);
  EXPECT_EQ(step_along(field, maze.open_walls(), {{0, 0}, Heading::north}), Action::forfeit(ForfeitReason::no_route));
}

TEST(Route, MovesBecomeActionsFromTheHeading) {
  EXPECT_EQ(move_in(Heading::east, Heading::east, 2), Action::step(0, 2));
  EXPECT_EQ(move_in(Heading::east, Heading::north, 2), Action::step(-90, 2));
  EXPECT_EQ(move_in(Heading::east, Heading::south, 2), Action::step(90, 2));
  EXPECT_EQ(move_in(Heading::east, Heading::west, 2), Action::step(0, -2));
}

TEST(Route, AStepLeadsToThePoseAfterIt) {
  EXPECT_EQ(after({{4, 4}, Heading::north}, Action::step(90, 2)), (Pose{{6, 4}, Heading::east}));
  EXPECT_EQ(after({{4, 4}, Heading::north}, Action::step(0, -3)), (Pose{{4, 1}, Heading::north}));
  EXPECT_EQ(after({{4, 4}, Heading::north}, Action::step(180, 1)), (Pose{{4, 5}, Heading::north}));
}

TEST(Motion, StridesCostOneWhateverTheirLength) {
  EXPECT_TRUE(strides(3).uniform());
  EXPECT_EQ(strides(3).longest, 3);
  EXPECT_EQ(strides(3).cost[1], strides(3).cost[3]);
}

TEST(Motion, CostsThatFallOrAreNoneAreNotValid) {
  Motion motion = strides(2);
  motion.cost[1] = 2;
  EXPECT_FALSE(motion.valid());
  motion.cost[1] = 0;
  EXPECT_FALSE(motion.valid());
  EXPECT_FALSE(Motion().valid());
}

/// Walks to a cell at distance 0, always through open walls; the cost of the way.
int cost_of_walk(const DistanceField& field, const WallSet& passages, Pose pose) {
  int cost = 0;
  while (field.at(pose.cell) > 0) {
    const Move move = next_move(field, passages, pose).value();
    const Action action = step_along(field, passages, pose);
    Cell cell = pose.cell;
    for (int cells = 0; cells < move.cells; ++cells) {
      EXPECT_TRUE(passages.contains(wall_at(cell, move.direction)));
      cell = neighbour(cell, move.direction);
    }
    pose = after(pose, action);
    EXPECT_EQ(pose.cell, cell);
    cost += field.motion().cost[static_cast<std::size_t>(move.cells)];
  }
  return cost;
}

TEST(Route, IsAsLongAsTheDistanceSays) {
  Rng rng(9);
  for (int i = 0; i < 60; ++i) {
    const Size size{1 + rng.below(32), 1 + rng.below(32)};
    const Maze maze = prim_generator.make({size, rng.bits(), rng.below(400)});
    Motion motion = strides(1 + rng.below(5));
    if (rng.chance(1, 2))
      for (std::size_t cells = 1; cells <= 5; ++cells) motion.cost[cells] = static_cast<std::uint8_t>(2 + cells);
    DistanceField field(size, motion);
    field.fill(maze.open_walls(), maze.goals());
    for (int index = 0; index < size.area(); ++index) {
      const Pose pose{size.cell_at(index), all_headings[static_cast<std::size_t>(rng.below(4))]};
      ASSERT_EQ(cost_of_walk(field, maze.open_walls(), pose), field.at(pose.cell));
    }
  }
}

}  // namespace
}  // namespace labmouse
