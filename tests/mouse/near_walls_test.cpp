#include "labmouse/mouse/near_walls.hpp"

#include <gtest/gtest.h>

namespace labmouse {
namespace {

TEST(NearWalls, KnowPassagesBetweenCellsStoodIn) {
  NearWalls walls({1, 1});
  walls.arrive({{1, 1}, Heading::north}, {1, 3, 1});
  EXPECT_TRUE(walls.open().empty());  // seen, but nowhere stood in yet
  walls.arrive({{2, 1}, Heading::east}, {1, 1, 0});
  walls.arrive({{2, 2}, Heading::north}, {1, 0, 0});
  walls.arrive({{1, 2}, Heading::west}, {1, 0, 1});
  EXPECT_EQ(walls.open().count(), 4);
  EXPECT_TRUE(walls.open().contains(wall_at({1, 2}, Heading::south)));
  EXPECT_EQ(walls.stood_in().count(), 4);
}

TEST(NearWalls, KnowWhatAStrideWentThrough) {
  NearWalls walls({0, 0});
  walls.arrive({{0, 0}, Heading::north}, {0, 3, 3});
  walls.arrive({{0, 3}, Heading::north}, {0, 0, 2});
  EXPECT_EQ(walls.open().count(), 3);
  EXPECT_FALSE(walls.stood_in().contains({0, 1}));
}

TEST(NearWalls, LearnNothingFromASecondLook) {
  NearWalls walls({1, 1});
  walls.arrive({{1, 1}, Heading::north}, {0, 1, 0});
  walls.arrive({{1, 2}, Heading::north}, {0, 0, 0});
  const WallSet before = walls.open();
  walls.arrive({{1, 2}, Heading::east}, {0, 0, 1});
  walls.arrive({{1, 2}, Heading::south}, {0, 1, 0});
  EXPECT_EQ(walls.open(), before);
}

}  // namespace
}  // namespace labmouse
