#include "labmouse/mouse/connected_cells.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace labmouse {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

constexpr Size size{8, 8};

ConnectedCells neutral(int longest = 3) { return {size, longest, CellOrder::rows}; }

std::vector<Cell> cells_of(const ConnectedCells& map) {
  std::vector<Cell> cells;
  map.cells().for_each([&](Cell cell) { cells.push_back(cell); });
  return cells;
}

TEST(ConnectedCells, AreThoseOfACorridorInBothDirections) {
  ConnectedCells map = neutral();
  EXPECT_THAT(cells_of(map), IsEmpty());
  map.learn({{1, 0}, Heading::north}, {0, 5, 0});
  EXPECT_THAT(map.of({1, 0}), ElementsAre(Cell{1, 1}, Cell{1, 2}, Cell{1, 3}));
  EXPECT_THAT(map.of({1, 2}), ElementsAre(Cell{1, 0}, Cell{1, 1}, Cell{1, 3}, Cell{1, 4}, Cell{1, 5}));
  EXPECT_THAT(map.of({1, 5}), ElementsAre(Cell{1, 2}, Cell{1, 3}, Cell{1, 4}));
  EXPECT_THAT(map.of({2, 0}), IsEmpty());
  EXPECT_THAT(cells_of(map), ElementsAre(Cell{1, 0}, Cell{1, 1}, Cell{1, 2}, Cell{1, 3}, Cell{1, 4}, Cell{1, 5}));
}

TEST(ConnectedCells, LieOnAllThreeSidesOfTheMouse) {
  ConnectedCells map = neutral(8);
  map.learn({{4, 4}, Heading::east}, {1, 2, 3});
  EXPECT_THAT(map.of({4, 4}),
              UnorderedElementsAre(Cell{4, 5}, Cell{5, 4}, Cell{6, 4}, Cell{4, 3}, Cell{4, 2}, Cell{4, 1}));
}

TEST(ConnectedCells, AreNotJoinedByTwoReadings) {
  ConnectedCells map = neutral();
  map.learn({{2, 3}, Heading::north}, {0, 2, 0});
  map.learn({{2, 3}, Heading::south}, {0, 2, 0});
  EXPECT_THAT(map.of({2, 1}), ElementsAre(Cell{2, 2}, Cell{2, 3}));
  map.learn({{2, 1}, Heading::north}, {0, 4, 0});
  EXPECT_THAT(map.of({2, 1}), ElementsAre(Cell{2, 2}, Cell{2, 3}, Cell{2, 4}));
}

TEST(ConnectedCells, StayForAShorterReading) {
  ConnectedCells map = neutral();
  map.learn({{0, 0}, Heading::east}, {0, 3, 0});
  map.learn({{0, 0}, Heading::east}, {0, 1, 0});
  EXPECT_THAT(map.of({0, 0}), ElementsAre(Cell{1, 0}, Cell{2, 0}, Cell{3, 0}));
}

/// A set that is copied for each connection, without a thought of sparing any.
TEST(ConnectedCells, AreInTheOrderOfSetsThatAreCopiedForEachConnection) {
  for (const CellOrder order : {CellOrder::python_2_7, CellOrder::python_3_4, CellOrder::python_3_5}) {
    ConnectedCells map(size, 3, order);
    std::vector<Cell> list;
    const auto connect = [&](Cell cell) {
      HashedCells set(size, order, CellTable::set, CellKey::column_row);
      set.copy(list);
      set.insert(cell);
      list.clear();
      set.for_each([&](Cell member) { list.push_back(member); });
    };
    // Around (3,3): all that is to its left, ahead and to its right, from four sides and again.
    for (int turn = 0; turn < 8; ++turn) {
      const Pose pose = {{3, 3}, turned(Heading::north, turn % 4)};
      map.learn(pose, {3, 3, 3});
      for (const int side : {-1, 0, 1})
        for (int away = 1; away <= 3; ++away) connect(neighbour(pose.cell, turned(pose.heading, side), away));
      ASSERT_EQ(std::vector<Cell>(map.of({3, 3}).begin(), map.of({3, 3}).end()), list) << turn;
    }
  }
}

}  // namespace
}  // namespace labmouse
