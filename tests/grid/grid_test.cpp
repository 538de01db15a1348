#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "labmouse/grid/wall_set.hpp"

namespace labmouse {
namespace {

std::vector<Cell> members(const CellSet& cells) {
  std::vector<Cell> list;
  cells.for_each([&](Cell cell) { list.push_back(cell); });
  return list;
}

CellSet cells_of(std::initializer_list<Cell> list) {
  CellSet cells;
  for (const Cell cell : list) cells.insert(cell);
  return cells;
}

TEST(Heading, LeftAndRightAreQuarterTurns) {
  EXPECT_EQ(left_of(Heading::north), Heading::west);
  EXPECT_EQ(right_of(Heading::north), Heading::east);
  EXPECT_EQ(right_of(Heading::west), Heading::north);
}

TEST(Heading, FourQuartersLeadBack) {
  for (const Heading heading : all_headings) EXPECT_EQ(turned(heading, 4), heading);
  for (const Heading heading : all_headings) EXPECT_EQ(turned(heading, -5), left_of(heading));
}

TEST(Heading, QuartersBetweenAreThoseThatTurn) {
  for (const Heading from : all_headings)
    for (const Heading to : all_headings) EXPECT_EQ(turned(from, quarters_between(from, to)), to);
}

TEST(Heading, NorthIsUpAndEastIsRight) {
  EXPECT_EQ(neighbour({3, 5}, Heading::north), Cell(3, 6));
  EXPECT_EQ(neighbour({3, 5}, Heading::east, 2), Cell(5, 5));
  EXPECT_EQ(neighbour({3, 5}, Heading::south), Cell(3, 4));
  EXPECT_EQ(neighbour({3, 5}, Heading::west, -1), Cell(4, 5));
}

TEST(Size, IndexAndCellAtAreInverse) {
  const Size size{5, 7};
  for (int index = 0; index < size.area(); ++index) EXPECT_EQ(size.index(size.cell_at(index)), index);
}

TEST(Size, CellsAreOrderedRowByRow) {
  EXPECT_LT(Cell(6, 0), Cell(0, 1));
  EXPECT_LT(Cell(0, 1), Cell(1, 1));
}

TEST(Size, ReachesFromOneToSixtyFour) {
  EXPECT_TRUE((Size{1, 64}.valid()));
  EXPECT_FALSE((Size{0, 5}.valid()));
  EXPECT_FALSE((Size{5, 65}.valid()));
}

TEST(Wall, HasOneNameFromBothSides) {
  EXPECT_EQ(wall_at({2, 3}, Heading::north), wall_at({2, 4}, Heading::south));
  EXPECT_EQ(wall_at({2, 3}, Heading::east), wall_at({3, 3}, Heading::west));
}

TEST(Wall, WestOfTheCornerIsTheEastSideOfACellOfNothing) {
  EXPECT_EQ(wall_at({0, 0}, Heading::west), (Wall{{-1, 0}, Heading::east}));
}

TEST(Wall, NamesOfDifferentWallsDiffer) {
  std::set<Wall> names;
  const Size size{6, 4};
  for (int index = 0; index < size.area(); ++index)
    for (const Heading side : all_headings) names.insert(wall_at(size.cell_at(index), side));
  EXPECT_EQ(names.size(), 7U * 4U + 6U * 5U);
}

TEST(Wall, TheBorderIsWhereOneCellIsOutside) {
  const Size size{3, 2};
  EXPECT_TRUE(on_border(wall_at({0, 1}, Heading::west), size));
  EXPECT_TRUE(on_border(wall_at({2, 1}, Heading::north), size));
  EXPECT_FALSE(on_border(wall_at({1, 1}, Heading::south), size));
}

TEST(CellSet, HoldsWhatWasInserted) {
  CellSet cells = cells_of({{0, 0}, {63, 63}, {5, 9}});
  EXPECT_TRUE(cells.contains({63, 63}));
  EXPECT_FALSE(cells.contains({9, 5}));
  cells.erase({63, 63});
  EXPECT_EQ(cells.count(), 2);
}

TEST(CellSet, CellsOutsideAreNeverMembers) {
  const CellSet cells = CellSet::all({64, 64});
  for (const Cell outside : {Cell{-1, 0}, Cell{0, -1}, Cell{64, 0}, Cell{0, 64}}) EXPECT_FALSE(cells.contains(outside));
}

TEST(CellSet, AllHasEveryCellOfTheSize) {
  for (const Size size : {Size{1, 1}, Size{64, 64}, Size{3, 17}}) {
    EXPECT_EQ(CellSet::all(size).count(), size.area());
    EXPECT_EQ(CellSet::all(size).contains({size.width, 0}), false);
  }
}

TEST(CellSet, IsVisitedInTheOrderOfCells) {
  EXPECT_EQ(members(cells_of({{1, 2}, {7, 0}, {0, 2}, {0, 0}})), (std::vector<Cell>{{0, 0}, {7, 0}, {0, 2}, {1, 2}}));
}

TEST(CellSet, UnitesCutsAndTakesAway) {
  const CellSet some = cells_of({{0, 0}, {1, 0}}), others = cells_of({{1, 0}, {2, 0}});
  CellSet cells = some;
  EXPECT_EQ(members(cells |= others), (std::vector<Cell>{{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_EQ(members(cells &= some), (std::vector<Cell>{{0, 0}, {1, 0}}));
  EXPECT_EQ(members(cells -= others), (std::vector<Cell>{{0, 0}}));
  EXPECT_TRUE((cells -= some).empty());
}

TEST(WallSet, AllHasTheInnerWallsOnly) {
  EXPECT_EQ(WallSet::all({3, 2}).count(), 3 * 1 + 2 * 2);
  EXPECT_TRUE(WallSet::all({1, 1}).empty());
  EXPECT_EQ(WallSet::all({64, 64}).count(), 2 * 63 * 64);
  WallSet::all({5, 3}).for_each([](Wall wall) { EXPECT_FALSE(on_border(wall, {5, 3})); });
}

TEST(WallSet, KeepsAWallUnderItsOneName) {
  WallSet walls;
  walls.insert(wall_at({2, 2}, Heading::south));
  EXPECT_TRUE(walls.contains(wall_at({2, 1}, Heading::north)));
  EXPECT_FALSE(walls.contains(wall_at({2, 2}, Heading::north)));
  EXPECT_EQ(walls.count(), 1);
}

TEST(WallSet, NorthAndEastSidesAreDifferentWalls) {
  WallSet walls;
  walls.insert(wall_at({2, 2}, Heading::north));
  EXPECT_FALSE(walls.contains(wall_at({2, 2}, Heading::east)));
  walls -= walls;
  EXPECT_TRUE(walls.empty());
}

}  // namespace
}  // namespace labmouse
