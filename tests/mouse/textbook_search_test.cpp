#include "labmouse/mouse/textbook_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "labmouse/chance/rng.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/mouse/search_tree.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

constexpr std::array all_methods = {SearchMethod::breadth_first, SearchMethod::a_star, SearchMethod::dijkstra};
constexpr Size size{16, 16};
constexpr Pose corner{{0, 0}, Heading::north};

WallSet passages_of(std::uint64_t seed) { return prim_generator.make({size, seed, 300}).open_walls(); }

CellSet only(Cell cell) {
  CellSet cells;
  cells.insert(cell);
  return cells;
}

/// All passages walked, both ways; from each cell in the order of the directions.
WalkedPassages walked(Size of, const WallSet& open, std::string_view order = "nesw") {
  WalkedPassages passages(of, 2 * of.area());
  for (int index = 0; index < of.area(); ++index)
    for (const Heading direction : TieOrder(order).from(Heading::north))
      if (const Cell cell = of.cell_at(index); open.contains(wall_at(cell, direction)))
        passages.walk(cell, neighbour(cell, direction));
  return passages;
}

/// A random walk until every passage was walked both ways.
WalkedPassages walked_at_random(const Maze& maze, std::uint64_t seed) {
  constexpr int most = 1'000'000;
  WalkedPassages passages(maze.size(), most / 10);
  Rng rng(seed);
  Cell here = maze.start();
  for (std::size_t left = 2 * static_cast<std::size_t>(maze.open_walls().count()), steps = 0; left > 0 && steps < most;
       ++steps) {
    const Heading direction = all_headings[static_cast<std::size_t>(rng.below(4))];
    if (!maze.is_open(here, direction)) continue;
    const Cell next = neighbour(here, direction);
    const auto known = [&] { return passages.has(here, next) + passages.has(next, here); };
    const int before = known();
    passages.walk(here, next);
    left -= static_cast<std::size_t>(known() - before);
    here = next;
  }
  return passages;
}

TextbookSearch searched(const WalkedPassages& passages, SearchMethod method, Cell start, const CellSet& goals) {
  TextbookSearch search(passages.size(), passages.most_edges(), method);
  EXPECT_TRUE(search.search(passages, start, goals));
  return search;
}

std::vector<Heading> way_of(const TextbookSearch& search) { return {search.way().begin(), search.way().end()}; }

std::vector<Move> merged(const std::vector<Heading>& way, int longest) {
  std::vector<Move> moves;
  merge_strides(way, longest, moves);
  return moves;
}

/// What the report prints for each test maze, and the least and the most that A* finds after other walks.
struct Reported {
  int maze, path_cost, breadth_first, a_star, a_star_least, a_star_most;
};

void PrintTo(const Reported& reported, std::ostream* out) { *out << "maze " << reported.maze; }

class ReportedSearch : public testing::TestWithParam<Reported> {
 protected:
  void SetUp() override {
    maze_ = test::capstone_maze(GetParam().maze);
    if (!maze_) GTEST_SKIP() << "the file of test maze " << GetParam().maze << " is not here";
  }
  std::optional<Maze> maze_;
};

// The counts of A* depend on the order in which the passages were walked; those that the report prints are samples.
TEST_P(ReportedSearch, FindsAsManyCellsAfterAnyWalk) {
  LABMOUSE_SKIP_SANITIZED();
  const Reported& reported = GetParam();
  int printed = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const WalkedPassages passages = walked_at_random(*maze_, seed);
    const auto by = [&](SearchMethod method) { return searched(passages, method, maze_->start(), maze_->goals()); };
    const TextbookSearch breadth_first = by(SearchMethod::breadth_first), a_star = by(SearchMethod::a_star);
    EXPECT_EQ(breadth_first.found(), reported.breadth_first);
    EXPECT_EQ(static_cast<int>(breadth_first.way().size()), reported.path_cost);
    EXPECT_GE(a_star.found(), reported.a_star_least);
    EXPECT_LE(a_star.found(), reported.a_star_most);
    EXPECT_LE(static_cast<int>(a_star.way().size()), reported.path_cost + 1);
    printed += a_star.found() == reported.a_star;
  }
  EXPECT_EQ(printed > 0, reported.maze != 2);  // in maze 2 the report's mouse had not walked everything
}

INSTANTIATE_TEST_SUITE_P(TestMazes, ReportedSearch,
                         testing::Values(Reported{1, 30, 143, 141, 141, 141}, Reported{2, 43, 195, 191, 193, 193},
                                         Reported{3, 49, 255, 249, 247, 250}));

