#include "labmouse/mouse/hashed_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <string>

#include "labmouse/chance/rng.hpp"
#include "labmouse/grid/cell_set.hpp"
#include "tests/interpreters.hpp"

namespace labmouse {
namespace {

std::vector<Cell> members(const HashedCells& cells) {
  std::vector<Cell> list;
  cells.for_each([&](Cell cell) { list.push_back(cell); });
  return list;
}

using Kind = std::tuple<CellOrder, CellTable>;

class HashedCellsOf : public testing::TestWithParam<Kind> {};

TEST_P(HashedCellsOf, HoldsEachMemberOnce) {
  constexpr Size size{64, 64};
  const auto [order, table] = GetParam();
  HashedCells cells(size, order, table, CellKey::row_column);
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

INSTANTIATE_TEST_SUITE_P(Tables, HashedCellsOf,
                         testing::Combine(testing::Values(CellOrder::rows, CellOrder::python_2_7, CellOrder::python_3_4,
                                                          CellOrder::python_3_5),
                                          testing::Values(CellTable::map, CellTable::set)));

TEST(HashedCells, AreNeutralRowByRow) {
  HashedCells cells({3, 3}, CellOrder::rows, CellTable::set, CellKey::column_row);
  for (const Cell cell : {Cell{2, 2}, Cell{1, 0}, Cell{0, 1}, Cell{0, 0}}) cells.insert(cell);
  EXPECT_EQ(members(cells), (std::vector<Cell>{{0, 0}, {1, 0}, {0, 1}, {2, 2}}));
}

// The expected orders were printed by Python 2.7.18, for a map with the keys (4 - y, x).
TEST(HashedCells, ListsThemAsTheMapOfThatLanguageDoes) {
  HashedCells cells({5, 5}, CellOrder::python_2_7, CellTable::map, CellKey::row_column);
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
  HashedCells cells({4, 5}, CellOrder::python_3_5, CellTable::map, CellKey::column_row);
  for (int y = 0; y < 5; ++y) cells.insert({0, y});
  EXPECT_EQ(members(cells), (std::vector<Cell>{{0, 1}, {0, 3}, {0, 0}, {0, 2}, {0, 4}}));
  cells.insert({1, 0});
  EXPECT_EQ(members(cells), (std::vector<Cell>{{0, 1}, {0, 0}, {0, 4}, {1, 0}, {0, 3}, {0, 2}}));

  HashedCells more({4, 5}, CellOrder::python_3_5, CellTable::map, CellKey::column_row);
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

// Worked out from the rules, over the hashes that an interpreter printed. With the sixth member a set grows from 8
// slots to 32, a copy of it has 16; in the set of 3.5 (1,1) and (0,2) meet others, and do not look beside them near the
// end.
TEST(HashedCells, AreSetsWithTheirOwnRules) {
  const auto seven = [](CellOrder order) {
    HashedCells set({4, 4}, order, CellTable::set, CellKey::column_row);
    for (int i = 0; i < 7; ++i) set.insert({i / 3, i % 3});
    return set;
  };
  using Cells = std::vector<Cell>;
  HashedCells set = seven(CellOrder::python_3_4);
  EXPECT_EQ(members(set), (Cells{{0, 1}, {1, 2}, {0, 0}, {2, 0}, {1, 0}, {0, 2}, {1, 1}}));
  set.copy(members(set));
  EXPECT_EQ(members(set), (Cells{{0, 1}, {1, 2}, {2, 0}, {0, 0}, {1, 0}, {0, 2}, {1, 1}}));
  set = seven(CellOrder::python_3_5);
  EXPECT_EQ(members(set), (Cells{{0, 1}, {1, 2}, {0, 0}, {2, 0}, {1, 1}, {1, 0}, {0, 2}}));
  set.copy(members(set));
  EXPECT_EQ(members(set), (Cells{{0, 1}, {1, 2}, {2, 0}, {0, 0}, {0, 2}, {1, 0}, {1, 1}}));
}

// A set of Python 2.7.18, as it printed it, with seven members, as a copy, and with thirteen.
TEST(HashedCells, AreTheSetsOfTheOldestVersion) {
  using Cells = std::vector<Cell>;
  HashedCells set({5, 5}, CellOrder::python_2_7, CellTable::set, CellKey::column_row);
  for (int i = 0; i < 7; ++i) set.insert({i / 3, i % 3});
  EXPECT_EQ(members(set), (Cells{{0, 1}, {1, 2}, {0, 0}, {1, 1}, {2, 0}, {1, 0}, {0, 2}}));
  HashedCells copy = set;
  copy.copy(members(set));
  EXPECT_EQ(members(copy), (Cells{{0, 1}, {1, 2}, {0, 0}, {2, 0}, {1, 0}, {1, 1}, {0, 2}}));
  for (int i = 7; i < 13; ++i) set.insert({i / 3, i % 3});
  EXPECT_EQ(
      members(set),
      (Cells{{0, 1}, {1, 2}, {3, 2}, {0, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {2, 0}, {2, 2}, {1, 0}, {0, 2}, {4, 0}}));
}

// Worked out from the rules of Python 3.4 by another program, over the hashes that an interpreter printed.
TEST(HashedCells, AreTheMapsOfTheThirdReport) {
  HashedCells map({5, 5}, CellOrder::python_3_4, CellTable::map, CellKey::column_row);
  for (int i = 0; i < 6; ++i) map.insert({i / 3, i % 3});
  EXPECT_EQ(members(map), (std::vector<Cell>{{0, 1}, {1, 2}, {0, 0}, {1, 0}, {0, 2}, {1, 1}}));
  HashedCells more({5, 5}, CellOrder::python_3_4, CellTable::map, CellKey::column_row);
  for (int i = 0; i < 22; ++i) more.insert({i / 5, i % 5});
  EXPECT_EQ(members(more), (std::vector<Cell>{{1, 2}, {3, 2}, {0, 0}, {3, 0}, {0, 4}, {1, 4}, {1, 3}, {2, 3},
                                              {2, 1}, {2, 4}, {1, 0}, {0, 3}, {4, 0}, {0, 1}, {3, 3}, {4, 1},
                                              {3, 1}, {0, 2}, {2, 0}, {2, 2}, {3, 4}, {1, 1}}));
}

struct Interpreter {
  CellOrder order;
  const char* name;
  const char* version;
};

/// What a program prints; the program has no single quotes.
std::string printed(const std::string& interpreter, const std::string& program) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((interpreter + " -c '" + program + "'").c_str(), "r"), pclose);
  std::string text;
  for (int letter = 0; (letter = std::fgetc(pipe.get())) != EOF;) text += static_cast<char>(letter);
  return text;
}

/// As the programs print a list.
std::string text_of(const std::vector<Cell>& cells) {
  std::string text;
  for (const Cell cell : cells) text += std::to_string(cell.x) + "," + std::to_string(cell.y) + " ";
  return text + "\n";
}

class RealTables : public testing::TestWithParam<Interpreter> {};

TEST_P(RealTables, AreListedAsTheInterpreterDoes) {
  const auto& [order, name, version] = GetParam();
  const std::string interpreter = test::first_that_runs(
      {name}, std::string("-c 'import sys; sys.exit(sys.version_info[:2] != (") + version + "))'");
  if (interpreter.empty()) GTEST_SKIP() << "no " << name << " that runs is in PATH: its tables are not tried";
  constexpr Size size{16, 16};
  Rng rng(1);
  std::string program = R"(
import sys
def show(cells): sys.stdout.write("".join("%d,%d " % cell for cell in cells) + "\n")
)";
  std::string expected;
  for (const int count : {1, 4, 5, 6, 9, 12, 20, 60, 200}) {
    HashedCells map(size, order, CellTable::map, CellKey::column_row);
    HashedCells set(size, order, CellTable::set, CellKey::column_row), copy = set;
    program += "m, s = {}, set()\n";
    for (int i = 0; i < count; ++i) {
      const Cell cell = size.cell_at(rng.below(size.area()));
      map.insert(cell);
      set.insert(cell);
      const std::string key = "(" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ")";
      program += "m[" + key + "] = 0; s.add(" + key + ")\n";
    }
    copy.copy(members(set));
    expected += text_of(members(map)) + text_of(members(set)) + text_of(members(copy));
    program += "show(m); show(s); show(set(s))\n";
  }
  EXPECT_EQ(printed(interpreter, program), expected);
}

INSTANTIATE_TEST_SUITE_P(Pythons, RealTables,
                         testing::Values(Interpreter{CellOrder::python_2_7, "python2.7", "2, 7"},
                                         Interpreter{CellOrder::python_3_4, "python3.4", "3, 4"},
                                         Interpreter{CellOrder::python_3_5, "python3.5", "3, 5"}),
                         [](const auto& one) { return "v" + std::string(one.param.version).replace(1, 2, "_"); });

}  // namespace
}  // namespace labmouse
