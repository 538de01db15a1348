#include "labmouse/mouse/hashed_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "labmouse/grid/cell_set.hpp"

namespace labmouse {
namespace {

std::vector<Cell> members(const HashedCells& cells) {
  std::vector<Cell> list;
  cells.for_each([&](Cell cell) { list.push_back(cell); });
  return list;
}

TEST(HashedCells, HoldsEachMemberOnce) {
  constexpr Size size{64, 64};
  HashedCells cells(size);
  std::set<Cell> expected;
  // A walk over all cells that comes back to some, and takes out one of three again.
  for (int i = 0; i < 3 * size.area(); ++i) {
    const Cell cell = size.cell_at(i * 2477 % size.area()), gone = size.cell_at(i * 911 % size.area());
    cells.insert(cell);
    expected.insert(cell);
    if (i % 3 != 0) continue;
    cells.erase(gone);
    expected.erase(gone);
  }
  std::vector<Cell> list = members(cells);
  std::ranges::sort(list);
  EXPECT_EQ(list, std::vector<Cell>(expected.begin(), expected.end()));
  cells.clear();
  EXPECT_TRUE(members(cells).empty());
}

// The expected orders were printed by Python 2.7.18, for a map with the keys (4 - y, x).
TEST(HashedCells, ListsThemAsTheMapOfThatLanguageDoes) {
  HashedCells cells({5, 5});
  for (int y = 4; y >= 2; --y)
    for (int x = 0; x < 3; ++x) cells.insert({x, y});
  EXPECT_EQ(members(cells), (std::vector<Cell>{{1, 4}, {2, 3}, {0, 4}, {1, 2}, {1, 3}, {0, 2}, {2, 2}, {0, 3}, {2, 4}}));
  for (int i = 0; i < 3; ++i) cells.erase({i, 4 - i});
  for (int x = 0; x < 5; ++x) cells.insert({x, 0});
  const std::vector<Cell> without_a_diagonal = {{1, 4}, {2, 3}, {4, 0}, {1, 2}, {0, 2}, {3, 0},
                                                {2, 0}, {0, 3}, {1, 0}, {2, 4}, {0, 0}};
  EXPECT_EQ(members(cells), without_a_diagonal);
  cells.insert({1, 3});
  for (int x = 0; x < 5; ++x) cells.insert({x, 1});
  const std::vector<Cell> with_another_row = {{1, 4}, {2, 3}, {2, 1}, {1, 1}, {3, 1}, {0, 1}, {4, 1}, {4, 0}, {1, 2},
                                              {1, 3}, {0, 2}, {3, 0}, {2, 0}, {0, 3}, {1, 0}, {2, 4}, {0, 0}};
  EXPECT_EQ(members(cells), with_another_row);
}

}  // namespace
}  // namespace labmouse
