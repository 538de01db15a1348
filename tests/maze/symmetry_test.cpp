#include "labmouse/maze/symmetry.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "labmouse/maze/routes.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/maze/random_maze.hpp"

namespace labmouse {
namespace {

/// A maze that no symmetry takes to itself.
Maze crooked() {
  return test::drawn(R"(
    o---o---o---o
    |       | G |
    o   o---o   o
    | S         |
    o---o---o---o
  )");
}

TEST(Symmetry, TurnsAMazeClockwise) {
  const Maze turned = test::drawn(R"(
    o---o---o
    | S     |
    o   o   o
    |   |   |
    o   o---o
    |     G |
    o---o---o
  )");
  EXPECT_EQ(transformed(crooked(), {false, 1}), turned.with_start({0, 2}, Heading::east));
}

TEST(Symmetry, MirrorsAMaze) {
  const Maze mirrored = test::drawn(R"(
    o---o---o---o
    | G |       |
    o   o---o   o
    |         S |
    o---o---o---o
  )");
  EXPECT_EQ(transformed(crooked(), {true, 0}), mirrored.with_start({2, 0}, Heading::north));
}

TEST(Symmetry, MirrorsBeforeItTurns) {
  const Maze both = test::drawn(R"(
    o---o---o
    |     G |
    o   o---o
    |   |   |
    o   o   o
    | S     |
    o---o---o
  )");
  EXPECT_EQ(transformed(crooked(), {true, 1}), both.with_start({0, 0}, Heading::east));
}

TEST(Symmetry, TurnsAndMirrorsHeadings) {
  EXPECT_EQ(transformed(Heading::east, Symmetry{true, 0}), Heading::west);
  EXPECT_EQ(transformed(Heading::north, Symmetry{true, 0}), Heading::north);
  EXPECT_EQ(transformed(Heading::west, Symmetry{false, 1}), Heading::north);
  EXPECT_EQ(transformed(Heading::west, Symmetry{true, 2}), Heading::west);
}

TEST(Symmetry, HasEightKinds) {
  for (const Symmetry a : all_symmetries)
    for (const Symmetry b : all_symmetries) EXPECT_EQ(transformed(crooked(), a) == transformed(crooked(), b), a == b);
}

RC_GTEST_PROP(SymmetryOfAnyMaze, FourQuartersOrTwoMirrorsAreNothing, ()) {
  const Maze maze = *test::marked_mazes();
  Maze turned = maze;
  for (int i = 0; i < 4; ++i) turned = transformed(turned, {false, 1});
  RC_ASSERT(turned == maze);
  RC_ASSERT(transformed(transformed(maze, {true, 0}), {true, 0}) == maze);
}

RC_GTEST_PROP(SymmetryOfAnyMaze, KeepsRoutesAndCells, ()) {
  const Maze maze = *test::marked_mazes();
  for (const Symmetry symmetry : all_symmetries) {
    const Maze other = transformed(maze, symmetry);
    RC_ASSERT(shortest_in_cells(other) == shortest_in_cells(maze));
    RC_ASSERT(reachable_cells(other).count() == reachable_cells(maze).count());
  }
}

RC_GTEST_PROP(SymmetryOfAnyMaze, HasOneCanonicalForm, ()) {
  const Maze maze = *test::marked_mazes();
  const CanonicalWalls walls = canonical_walls(maze);
  bool is_one_of_them = false;
  for (const Symmetry symmetry : all_symmetries) {
    RC_ASSERT(canonical_walls(transformed(maze, symmetry)) == walls);
    is_one_of_them = is_one_of_them || transformed(maze, symmetry).open_walls() == walls.open;
  }
  RC_ASSERT(is_one_of_them);
}

TEST(CanonicalWalls, LeaveStartAndGoalsOut) {
  const Maze moved = transformed(crooked(), {true, 3}).with_start({1, 1}, Heading::south);
  EXPECT_EQ(canonical_walls(moved), canonical_walls(crooked()));
}

TEST(CanonicalWalls, TellMazesApartByOneWallOrBySize) {
  MazeDraft draft({4, 4}, MazeDraft::Inside::open);
  const CanonicalWalls open = canonical_walls(Maze(draft));
  draft.close({1, 1}, Heading::north);
  EXPECT_FALSE(canonical_walls(Maze(draft)) == open);
  const MazeDraft closed({2, 3}, MazeDraft::Inside::closed), larger({3, 3}, MazeDraft::Inside::closed);
  EXPECT_FALSE(canonical_walls(Maze(closed)) == canonical_walls(Maze(larger)));
}

TEST(CanonicalWalls, HaveATotalOrder) {
  std::vector<CanonicalWalls> all = {canonical_walls(crooked())};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    all.push_back(canonical_walls(test::random_maze({2, 2}, seed, 4)));
    all.push_back(canonical_walls(test::random_maze({2, 3}, seed, 4)));
  }
  for (const CanonicalWalls& a : all)
    for (const CanonicalWalls& b : all) EXPECT_EQ((a < b) + (b < a) + (a == b), 1);
}

}  // namespace
}  // namespace labmouse
