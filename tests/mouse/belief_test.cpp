// What readings make of walls, in maps of both kinds.
#include "labmouse/mouse/belief.hpp"

#include <gtest/gtest.h>

#include "labmouse/grid/cell_set.hpp"

namespace labmouse {
namespace {

using News = Belief::News;

constexpr Size size = {4, 4};
const Wall wall = wall_at({1, 1}, Heading::east);

WallState state_of(const Belief& belief) { return belief.view().state(wall); }

TEST(Belief, TheFirstReadingDecides) {
  for (const MapKind kind : all_map_kinds) {
    Belief belief(size, kind);
    EXPECT_EQ(belief.add(wall, 1), News::learned);
    EXPECT_EQ(state_of(belief), WallState::closed);
    EXPECT_EQ(belief.add(wall_at({0, 0}, Heading::north), 0), News::learned);
    EXPECT_EQ(belief.view().state(wall_at({0, 0}, Heading::north)), WallState::open);
    EXPECT_EQ(belief.version(), 0);
  }
}

TEST(Belief, ALearnedMapBeginsAtWhatOtherMazesAreLike) {
  Belief belief({16, 16}, MapKind::learned), even({16, 16}, MapKind::belief), small(size, MapKind::learned);
  // A post that has three walls hardly has a fourth.
  const Wall fourth = wall_at({5, 5}, Heading::north);
  for (Belief* each : {&belief, &even}) {
    for (const Wall closed : {wall_at({4, 5}, Heading::north), wall_at({4, 5}, Heading::east),
                              wall_at({4, 6}, Heading::east), wall_at({6, 5}, Heading::north)})
      static_cast<void>(each->add(closed, 64));
    EXPECT_EQ(each->add(fourth, 8), News::learned);
  }
  EXPECT_EQ(even.view().state(fourth), WallState::closed);
  EXPECT_EQ(belief.view().state(fourth), WallState::open);
  EXPECT_EQ(belief.add(fourth, 64), News::turned);
  // What is sure is sure, and in mazes too small for the prior all is even.
  EXPECT_EQ(belief.add(wall_at({1, 5}, Heading::north), -64), News::learned);
  EXPECT_EQ(belief.view().state(wall_at({1, 5}, Heading::north)), WallState::open);
  EXPECT_EQ(small.add(wall, -3), News::learned);
  EXPECT_EQ(small.odds(wall), -3);
}

TEST(Belief, InAMapOfFirstReadingsItStays) {
  Belief belief(size, MapKind::first);
  static_cast<void>(belief.add(wall, 1));
  EXPECT_EQ(belief.add(wall, -Belief::telling + 1), News::none);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(belief.add(wall, -64), News::contradicted);
  EXPECT_EQ(state_of(belief), WallState::closed);
  EXPECT_EQ(belief.version(), 0);
}

TEST(Belief, AWallTurnsOverOnceItsOddsAreWellBeyondEven) {
  Belief belief(size, MapKind::belief);
  static_cast<void>(belief.add(wall, 20));
  EXPECT_EQ(belief.add(wall, -35), News::contradicted);
  EXPECT_EQ(belief.odds(wall), -15);
  EXPECT_EQ(state_of(belief), WallState::closed);
  EXPECT_EQ(belief.add(wall, -1), News::turned);
  EXPECT_EQ(state_of(belief), WallState::open);
  EXPECT_EQ(belief.version(), 1);
  EXPECT_EQ(belief.add(wall, 10), News::none);
  EXPECT_EQ(state_of(belief), WallState::open);
  EXPECT_EQ(belief.add(wall, 22), News::turned);
  EXPECT_EQ(state_of(belief), WallState::closed);
  EXPECT_EQ(belief.version(), 2);
}

TEST(Belief, NothingIsSurerThanThreeReadingsCanTurn) {
  Belief belief(size, MapKind::belief);
  for (int i = 0; i < 100; ++i) static_cast<void>(belief.add(wall, 64));
  EXPECT_EQ(belief.odds(wall), Belief::most);
  EXPECT_EQ(belief.add(wall, -32), News::contradicted);
  EXPECT_EQ(belief.add(wall, -32), News::contradicted);
  EXPECT_EQ(belief.add(wall, -32), News::turned);
}

TEST(Belief, TheBorderIsClosedWhateverIsRead) {
  Belief belief(size, MapKind::belief);
  const Wall border = wall_at({0, 0}, Heading::west);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(belief.add(border, -64), News::none);
  belief.forget(border);
  belief.doubt(border, 64);
  EXPECT_EQ(belief.odds(border), Belief::most);
  EXPECT_EQ(belief.view().state(border), WallState::closed);
}

TEST(Belief, AForgottenWallIsUnknownAndCanBeLearnedAnew) {
  Belief belief(size, MapKind::belief);
  static_cast<void>(belief.add(wall, 64));
  belief.doubt(wall, 64);
  EXPECT_EQ(belief.odds(wall), 32);
  belief.forget(wall);
  EXPECT_EQ(state_of(belief), WallState::unknown);
  EXPECT_EQ(belief.version(), 1);
  belief.forget(wall);
  EXPECT_EQ(belief.version(), 1);
  EXPECT_EQ(belief.add(wall, -3), News::learned);
  EXPECT_EQ(state_of(belief), WallState::open);
}

TEST(Belief, DoubtTakesNoWallForItsOpposite) {
  // Told three times, of which it has kept one and a third.
  for (const int evidence : {48, -48}) {
    Belief belief(size, MapKind::belief);
    for (int i = 0; i < 3; ++i) static_cast<void>(belief.add(wall, evidence));
    const WallState before = state_of(belief);
    for (int i = 0; i < 3; ++i) belief.doubt(wall, evidence);
    EXPECT_EQ(belief.odds(wall), 0);
    EXPECT_EQ(state_of(belief), before);
    EXPECT_EQ(belief.version(), 0);
    // What spoke against it counts by half, too.
    belief.doubt(wall, -evidence);
    EXPECT_EQ(belief.odds(wall), evidence / 2);
  }
  Belief empty(size, MapKind::belief);
  empty.doubt(wall, 64);
  EXPECT_EQ(empty.odds(wall), 0);
  EXPECT_EQ(state_of(empty), WallState::unknown);
}

TEST(Belief, DoubtsTheWayOnWhichTheWallsAreLeastSure) {
  // Two ways lead out of the corner: one through a sure wall, one through two that are hardly so.
  Belief belief(size, MapKind::belief);
  const Wall sure = wall_at({0, 0}, Heading::east);
  const Wall faint = wall_at({0, 0}, Heading::north);
  const Wall beyond = wall_at({0, 1}, Heading::east);
  static_cast<void>(belief.add(sure, 64));
  static_cast<void>(belief.add(faint, -60));
  static_cast<void>(belief.add(faint, 59));
  belief.forget(faint);
  static_cast<void>(belief.add(faint, 1));
  static_cast<void>(belief.add(wall_at({0, 1}, Heading::north), 64));
  static_cast<void>(belief.add(beyond, 2));
  static_cast<void>(belief.add(beyond, -10));
  EXPECT_TRUE(belief.doubt_way({0, 0}, CellSet::of({3, 3})));
  EXPECT_EQ(belief.view().state(sure), WallState::closed);
  EXPECT_EQ(belief.view().state(faint), WallState::unknown);
  EXPECT_EQ(belief.view().state(beyond), WallState::unknown);
  // Now there may be a way, and nothing is left to doubt.
  EXPECT_FALSE(belief.doubt_way({0, 0}, CellSet::of({3, 3})));
  EXPECT_FALSE(belief.doubt_way({0, 0}, CellSet::of({0, 0})));
}

}  // namespace
}  // namespace labmouse