TEST(TextbookSearch, OnTestMaze1MergesIntoThePrintedMovesAfterSomeWalk) {
  const Maze maze = test::capstone_maze(1).value();
  const std::vector<Action> printed = [] {
    std::vector<Action> actions;
    for (const auto& [rotation, movement] : std::initializer_list<std::pair<int, int>>{{0, 2},
                                                                                       {90, 1},
                                                                                       {90, 2},
                                                                                       {-90, 3},
                                                                                       {-90, 2},
                                                                                       {90, 2},
                                                                                       {90, 1},
                                                                                       {-90, 1},
                                                                                       {90, 1},
                                                                                       {-90, 1},
                                                                                       {0, 3},
                                                                                       {-90, 3},
                                                                                       {-90, 3},
                                                                                       {90, 2},
                                                                                       {-90, 1},
                                                                                       {90, 1},
                                                                                       {-90, 1}})
      actions.push_back(Action::step(rotation, movement));
    return actions;
  }();
  // There are several shortest ways; which one is found depends on the order of walking.
  for (const SearchMethod method : {SearchMethod::breadth_first, SearchMethod::a_star}) {
    bool found = false;
    for (std::size_t order = 0; order < 24 * 5; order += 5) {
      const WalkedPassages passages = walked(maze.size(), maze.open_walls(), TieOrder::all.substr(order, 4));
      std::vector<Action> actions;
      Heading heading = maze.start_heading();
      for (const Move& move : merged(way_of(searched(passages, method, maze.start(), maze.goals())), 3)) {
        actions.push_back(move_in(heading, move.direction, move.cells));
        heading = move.direction;
      }
      found |= actions == printed;
    }
    EXPECT_TRUE(found);
  }
}

TEST(TextbookSearch, LeadsThroughPassagesToAGoal) {
  for (const SearchMethod method : all_methods)
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const WallSet open = passages_of(seed);
      Cell cell = corner.cell;
      for (const Heading direction : way_of(searched(walked(size, open), method, cell, only({9, 12})))) {
        ASSERT_TRUE(open.contains(wall_at(cell, direction)));
        cell = neighbour(cell, direction);
      }
      EXPECT_EQ(cell, (Cell{9, 12}));
    }
}

TEST(TextbookSearch, BreadthFirstAndDijkstraFindTheShortestWay) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const WallSet open = passages_of(seed);
    SearchTree tree(size, 1, TieOrder("wsen"));
    tree.grow(open, corner);
    for (const SearchMethod method : {SearchMethod::breadth_first, SearchMethod::dijkstra}) {
      const TextbookSearch search = searched(walked(size, open), method, corner.cell, only({12, 5}));
      EXPECT_EQ(static_cast<int>(search.way().size()), tree.distance({12, 5}));
      EXPECT_EQ(search.found(), 255);
    }
  }
}

TEST(TextbookSearch, AmongSeveralGoalsGoesToTheNearest) {
  CellSet goals = only({5, 0});
  goals.insert({0, 2});
  for (const SearchMethod method : all_methods)
    EXPECT_EQ(way_of(searched(walked({6, 6}, WallSet::all({6, 6})), method, corner.cell, goals)),
              (std::vector{Heading::north, Heading::north}));
}

TEST(TextbookSearch, AStarTakesTheStraightCellsFirst) {
  // In the open, the edges straight ahead wait in front of all those behind a turn.
  const WalkedPassages open = walked({3, 3}, WallSet::all({3, 3}));
  // North and east of the start, and the second to the north.
  EXPECT_EQ(searched(open, SearchMethod::a_star, corner.cell, only({0, 2})).found(), 3);
  // (1,1) is behind a turn on both ways: the four cells straight ahead come before it.
  EXPECT_EQ(searched(open, SearchMethod::a_star, corner.cell, only({1, 1})).found(), 5);
}

TEST(TextbookSearch, AStarStopsInAGoalAndTheOthersDoNot) {
  const WalkedPassages open = walked({3, 3}, WallSet::all({3, 3}));
  EXPECT_EQ(searched(open, SearchMethod::a_star, corner.cell, only({0, 1})).found(), 1);
  EXPECT_EQ(searched(open, SearchMethod::breadth_first, corner.cell, only({0, 1})).found(), 8);
  EXPECT_EQ(searched(open, SearchMethod::dijkstra, corner.cell, only({0, 1})).found(), 8);
}

TEST(TextbookSearch, BreadthFirstKeepsTheOrderOfWalking) {
  for (const std::string_view order : {"nesw", "esnw"}) {
    const WalkedPassages open = walked({2, 2}, WallSet::all({2, 2}), order);
    EXPECT_EQ(way_of(searched(open, SearchMethod::breadth_first, corner.cell, only({1, 1}))).front(),
              order == "nesw" ? Heading::north : Heading::east);
  }
}

TEST(TextbookSearch, KnowsWhereThereIsNoWay) {
  const WalkedPassages nothing({3, 3}, 10);
  for (const SearchMethod method : all_methods) {
    TextbookSearch search({3, 3}, nothing.most_edges(), method);
    EXPECT_FALSE(search.search(nothing, corner.cell, only({2, 2})));
    EXPECT_TRUE(search.way().empty());
    EXPECT_EQ(search.found(), 0);
    EXPECT_TRUE(search.search(nothing, corner.cell, only({0, 0})));
    EXPECT_TRUE(search.way().empty());
  }
}

TEST(MergeStrides, LeavesTheShortMoveOfARunAtItsBeginning) {
  const std::vector<Heading> way = {Heading::north, Heading::north, Heading::north, Heading::north, Heading::north,
                                    Heading::east,  Heading::north, Heading::north, Heading::north};
  EXPECT_EQ(merged(way, 3),
            (std::vector<Move>{{Heading::north, 2}, {Heading::north, 3}, {Heading::east, 1}, {Heading::north, 3}}));
  EXPECT_EQ(merged(way, 8), (std::vector<Move>{{Heading::north, 5}, {Heading::east, 1}, {Heading::north, 3}}));
  EXPECT_EQ(merged(way, 1).size(), 9U);
  EXPECT_TRUE(merged({}, 3).empty());
}

}  // namespace
}  // namespace labmouse
