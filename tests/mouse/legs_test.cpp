#include "labmouse/mouse/legs.hpp"

#include <gtest/gtest.h>

namespace labmouse {
namespace {

Path joined(const Path& first, const Path& second) {
  Path path;
  join_legs(first, second, path);
  return path;
}

//    y 3           1---1---1
//                  |       |      The first path (1) is shorter before the crossing at (2,1), the second (2) behind it.
//    y 2           1       1
//                  |       |
//    y 1   S---1---+---2---E
//          |       |
//    y 0   2---2---2
TEST(JoinLegs, TakesTheShorterLegOfEachTwoCrossings) {
  const Path first = {{0, 1}, {1, 1}, {2, 1}, {2, 2}, {2, 3}, {3, 3}, {4, 3}, {4, 2}, {4, 1}};
  const Path second = {{0, 1}, {0, 0}, {1, 0}, {2, 0}, {2, 1}, {3, 1}, {4, 1}};
  const Path best = {{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}};
  EXPECT_EQ(joined(first, second), best);
  EXPECT_EQ(joined(second, first), best);
}

TEST(JoinLegs, KeepsTheFirstPathsLegWhereBothAreEquallyLong) {
  const Path first = {{0, 0}, {0, 1}, {1, 1}}, second = {{0, 0}, {1, 0}, {1, 1}};
  EXPECT_EQ(joined(first, second), first);
  EXPECT_EQ(joined(second, first), second);
}

TEST(JoinLegs, CountsNoCellThatLiesBeforeTheLastCrossing) {
  // (1,0) is on both paths, but the second has it before (1,1), where both crossed already.
  const Path first = {{0, 0}, {0, 1}, {1, 1}, {1, 0}, {2, 0}, {2, 1}}, second = {{0, 0}, {1, 0}, {1, 1}, {2, 1}};
  EXPECT_EQ(joined(first, second), (Path{{0, 0}, {0, 1}, {1, 1}, {2, 1}}));
}

TEST(JoinLegs, LeavesOneCellAlone) { EXPECT_EQ(joined({{4, 2}}, {{4, 2}}), (Path{{4, 2}})); }

}  // namespace
}  // namespace labmouse
