#include "labmouse/mouse/knowledge.hpp"

#include <gtest/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {

void PrintTo(WallState state, std::ostream* out) {
  *out << (state == WallState::open ? "open" : state == WallState::closed ? "closed" : "unknown");
}

namespace {

/// A mouse that knows nothing yet of a maze of five by four cells and stands in (1,1), heading north.
class ANewMouse : public testing::Test {
 protected:
  [[nodiscard]] bool sees(int left, int ahead, int right, Pose pose = {{1, 1}, Heading::north}) {
    return knowledge_.learn(pose, {left, ahead, right});
  }
  WallState wall(int x, int y, Heading side) const { return knowledge_.state(wall_at({x, y}, side)); }

  Knowledge knowledge_{Size{5, 4}};
};

TEST_F(ANewMouse, KnowsTheBorderFromBirth) {
  for (int x = 0; x < 5; ++x) {
    EXPECT_EQ(wall(x, 0, Heading::south), WallState::closed);
    EXPECT_EQ(wall(x, 3, Heading::north), WallState::closed);
  }
  for (int y = 0; y < 4; ++y) {
    EXPECT_EQ(wall(0, y, Heading::west), WallState::closed);
    EXPECT_EQ(wall(4, y, Heading::east), WallState::closed);
  }
}

TEST_F(ANewMouse, KnowsACellByAllItsWalls) {
  EXPECT_TRUE(knowledge_.known_cells().empty());
  ASSERT_TRUE(sees(0, 0, 0));
  EXPECT_FALSE(knowledge_.knows({1, 1}));
  ASSERT_TRUE(sees(0, 0, 0, {{1, 1}, Heading::south}));
  EXPECT_EQ(knowledge_.known_cells(), CellSet::of({1, 1}));
  EXPECT_TRUE(knowledge_.knows({1, 1}));
  // In the corner the border is known from birth.
  ASSERT_TRUE(sees(0, 1, 0, {{3, 3}, Heading::east}));
  EXPECT_FALSE(knowledge_.knows({4, 3}));
  ASSERT_TRUE(sees(0, 0, 0, {{4, 3}, Heading::east}));
  EXPECT_TRUE(knowledge_.knows({4, 3}));
  CellSet::all({5, 4}).for_each([&](Cell cell) {
    EXPECT_EQ(knowledge_.knows(cell), knowledge_.known_cells().contains(cell)) << cell.x << cell.y;
  });
}

TEST_F(ANewMouse, KnowsNoInnerWall) {
  EXPECT_EQ(knowledge_.unknown(), WallSet::all({5, 4}));
  EXPECT_TRUE(knowledge_.open().empty());
}

TEST_F(ANewMouse, LearnsAClosedWallFromBothSides) {
  ASSERT_TRUE(sees(0, 0, 0));
  EXPECT_EQ(wall(1, 1, Heading::north), WallState::closed);
  EXPECT_EQ(wall(1, 2, Heading::south), WallState::closed);
  EXPECT_EQ(wall(1, 1, Heading::west), WallState::closed);
  EXPECT_EQ(wall(0, 1, Heading::east), WallState::closed);
}

TEST_F(ANewMouse, LearnsAnOpenWallFromBothSides) {
  ASSERT_TRUE(sees(0, 0, 1));
  EXPECT_EQ(wall(1, 1, Heading::east), WallState::open);
  EXPECT_EQ(wall(2, 1, Heading::west), WallState::open);
}

TEST_F(ANewMouse, LearnsTheWholeCorridorAndTheWallAtItsEnd) {
  ASSERT_TRUE(sees(0, 0, 2));
  EXPECT_EQ(wall(1, 1, Heading::east), WallState::open);
  EXPECT_EQ(wall(2, 1, Heading::east), WallState::open);
  EXPECT_EQ(wall(3, 1, Heading::east), WallState::closed);
}

/// The same mouse, which looks no farther than two cells.
class AShortSightedMouse : public ANewMouse {
 protected:
  AShortSightedMouse() { knowledge_ = Knowledge(Size{5, 4}, 2); }
};

TEST_F(AShortSightedMouse, LearnsNoWallWhereItsSightEnds) {
  ASSERT_TRUE(sees(0, 0, 2));
  EXPECT_EQ(wall(1, 1, Heading::east), WallState::open);
  EXPECT_EQ(wall(2, 1, Heading::east), WallState::open);
  EXPECT_EQ(wall(3, 1, Heading::east), WallState::unknown);
}

TEST_F(AShortSightedMouse, LearnsTheWallThatEndsACorridorInSight) {
  ASSERT_TRUE(sees(0, 1, 0));
  EXPECT_EQ(wall(1, 1, Heading::north), WallState::open);
  EXPECT_EQ(wall(1, 2, Heading::north), WallState::closed);
}

TEST_F(AShortSightedMouse, AgreesWithAReadingThatEndsBeforeAnOpenWall) {
  ASSERT_TRUE(sees(2, 0, 1, {{3, 1}, Heading::north}));
  ASSERT_EQ(wall(3, 1, Heading::east), WallState::open);
  EXPECT_TRUE(sees(0, 0, 2));
  EXPECT_TRUE(sees(0, 0, 2));
}

TEST_F(AShortSightedMouse, DoesNotBelieveAReadingBeyondItsSight) {
  EXPECT_FALSE(sees(0, 0, 3));
  EXPECT_EQ(knowledge_.unknown(), WallSet::all({5, 4}));
}

TEST_F(ANewMouse, LearnsNothingOfTheWallBehind) {
  ASSERT_TRUE(sees(0, 0, 0));
  EXPECT_EQ(wall(1, 1, Heading::south), WallState::unknown);
}

TEST_F(ANewMouse, LearnsNothingBesidesTheCorridors) {
  ASSERT_TRUE(sees(1, 2, 3));
  // One open wall to the left, two ahead, three to the right; all three corridors end at the border.
  EXPECT_EQ(knowledge_.open().count(), 6);
  EXPECT_EQ(knowledge_.unknown().count(), WallSet::all({5, 4}).count() - 6);
}

TEST_F(ANewMouse, LeftAndRightTurnWithTheMouse) {
  ASSERT_TRUE(sees(1, 0, 0, {{2, 2}, Heading::west}));
  EXPECT_EQ(wall(2, 2, Heading::south), WallState::open);
  EXPECT_EQ(wall(2, 2, Heading::north), WallState::closed);
}

TEST_F(ANewMouse, UnknownWallsArePossibleButNotOpen) {
  EXPECT_EQ(knowledge_.possible(), WallSet::all({5, 4}));
  ASSERT_TRUE(sees(0, 1, 0));
  EXPECT_TRUE(knowledge_.possible().contains(wall_at({1, 1}, Heading::north)));
  EXPECT_TRUE(knowledge_.possible().contains(wall_at({1, 1}, Heading::south)));
  EXPECT_FALSE(knowledge_.possible().contains(wall_at({1, 1}, Heading::east)));
}

/// The same mouse after it has seen a passage to the east that is two cells long.
class AMouseThatHasSeenAPassage : public ANewMouse {
 protected:
  AMouseThatHasSeenAPassage() { EXPECT_TRUE(sees(0, 1, 2)); }

