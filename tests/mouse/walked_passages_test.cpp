#include "labmouse/mouse/walked_passages.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace labmouse {
namespace {

constexpr Size size{4, 4};

std::vector<Cell> from(const WalkedPassages& passages, Cell cell) {
  std::vector<Cell> cells;
  passages.from(cell, [&](Cell to) { cells.push_back(to); });
  return cells;
}

TEST(WalkedPassages, HasAnEdgeInEachDirectionInTheOrderOfWalking) {
  WalkedPassages passages(size, 100);
  passages.walk({2, 2}, {2, 3});
  passages.walk({2, 3}, {3, 3});
  passages.walk({3, 3}, {2, 3});
  passages.walk({2, 3}, {2, 2});
  passages.walk({2, 2}, {1, 2});
  EXPECT_EQ(from(passages, {2, 2}), (std::vector<Cell>{{2, 3}, {2, 3}, {1, 2}}));
  EXPECT_EQ(from(passages, {2, 3}), (std::vector<Cell>{{2, 2}, {3, 3}, {3, 3}, {2, 2}}));
  EXPECT_EQ(from(passages, {0, 0}), std::vector<Cell>{});
  EXPECT_EQ(passages.edges(), 10U);
}

TEST(WalkedPassages, AddsNoEdgeByWalkingOutOfTheCellOfTheSlipOrOfOneThatLeadsToIt) {
  WalkedPassages passages(size, 100);
  ASSERT_EQ(WalkedPassages::slip, (Cell{1, 0}));
  passages.walk({0, 0}, {1, 0});
  EXPECT_TRUE(passages.has({0, 0}, {1, 0}));
  EXPECT_TRUE(passages.has({1, 0}, {0, 0}));
  passages.walk({1, 0}, {1, 1});
  EXPECT_FALSE(passages.has({1, 0}, {1, 1}));
  EXPECT_TRUE(passages.has({1, 1}, {1, 0}));
  passages.walk({1, 1}, {1, 2});  // (1,1) leads to the slip
  EXPECT_FALSE(passages.has({1, 1}, {1, 2}));
  EXPECT_TRUE(passages.has({1, 2}, {1, 1}));
  passages.walk({1, 2}, {1, 1});
  EXPECT_TRUE(passages.has({1, 1}, {1, 2}));
  passages.walk({1, 1}, {1, 0});
  EXPECT_TRUE(passages.has({1, 0}, {1, 1}));
}

TEST(WalkedPassages, StoresRepeatsAsLongAsItPromised) {
  WalkedPassages passages(size, 3);
  const std::size_t most = passages.most_edges();
  for (int i = 0; i < 1000; ++i) {
    passages.walk({2, 2}, {2, 3});
    passages.walk({3, 3}, {2, 3});
  }
  EXPECT_EQ(passages.edges(), 4U + 6U);
  EXPECT_EQ(passages.most_edges(), most);
  passages.walk({2, 2}, {3, 2});
  EXPECT_TRUE(passages.has({2, 2}, {3, 2}));
  EXPECT_TRUE(passages.has({3, 2}, {2, 2}));
}

}  // namespace
}  // namespace labmouse
