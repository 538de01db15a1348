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

class HashedCellsOf : public testing::TestWithParam<Python> {};

TEST_P(HashedCellsOf, HoldsEachMemberOnce) {
  constexpr Size size{64, 64};
  HashedCells cells(size, GetParam(), CellKey::row_column);
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

INSTANTIATE_TEST_SUITE_P(Python, HashedCellsOf, testing::Values(Python::v2_7, Python::v3_5),
                         [](const auto& version) { return version.param == Python::v2_7 ? "v2_7" : "v3_5"; });

// The expected orders were printed by Python 2.7.18, for a map with the keys (4 - y, x).
TEST(HashedCells, ListsThemAsTheMapOfThatLanguageDoes) {
  HashedCells cells({5, 5}, Python::v2_7, CellKey::row_column);
  for (int y = 4; y >= 2; --y)
    for (int x = 0; x < 3; ++x) cells.insert({x, y});
  EXPECT_EQ(members(cells),
            (std::vector<Cell>{{1, 4}, {2, 3}, {0, 4}, {1, 2}, {1, 3}, {0, 2}, {2, 2}, {0, 3}, {2, 4}}));
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

// The expected orders come from a model of the table of Python 3.5, over the hashes that an interpreter printed. It
// grows from 8 slots to 16 with the sixth member, to 32 with the twelfth, and stays at 16 where most of these are gone.
TEST(HashedCells, GrowsAsItsVersionDoes) {
  HashedCells cells({4, 5}, Python::v3_5, CellKey::column_row);
  for (int y = 0; y < 5; ++y) cells.insert({0, y});
  EXPECT_EQ(members(cells), (std::vector<Cell>{{0, 1}, {0, 3}, {0, 0}, {0, 2}, {0, 4}}));
  cells.insert({1, 0});
  EXPECT_EQ(members(cells), (std::vector<Cell>{{0, 1}, {0, 0}, {0, 4}, {1, 0}, {0, 3}, {0, 2}}));

  HashedCells more({4, 5}, Python::v3_5, CellKey::column_row);
  for (int i = 0; i < 11; ++i) more.insert({i / 3, i % 3});
  const std::vector<Cell> eleven = {{0, 1}, {1, 2}, {0, 0}, {3, 1}, {2, 0}, {3, 0},
                                    {1, 0}, {2, 2}, {0, 2}, {2, 1}, {1, 1}};
  EXPECT_EQ(members(more), eleven);
  HashedCells few = more;
  for (int i = 0; i < 8; ++i) few.erase({i / 3, i % 3});
  few.insert({3, 2});
  EXPECT_EQ(members(few), (std::vector<Cell>{{3, 2}, {2, 2}, {3, 0}, {3, 1}}));
  more.insert({3, 2});
  const std::vector<Cell> twelve = {{0, 1}, {1, 2}, {3, 2}, {0, 0}, {3, 0}, {3, 1},
                                    {2, 1}, {1, 1}, {2, 0}, {2, 2}, {1, 0}, {0, 2}};
  EXPECT_EQ(members(more), twelve);
}

}  // namespace
}  // namespace labmouse