  /// The reading is refused and has left no trace.
  void refuses(int left, int ahead, int right, Pose pose = {{1, 1}, Heading::north}) {
    const WallSet open = knowledge_.open(), possible = knowledge_.possible();
    EXPECT_FALSE(sees(left, ahead, right, pose));
    EXPECT_EQ(knowledge_.open(), open);
    EXPECT_EQ(knowledge_.possible(), possible);
  }
};

TEST_F(AMouseThatHasSeenAPassage, AcceptsTheSameAgain) {
  EXPECT_TRUE(sees(0, 1, 2));
  EXPECT_TRUE(sees(2, 0, 0, {{3, 1}, Heading::north}));
}

TEST_F(AMouseThatHasSeenAPassage, RefusesAWallWhereItSawAPassage) { refuses(0, 1, 1); }

TEST_F(AMouseThatHasSeenAPassage, RefusesAPassageWhereItSawAWall) { refuses(0, 1, 3); }

TEST_F(AMouseThatHasSeenAPassage, RefusesAContradictionSeenFromTheOtherSide) {
  refuses(1, 0, 0, {{3, 1}, Heading::north});  // the passage to the west is two cells long
  refuses(0, 1, 0, {{4, 1}, Heading::west});   // and ends at the wall between (3,1) and (4,1)
}

TEST_F(AMouseThatHasSeenAPassage, LearnsNothingFromAReadingThatIsWrongOnOneSideOnly) {
  refuses(0, 2, 1);
  refuses(1, 1, 2);
}

TEST_F(AMouseThatHasSeenAPassage, RefusesToSeeThroughTheBorder) {
  refuses(2, 0, 0, {{1, 3}, Heading::north});
  refuses(0, 0, 4, {{1, 3}, Heading::north});
}

TEST_F(AMouseThatHasSeenAPassage, RefusesReadingsThatNoMazeGives) {
  refuses(-1, 0, 0, {{1, 3}, Heading::north});
  refuses(0, 64, 0, {{3, 3}, Heading::west});
  refuses(0, 1'000'000, 0, {{3, 3}, Heading::west});
}

TEST(Knowledge, OnlyGrowsAndIsNeverWrong) {
  Rng rng(3);
  for (const Size size : {Size{1, 1}, Size{9, 5}, Size{16, 16}, Size{33, 20}, Size{64, 64}}) {
    const Maze maze = kruskal_generator.make({size, rng.bits(), 150});
    Knowledge knowledge(size);
    for (int i = 0; i < 300; ++i) {
      const WallSet open = knowledge.open(), unknown = knowledge.unknown();
      const Pose pose{size.cell_at(rng.below(size.area())), all_headings[static_cast<std::size_t>(rng.below(4))]};
      ASSERT_TRUE(knowledge.learn(pose, look(maze, pose)));
      WallSet forgotten = open, newly_unknown = knowledge.unknown(), wrongly_open = knowledge.open();
      EXPECT_TRUE((forgotten -= knowledge.open()).empty());
      EXPECT_TRUE((newly_unknown -= unknown).empty());
      EXPECT_TRUE((wrongly_open -= maze.open_walls()).empty());
      WallSet wrongly_closed = maze.open_walls();
      EXPECT_TRUE((wrongly_closed -= knowledge.possible()).empty());
    }
  }
}

TEST(Knowledge, AllThatWasSeenFromEverywhereIsTheMaze) {
  const Maze maze = wilson_generator.make({{12, 7}, 5, 200});
  Knowledge knowledge(maze.size());
  for (int index = 0; index < maze.size().area(); ++index)
    for (const Heading heading : {Heading::north, Heading::south}) {
      const Pose pose{maze.size().cell_at(index), heading};
      ASSERT_TRUE(knowledge.learn(pose, look(maze, pose)));
    }
  EXPECT_TRUE(knowledge.unknown().empty());
  EXPECT_EQ(knowledge.open(), maze.open_walls());
}

}  // namespace
}  // namespace labmouse
