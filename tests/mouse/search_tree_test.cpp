#include "labmouse/mouse/search_tree.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/mouse/visits.hpp"

namespace labmouse {
namespace {

constexpr Size size{16, 16};

WallSet passages_of(std::uint64_t seed) { return prim_generator.make({size, seed, 300}).open_walls(); }

TEST(SearchTree, AgreesWithTheDistanceFieldInEveryOrder) {
  for (int longest = 1; longest <= 3; ++longest) {
    const WallSet passages = passages_of(static_cast<std::uint64_t>(longest));
    DistanceField field(size, strides(longest));
    CellSet root;
    root.insert({3, 7});
    field.fill(passages, root);
    for (const auto order : {"nesw", "wsen", "alrb", "brla"})
      for (const auto reach : {SearchTree::Reach::nearest_first, SearchTree::Reach::farthest_first}) {
        SearchTree tree(size, longest, TieOrder(order), reach);
        tree.grow(passages, {{3, 7}, Heading::west});
        for (int index = 0; index < size.area(); ++index)
          ASSERT_EQ(tree.distance(size.cell_at(index)), field.at(size.cell_at(index)));
      }
  }
}

TEST(SearchTree, FindsCellsInTheOrderOfItsDirections) {
  const WallSet open = WallSet::all({3, 3});
  SearchTree compass({3, 3}, 1, TieOrder("wsen"));
  compass.grow(open, {{1, 1}, Heading::north});
  EXPECT_EQ(std::vector<Cell>(compass.found().begin(), compass.found().begin() + 5),
            (std::vector<Cell>{{1, 1}, {0, 1}, {1, 0}, {2, 1}, {1, 2}}));
  // Facing south, ahead is south and left is east.
  SearchTree facing({3, 3}, 1, TieOrder("alrb"));
  facing.grow(open, {{1, 1}, Heading::south});
  EXPECT_EQ(std::vector<Cell>(facing.found().begin(), facing.found().begin() + 5),
            (std::vector<Cell>{{1, 1}, {1, 0}, {2, 1}, {0, 1}, {1, 2}}));
}

TEST(SearchTree, PassesOnlyTheCellsThatItMay) {
  // The root and (1,0) may be passed; (2,0) may only be a route's end.
  const WallSet open = WallSet::all({4, 1});
  CellSet through;
  through.insert({1, 0});
  SearchTree tree({4, 1}, 1, TieOrder("nesw"));
  tree.grow(open, {{0, 0}, Heading::east}, through);
  EXPECT_EQ(tree.distance({2, 0}), 2);
  EXPECT_FALSE(tree.reaches({3, 0}));
}

TEST(SearchTree, TakesOnlyMovesThatWereSeenAsAWhole) {
  // A corridor of five cells, seen from its middle to either end.
  ConnectedCells moves({5, 1}, 3, CellOrder::rows);
  moves.learn({{2, 0}, Heading::east}, {0, 2, 0});
  moves.learn({{2, 0}, Heading::west}, {0, 2, 0});
  SearchTree tree({5, 1}, 3, TieOrder("nesw"));
  tree.grow(moves, {{1, 0}, Heading::east});
  EXPECT_EQ(tree.distance({0, 0}), 1);
  EXPECT_EQ(tree.distance({2, 0}), 1);
  EXPECT_EQ(tree.distance({3, 0}), 2);
  EXPECT_EQ(tree.before({4, 0}), (Cell{2, 0}));
}

TEST(SearchTree, PrefersTheReachThatItWasMadeWith) {
  const WallSet open = WallSet::all({4, 1});
  SearchTree nearest({4, 1}, 3, TieOrder("nesw")),
      farthest({4, 1}, 3, TieOrder("nesw"), SearchTree::Reach::farthest_first);
  nearest.grow(open, {{0, 0}, Heading::east});
  farthest.grow(open, {{0, 0}, Heading::east});
  EXPECT_EQ(nearest.found()[1], (Cell{1, 0}));
  EXPECT_EQ(farthest.found()[1], (Cell{3, 0}));
}

TEST(SearchTree, LeadsAlongShortestMoves) {
  const WallSet passages = passages_of(9);
  SearchTree tree(size, 3, TieOrder("nesw"));
  tree.grow(passages, {{0, 0}, Heading::north});
  for (const Cell cell : tree.found()) {
    if (cell == Cell{0, 0}) continue;
    EXPECT_EQ(tree.distance(tree.before(cell)) + 1, tree.distance(cell));
    EXPECT_EQ(tree.distance(tree.first_towards(cell)), 1);
    const Move move = move_between(tree.before(cell), cell);
    EXPECT_LE(move.cells, 3);
    EXPECT_EQ(neighbour(tree.before(cell), move.direction, move.cells), cell);
  }
}

TEST(TieOrder, NamesEachOrderOnce) {
  std::set<std::string> names;
  for (std::size_t at = 0; at < TieOrder::all.size(); at += 5) names.emplace(TieOrder::all.substr(at, 4));
  EXPECT_EQ(names.size(), 48U);
  for (const std::string& name : names) {
    std::set<Heading> headings;
    for (const Heading heading : TieOrder(name).from(Heading::east)) headings.insert(heading);
    EXPECT_EQ(headings.size(), 4U) << name;
  }
  EXPECT_EQ(TieOrder("arbl").from(Heading::east),
            (std::array{Heading::east, Heading::south, Heading::west, Heading::north}));
}

TEST(Visits, AreCountedCellByCell) {
  Visits visits({4, 4});
  visits.add({1, 2});
  visits.add({1, 2});
  EXPECT_EQ(visits.of({1, 2}), 2);
  EXPECT_EQ(visits.of({2, 1}), 0);
  visits.clear();
  EXPECT_EQ(visits.of({1, 2}), 0);
}

}  // namespace
}  // namespace labmouse
