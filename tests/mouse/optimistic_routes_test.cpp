#include <gtest/gtest.h>

#include "labmouse/mouse/optimistic_routes.hpp"

namespace labmouse {
namespace {

Briefing three_by_two() {
  Briefing briefing;
  briefing.size = {3, 2};
  briefing.goals.insert({2, 1});
  return briefing;
}

TEST(OptimisticRoutes, TakeEveryWallForOpenThatIsNotKnownToBeClosed) {
  OptimisticRoutes routes(three_by_two());
  Knowledge knowledge({3, 2});
  routes.plan(knowledge);
  EXPECT_EQ(routes.length(), 2);
  // North and then two east, or two east and then north: all walls but the one in the middle.
  WallSet walls = WallSet::all({3, 2});
  walls.erase(wall_at({1, 0}, Heading::north));
  EXPECT_EQ(routes.unknown_walls(), walls);
}

TEST(OptimisticRoutes, LeaveOutWhatIsKnown) {
  OptimisticRoutes routes(three_by_two());
  Knowledge knowledge({3, 2});
  ASSERT_TRUE(knowledge.learn({{0, 0}, Heading::north}, {0, 1, 0}));
  routes.plan(knowledge);
  EXPECT_EQ(routes.length(), 2);
  WallSet walls;
  for (const Cell cell : {Cell{0, 1}, Cell{1, 1}}) walls.insert(wall_at(cell, Heading::east));
  EXPECT_EQ(routes.unknown_walls(), walls);
}

TEST(OptimisticRoutes, AreNoneWhereTheStartIsClosedIn) {
  OptimisticRoutes routes(three_by_two());
  Knowledge knowledge({3, 2});
  ASSERT_TRUE(knowledge.learn({{0, 0}, Heading::north}, {0, 0, 0}));
  routes.plan(knowledge);
  EXPECT_EQ(routes.length(), unreachable);
  EXPECT_TRUE(routes.unknown_walls().empty());
}

}  // namespace
}  // namespace labmouse
