#include <gtest/gtest.h>

#include "labmouse/mouse/sighted_moves.hpp"

namespace labmouse {
namespace {

constexpr Size size{8, 8};

TEST(SightedMoves, KnowsThoseOfACorridorInBothDirections) {
  SightedMoves moves(size, 3);
  moves.learn({{1, 0}, Heading::north}, {0, 5, 0});
  EXPECT_EQ(moves.longest({1, 0}, Heading::north), 3);
  EXPECT_EQ(moves.longest({1, 3}, Heading::north), 2);
  EXPECT_EQ(moves.longest({1, 5}, Heading::north), 0);
  EXPECT_EQ(moves.longest({1, 5}, Heading::south), 3);
  EXPECT_EQ(moves.longest({1, 1}, Heading::south), 1);
  EXPECT_EQ(moves.longest({1, 0}, Heading::south), 0);
  EXPECT_EQ(moves.longest({1, 1}, Heading::east), 0);
}

TEST(SightedMoves, LearnsAlongAllThreeSidesOfTheMouse) {
  SightedMoves moves(size, 8);
  moves.learn({{4, 4}, Heading::east}, {1, 2, 3});
  EXPECT_EQ(moves.longest({4, 4}, Heading::north), 1);
  EXPECT_EQ(moves.longest({4, 4}, Heading::east), 2);
  EXPECT_EQ(moves.longest({4, 4}, Heading::south), 3);
  EXPECT_EQ(moves.longest({4, 4}, Heading::west), 0);
  EXPECT_EQ(moves.longest({6, 4}, Heading::west), 2);
}

TEST(SightedMoves, DoesNotJoinWhatTwoReadingsShow) {
  SightedMoves moves(size, 3);
  moves.learn({{2, 3}, Heading::north}, {0, 2, 0});
  moves.learn({{2, 3}, Heading::south}, {0, 2, 0});
  EXPECT_EQ(moves.longest({2, 1}, Heading::north), 2);
  EXPECT_EQ(moves.longest({2, 2}, Heading::north), 1);
  EXPECT_EQ(moves.longest({2, 4}, Heading::south), 1);
  moves.learn({{2, 1}, Heading::north}, {0, 4, 0});
  EXPECT_EQ(moves.longest({2, 1}, Heading::north), 3);
  EXPECT_EQ(moves.longest({2, 2}, Heading::north), 3);
}

TEST(SightedMoves, ForgetsNoneForAShorterReading) {
  SightedMoves moves(size, 3);
  moves.learn({{0, 0}, Heading::east}, {0, 3, 0});
  moves.learn({{0, 0}, Heading::east}, {0, 1, 0});
  EXPECT_EQ(moves.longest({0, 0}, Heading::east), 3);
}

}  // namespace
}  // namespace labmouse
