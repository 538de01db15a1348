// What readings make of walls, in maps of both kinds.
#include "labmouse/mouse/log_odds_map.hpp"

#include <gtest/gtest.h>

#include "labmouse/grid/cell_set.hpp"

namespace labmouse {
namespace {

using News = LogOddsMap::News;

constexpr Size size = {4, 4};
const Wall wall = wall_at({1, 1}, Heading::east);

WallState state_of(const LogOddsMap& log_odds) { return log_odds.view().state(wall); }

TEST(LogOddsMap, TheFirstReadingDecides) {
  for (const MapKind kind : all_map_kinds) {
    LogOddsMap log_odds(size, kind);
    EXPECT_EQ(log_odds.add(wall, 1), News::learned);
    EXPECT_EQ(state_of(log_odds), WallState::closed);
    EXPECT_EQ(log_odds.add(wall_at({0, 0}, Heading::north), 0), News::learned);
    EXPECT_EQ(log_odds.view().state(wall_at({0, 0}, Heading::north)), WallState::open);
    EXPECT_EQ(log_odds.version(), 0);
  }
}

TEST(LogOddsMap, ALearnedMapBeginsAtWhatOtherMazesAreLike) {
  LogOddsMap log_odds({16, 16}, MapKind::learned), even({16, 16}, MapKind::log_odds), small(size, MapKind::learned);
  // A post that has three walls hardly has a fourth.
  const Wall fourth = wall_at({5, 5}, Heading::north);
  for (LogOddsMap* each : {&log_odds, &even}) {
    for (const Wall closed : {wall_at({4, 5}, Heading::north), wall_at({4, 5}, Heading::east),
                              wall_at({4, 6}, Heading::east), wall_at({6, 5}, Heading::north)})
      static_cast<void>(each->add(closed, 64));
    EXPECT_EQ(each->add(fourth, 8), News::learned);
  }
  EXPECT_EQ(even.view().state(fourth), WallState::closed);
  EXPECT_EQ(log_odds.view().state(fourth), WallState::open);
  EXPECT_EQ(log_odds.add(fourth, 64), News::turned);
  // What is sure is sure, and in mazes too small for the prior all is even.
  EXPECT_EQ(log_odds.add(wall_at({1, 5}, Heading::north), -64), News::learned);
  EXPECT_EQ(log_odds.view().state(wall_at({1, 5}, Heading::north)), WallState::open);
  EXPECT_EQ(small.add(wall, -3), News::learned);
  EXPECT_EQ(small.odds(wall), -3);
}

TEST(LogOddsMap, InAMapOfFirstReadingsItStays) {
  LogOddsMap log_odds(size, MapKind::first);
  static_cast<void>(log_odds.add(wall, 1));
  EXPECT_EQ(log_odds.add(wall, -LogOddsMap::telling + 1), News::none);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(log_odds.add(wall, -64), News::contradicted);
  EXPECT_EQ(state_of(log_odds), WallState::closed);
  EXPECT_EQ(log_odds.version(), 0);
}

TEST(LogOddsMap, AWallTurnsOverOnceItsOddsAreWellBeyondEven) {
  LogOddsMap log_odds(size, MapKind::log_odds);
  static_cast<void>(log_odds.add(wall, 20));
  EXPECT_EQ(log_odds.add(wall, -35), News::contradicted);
  EXPECT_EQ(log_odds.odds(wall), -15);
  EXPECT_EQ(state_of(log_odds), WallState::closed);
  EXPECT_EQ(log_odds.add(wall, -1), News::turned);
  EXPECT_EQ(state_of(log_odds), WallState::open);
  EXPECT_EQ(log_odds.version(), 1);
  EXPECT_EQ(log_odds.add(wall, 10), News::none);
  EXPECT_EQ(state_of(log_odds), WallState::open);
  EXPECT_EQ(log_odds.add(wall, 22), News::turned);
  EXPECT_EQ(state_of(log_odds), WallState::closed);
  EXPECT_EQ(log_odds.version(), 2);
}

TEST(LogOddsMap, NothingIsSurerThanThreeReadingsCanTurn) {
  LogOddsMap log_odds(size, MapKind::log_odds);
  for (int i = 0; i < 100; ++i) static_cast<void>(log_odds.add(wall, 64));
  EXPECT_EQ(log_odds.odds(wall), LogOddsMap::most);
  EXPECT_EQ(log_odds.add(wall, -32), News::contradicted);
  EXPECT_EQ(log_odds.add(wall, -32), News::contradicted);
  EXPECT_EQ(log_odds.add(wall, -32), News::turned);
}

TEST(LogOddsMap, TheBorderIsClosedWhateverIsRead) {
  LogOddsMap log_odds(size, MapKind::log_odds);
  const Wall border = wall_at({0, 0}, Heading::west);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(log_odds.add(border, -64), News::none);
  log_odds.forget(border);
  log_odds.weaken(border, 64);
  EXPECT_EQ(log_odds.odds(border), LogOddsMap::most);
  EXPECT_EQ(log_odds.view().state(border), WallState::closed);
}

TEST(LogOddsMap, AForgottenWallIsUnknownAndCanBeLearnedAnew) {
  LogOddsMap log_odds(size, MapKind::log_odds);
  static_cast<void>(log_odds.add(wall, 64));
  log_odds.weaken(wall, 64);
  EXPECT_EQ(log_odds.odds(wall), 32);
  log_odds.forget(wall);
  EXPECT_EQ(state_of(log_odds), WallState::unknown);
  EXPECT_EQ(log_odds.version(), 1);
  log_odds.forget(wall);
  EXPECT_EQ(log_odds.version(), 1);
  EXPECT_EQ(log_odds.add(wall, -3), News::learned);
  EXPECT_EQ(state_of(log_odds), WallState::open);
}

TEST(LogOddsMap, DoubtTakesNoWallForItsOpposite) {
  // Told three times, of which it has kept one and a third.
  for (const int evidence : {48, -48}) {
    LogOddsMap log_odds(size, MapKind::log_odds);
    for (int i = 0; i < 3; ++i) static_cast<void>(log_odds.add(wall, evidence));
    const WallState before = state_of(log_odds);
    for (int i = 0; i < 3; ++i) log_odds.weaken(wall, evidence);
    EXPECT_EQ(log_odds.odds(wall), 0);
    EXPECT_EQ(state_of(log_odds), before);
    EXPECT_EQ(log_odds.version(), 0);
    // What spoke against it counts by half, too.
    log_odds.weaken(wall, -evidence);
    EXPECT_EQ(log_odds.odds(wall), evidence / 2);
  }
  LogOddsMap empty(size, MapKind::log_odds);
  empty.weaken(wall, 64);
  EXPECT_EQ(empty.odds(wall), 0);
  EXPECT_EQ(state_of(empty), WallState::unknown);
}

TEST(LogOddsMap, DoubtsTheWayOnWhichTheWallsAreLeastSure) {
  // Two ways lead out of the corner: one through a sure wall, one through two that are hardly so.
  LogOddsMap log_odds(size, MapKind::log_odds);
  const Wall sure = wall_at({0, 0}, Heading::east);
  const Wall faint = wall_at({0, 0}, Heading::north);
  const Wall beyond = wall_at({0, 1}, Heading::east);
  static_cast<void>(log_odds.add(sure, 64));
  static_cast<void>(log_odds.add(faint, -60));
  static_cast<void>(log_odds.add(faint, 59));
  log_odds.forget(faint);
  static_cast<void>(log_odds.add(faint, 1));
  static_cast<void>(log_odds.add(wall_at({0, 1}, Heading::north), 64));
  static_cast<void>(log_odds.add(beyond, 2));
  static_cast<void>(log_odds.add(beyond, -10));
  EXPECT_TRUE(log_odds.weaken_path({0, 0}, CellSet::of({3, 3})));
  EXPECT_EQ(log_odds.view().state(sure), WallState::closed);
  EXPECT_EQ(log_odds.view().state(faint), WallState::unknown);
  EXPECT_EQ(log_odds.view().state(beyond), WallState::unknown);
  // Now there may be a way, and nothing is left to doubt.
  EXPECT_FALSE(log_odds.weaken_path({0, 0}, CellSet::of({3, 3})));
  EXPECT_FALSE(log_odds.weaken_path({0, 0}, CellSet::of({0, 0})));
}

}  // namespace
}  // namespace labmouse
