#include "labmouse/lab/league/ranking.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using testing::ElementsAre;

constexpr int mazes = 20;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Shares about a mean: in every other maze they are `apart` above and below it.
MouseShares mouse(const std::string& name, double mean, double apart) {
  MouseShares shares{name, {}};
  for (int maze = 0; maze < mazes; ++maze) shares.shares.push_back(mean + (maze % 2 == 0 ? apart : -apart));
  return shares;
}

TEST(Ranking, GivesMiceThatCannotBeToldApartOneRank) {
  const Ranking ranking = rank_mice(
      {mouse("far", 0.3, 0.01), mouse("best", 0.8, 0.01), mouse("near", 0.79, -0.2), mouse("last", 0.29, -0.2)});
  ASSERT_EQ(ranking.mice.size(), 4U);
  const std::vector<std::pair<std::string, int>> expected = {{"best", 1}, {"near", 1}, {"far", 3}, {"last", 3}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(ranking.mice[i].name, expected[i].first);
    EXPECT_EQ(ranking.mice[i].rank, expected[i].second);
  }
  EXPECT_THAT(lines_of(groups_text(ranking)), ElementsAre(Says("1", "best", "near"), Says("3", "far", "last")));
  EXPECT_EQ(ranking.mice[0].place, 1U);
  EXPECT_NEAR(ranking.mice[0].mean, 0.8, 1e-9);
  EXPECT_LT(ranking.mice[0].interval.low, 0.8);
  EXPECT_GT(ranking.mice[0].interval.high, 0.8);
}

// Each is like its neighbour, but the last is not like the first: a rank is compared with its best mouse.
TEST(Ranking, ComparesWithTheBestOfItsRank) {
  const Ranking ranking = rank_mice({mouse("a", 0.80, 0.0), mouse("b", 0.74, 0.12), mouse("c", 0.68, -0.02)});
  EXPECT_EQ(ranking.pairs[0][1].verdict, TestVerdict::no_difference);
  EXPECT_EQ(ranking.pairs[1][2].verdict, TestVerdict::no_difference);
  EXPECT_EQ(ranking.pairs[0][2].verdict, TestVerdict::better);
  EXPECT_EQ(ranking.mice[1].rank, 1);
  EXPECT_EQ(ranking.mice[2].rank, 3);
}

TEST(Ranking, HasEachPairFromBothSides) {
  const Ranking ranking = rank_mice({mouse("b", 0.3, 0.01), mouse("a", 0.8, 0.02)});
  EXPECT_NEAR(ranking.pairs[0][1].difference, 0.5, 1e-9);
  EXPECT_NEAR(ranking.pairs[1][0].difference, -0.5, 1e-9);
  EXPECT_EQ(ranking.pairs[0][1].interval.low, -ranking.pairs[1][0].interval.high);
  EXPECT_GT(ranking.pairs[0][1].interval.low, 0.4);
  EXPECT_EQ(ranking.pairs[0][1].verdict, TestVerdict::better);
  EXPECT_EQ(ranking.pairs[1][0].verdict, TestVerdict::worse);
}

TEST(Ranking, OrdersEqualMiceByName) {
  const Ranking ranking = rank_mice({mouse("b", 0.5, 0.1), mouse("a", 0.5, 0.1)});
  EXPECT_EQ(ranking.mice[0].name, "a");
  EXPECT_EQ(ranking.mice[1].rank, 1);
  EXPECT_EQ(ranking.pairs[0][1].verdict, TestVerdict::no_difference);
}

TEST(Ranking, TellsNobodyApartInFewMazes) {
  const Ranking ranking = rank_mice({{"a", {1.0, 1.0}}, {"b", {0.0, 0.0}}});
  EXPECT_EQ(ranking.mice[1].rank, 1);
  EXPECT_EQ(ranking.pairs[0][1].verdict, TestVerdict::too_few);
  EXPECT_EQ(lines_of(groups_text(ranking)).size(), 2U) << "no word of more mazes";
}

}  // namespace
}  // namespace labmouse
