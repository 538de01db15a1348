#include "labmouse/lab/drives/known_drives.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "labmouse/lab/numbers/wilson.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::at_errors;
using test::Says;
using ::testing::SizeIs;

std::vector<NamedMaze> rings() {
  return {
      {"ring", test::ring()}, {"closed", Maze(MazeDraft({3, 3}, MazeDraft::Inside::closed))}, {"other", test::ring()}};
}

DriveOrder order(KnownWay way = KnownWay::search, int runs = 6) {
  DriveOrder order;
  order.model = test::drive_model("kerise");
  order.way = way;
  order.runs = runs;
  return order;
}

TEST(KnownDrives, NeitherCrashNorMisreadWithoutNoise) {
  for (const KnownWay way : {KnownWay::search, KnownWay::fast}) {
    const auto tallies = drive_known_ways(order(way), rings(), std::vector<DriveCase>{{"none", at_errors(0.0)}});
    ASSERT_THAT(tallies, SizeIs(1));
    // The closed maze is left out.
    EXPECT_EQ(tallies[0].mazes, 2);
    EXPECT_EQ(tallies[0].mazes_without_crash, 2);
    EXPECT_EQ(tallies[0].runs, 12);
    EXPECT_EQ(tallies[0].crashed, 0);
    EXPECT_EQ(tallies[0].side.wrong + tallies[0].front.wrong, 0);
    if (way == KnownWay::search) {
      EXPECT_EQ(tallies[0].cells, 12 * moves_of_known_way(test::ring(), *order().model));
      EXPECT_GT(tallies[0].side.all, 0);
    }
    EXPECT_THAT(tallies[0].most_aside, SizeIs(12));
  }
}

TEST(KnownDrives, AreTheSameOnAnyNumberOfThreads) {
  DriveOrder alone = order(), many = order();
  alone.jobs = 1;
  many.jobs = 4;
  const std::vector<DriveCase> cases = {{"1", at_errors(1.0)}, {"3", at_errors(3.0)}};
  EXPECT_EQ(json_of(drive_known_ways(alone, rings(), cases), alone),
            json_of(drive_known_ways(many, rings(), cases), alone));
}

TEST(KnownDrives, EndWorseWithoutWallsToCorrectThem) {
  LABMOUSE_SKIP_SANITIZED();
  const auto tallies = drive_known_ways(order(KnownWay::search, 40), rings(), cases_by_correction(at_errors(4.0)));
  ASSERT_THAT(tallies, SizeIs(4));
  EXPECT_LT(tallies.front().truth.aside, tallies.back().truth.aside);
  EXPECT_LE(tallies.front().crashed, tallies.back().crashed);
}

TEST(KnownDrives, SwitchOnEachCauseAlone) {
  const auto cases = cases_by_cause(at_errors(2.0));
  ASSERT_EQ(cases.size(), error_causes + 1);
  for (std::size_t cause = 0; cause < error_causes; ++cause)
    for (std::size_t other = 0; other < error_causes; ++other) {
      const ErrorScale& errors = cases[cause + 1].conditions.errors;
      EXPECT_EQ(errors.variation_of(static_cast<ErrorCause>(other)), cause == other ? 2.0 : 0.0);
      EXPECT_EQ(errors.noise_of(static_cast<ErrorCause>(other)), cause == other ? 2.0 : 0.0);
    }
}

TEST(KnownDrives, AreToldAsATableAndAsJson) {
  const auto tallies = drive_known_ways(order(), rings(), std::vector<DriveCase>{{"strong", at_errors(6.0)}});
  EXPECT_THAT(table_of(tallies, order()), Says("Robot kerise", "strong", "crashed", "wrong"));
  const auto json = nlohmann::json::parse(json_of(tallies, order()));
  const auto& told = json.at("drives").at(0);
  EXPECT_EQ(told.at("runs"), tallies[0].runs);
  EXPECT_EQ(told.at("crashed"), tallies[0].crashed);
}

TEST(KnownDrives, StopWhereTheyAreToldTo) {
  std::atomic<bool> stop = false;
  DriveHooks hooks;
  hooks.stop = &stop;
  std::size_t done = 0;
  hooks.finished = [&](std::size_t) { stop = ++done == 3; };
  DriveOrder alone = order();
  alone.jobs = 1;
  const auto tallies = drive_known_ways(
      alone, rings(), std::vector<DriveCase>{{"first", at_errors(1.0)}, {"second", at_errors(1.0)}}, hooks);
  EXPECT_EQ(tallies.at(0).runs, 3);
  EXPECT_EQ(tallies.at(1).runs, 0);
  EXPECT_TRUE(tallies.at(1).stopped);
  const auto json = nlohmann::json::parse(json_of(tallies, alone));
  EXPECT_EQ(json.at("stopped"), true);
  auto whole = tallies;
  for (DriveTally& tally : whole) tally.stopped = false;
  EXPECT_NE(table_of(tallies, alone), table_of(whole, alone));
  EXPECT_EQ(nlohmann::json::parse(json_of(whole, alone)).at("stopped"), false);
}

TEST(WilsonInterval, IsThatOfTheBooks) {
  // Newcombe 1998, table 1: 81 of 263, 15 of 148, 0 of 20, 1 of 29.
  const auto near = [](const Interval& interval, double low, double high) {
    EXPECT_NEAR(interval.low, low, 5e-5);
    EXPECT_NEAR(interval.high, high, 5e-5);
  };
  near(wilson_interval(81.0 / 263, 263), 0.2553, 0.3662);
  near(wilson_interval(15.0 / 148, 148), 0.0624, 0.1605);
  near(wilson_interval(0.0, 20), 0.0, 0.1611);
  near(wilson_interval(1.0 / 29, 29), 0.0061, 0.1718);
  near(wilson_interval(1.0, 20), 1.0 - 0.1611, 1.0);
  near(wilson_interval(0.0, 0), 0.0, 1.0);
}

}  // namespace
}  // namespace labmouse
