// The failure model: contests with failures at given rates.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "labmouse/contest/believed_walls.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/lab/failure_rates/failure_file.hpp"
#include "tests/lab/drive/failures_fixture.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::at;
using test::at_errors;
using test::driven;
using test::driven_exactly;
using test::harmless;
using test::wall_error;
using test::with;
using ::testing::_;
using ::testing::Contains;
using ::testing::Each;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::SizeIs;

TEST(Failures, IsTheWorldInSecondsWhereNothingGoesWrong) {
  for (const std::string mouse : {"flood", "flood-return", "certify"}) {
    const PhysicalRecord record = driven(mouse, harmless());
    const DriveRecord exact = driven_exactly(mouse, test::ring());
    EXPECT_EQ(record.drive.outcome, DriveOutcome::finished);
    EXPECT_EQ(record.wrong_walls + record.carried + record.contradictions, 0);
    EXPECT_THAT(record.ends, Each(RunEnd::done));
    EXPECT_TRUE(record.by_failure_model);
    ASSERT_GE(record.drive.runs.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(record.drive.runs[i].moves, exact.runs[i].moves) << mouse << i;
      EXPECT_EQ(record.drive.runs[i].gate_out, exact.runs[i].gate_out);
      EXPECT_EQ(record.drive.runs[i].gate_in, exact.runs[i].gate_in);
      EXPECT_EQ(record.drive.runs[i].centre, exact.runs[i].centre);
    }
    const DriveRules rules = find_rules("all-japan").rules;
    EXPECT_EQ(score(record.drive, rules).value(), score(exact, rules).value());
  }
}

TEST(Failures, TakesTheDrawsOfThePhysicalWorld) {
  for (const std::uint64_t seed : {1U, 2U, 3U})
    EXPECT_EQ(driven("flood", harmless(), seed).severity,
              test::driven_physically("flood", test::ring(), at_errors(1.0), seed).severity);
}

TEST(Failures, CrashesByTheChancesOfAManoeuvre) {
  const auto turns = with([](FailureRatesByBrightness& failure_rates) {
    for (std::size_t level = 0; level < position_error_levels; ++level)
      at(failure_rates, Manoeuvre::turn, level) = {1.0, 0.0, {1.0}};
  });
  const PhysicalRecord record = driven("flood-return", turns);
  EXPECT_THAT(record.ends, SizeIs(5));
  EXPECT_THAT(record.ends, Each(RunEnd::position_lost));
  EXPECT_EQ(record.carried, 5);
  EXPECT_NE(record.drive.outcome, DriveOutcome::finished);
  const auto slides = with([](FailureRatesByBrightness& failure_rates) {
    at(failure_rates, Manoeuvre::turn) = {1.0, 1.0, {1.0}};
  });
  EXPECT_THAT(driven("flood-return", slides).ends, Each(RunEnd::slid));
  // The clock runs on, and time to carry it back is part of it.
  for (std::size_t i = 1; i < record.drive.runs.size(); ++i)
    EXPECT_GE(record.drive.runs[i].begin, record.drive.runs[i - 1].end + PhysicalConditions().handling);
}

TEST(Failures, KeepsItsPositionErrorFromManoeuvreToManoeuvre) {
  // Whoever starts is led far off its believed position, and there a turn is the end.
  const auto failure_rates = with([](FailureRatesByBrightness& some) {
    at(some, Manoeuvre::start) = {0.0, 0.0, {0.0, 0.0, 0.0, 0.0, 1.0}};
    for (const Manoeuvre straight : {Manoeuvre::open_cell, Manoeuvre::half_cell, Manoeuvre::corridor})
      at(some, straight, 4) = {0.0, 0.0, {0.0, 0.0, 0.0, 0.0, 1.0}};
    at(some, Manoeuvre::turn, 4) = {1.0, 0.0, {1.0}};
  });
  EXPECT_THAT(driven("flood", failure_rates).ends, Each(RunEnd::position_lost));
}

TEST(Failures, DrivesIntoWallsThatItTakesForGaps) {
  const auto failure_rates = with([](FailureRatesByBrightness& some) {
    wall_error(some, Reading::wall_beside);
    wall_error(some, Reading::wall_ahead);
  });
  const PhysicalRecord record = driven("flood", failure_rates);
  EXPECT_THAT(record.ends, Contains(RunEnd::wall_error));
  EXPECT_GT(record.wrong_walls, 0);
}

TEST(Failures, SeesNoWayWhereGapsAreTakenForWallsAndLooksAgainWithAMapThatDoubts) {
  const auto failure_rates = with([](FailureRatesByBrightness& some) {
    wall_error(some, Reading::gap_beside);
    wall_error(some, Reading::gap_ahead);
  });
  const PhysicalRecord first = driven("flood", failure_rates);
  EXPECT_EQ(first.drive.outcome, DriveOutcome::forfeit);
  EXPECT_EQ(first.drive.reason, ForfeitReason::no_route);
  PhysicalConditions weighing = at_errors(1.0);
  weighing.map = MapKind::log_odds;
  EXPECT_GT(driven("flood", failure_rates, 1, weighing).drive.walls.size(), first.drive.walls.size());
}

/// Closed walls that a contest noted, and whether each is closed in the maze.
std::vector<std::pair<Wall, bool>> noted_as_closed(const PhysicalRecord& record, const Maze& maze) {
  std::vector<std::pair<Wall, bool>> walls;
  for (const WallSeen& seen : record.drive.walls)
    if (!seen.open) walls.emplace_back(seen.wall, !maze.is_open(seen.wall.cell, seen.wall.side));
  return walls;
}

TEST(Failures, HitsAMissedWallOnceWithAMapThatDoubts) {
  const auto failure_rates = with([](FailureRatesByBrightness& some) {
    wall_error(some, Reading::wall_beside);
    wall_error(some, Reading::wall_ahead);
  });
  EXPECT_THAT(noted_as_closed(driven("flood", failure_rates), test::ring()), IsEmpty());
  PhysicalConditions weighing = at_errors(1.0);
  weighing.map = MapKind::log_odds;
  const PhysicalRecord record = driven("flood", failure_rates, 1, weighing);
  const auto hit = std::count(record.ends.begin(), record.ends.end(), RunEnd::wall_error);
  ASSERT_GT(hit, 1);
  const auto closed = noted_as_closed(record, test::ring());
  EXPECT_THAT(closed, SizeIs(hit));
  EXPECT_THAT(closed, Each(Pair(_, true)));
  for (std::size_t i = 1; i < closed.size(); ++i) EXPECT_NE(closed[i].first, closed[i - 1].first);
}

TEST(BelievedWalls, AreClosedByACrashUnlessTheMouseHasPassed) {
  PhysicalRecord record;
  BelievedWalls walls(test::ring(), MapKind::log_odds, record);
  const Wall passed = {{0, 0}, Heading::north}, hit = {{0, 1}, Heading::north};
  walls.pass(0, {0, 0}, {{0, 1}, Heading::north});
  walls.read(1, {{0, 1}, Heading::north}, {0, -8 * evidence_a_nat, 0});
  walls.close_after_crash(2, passed);
  walls.close_after_crash(2, hit);
  // What was read before the crash counts half, and the crash whole.
  walls.weaken_last();
  EXPECT_EQ(walls.known().state(passed), WallState::open);
  EXPECT_EQ(walls.log_odds().odds(hit), LogOddsMap::most);
}

/// A crash for another reason closes a passage, too, until no other way is left.
TEST(Failures, PassesAgainWhereItCrashedForAnotherReason) {
  const auto failure_rates = with([](FailureRatesByBrightness& some) {
    for (const Manoeuvre manoeuvre : all_manoeuvres) at(some, manoeuvre).crash = 0.25;
  });
  PhysicalConditions weighing = at_errors(1.0);
  weighing.map = MapKind::log_odds;
  int contests = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const PhysicalRecord record = driven("flood", failure_rates, seed, weighing);
    const auto closed = noted_as_closed(record, test::ring());
    const auto wrong = std::count_if(closed.begin(), closed.end(), [](const auto& wall) { return !wall.second; });
    contests += wrong > 1 && record.drive.outcome == DriveOutcome::finished ? 1 : 0;
  }
  EXPECT_GT(contests, 0);
}

TEST(Failures, IsTheSameAgainByTheSameSeedAndAnotherByAnother) {
  const auto failure_rates = with([](FailureRatesByBrightness& some) {
    for (const Manoeuvre manoeuvre : all_manoeuvres) at(some, manoeuvre) = {0.05, 0.5, {0.6, 0.4}};
  });
  EXPECT_EQ(driven("flood-return", failure_rates, 7), driven("flood-return", failure_rates, 7));
  EXPECT_NE(driven("flood-return", failure_rates, 7), driven("flood-return", failure_rates, 8));
}

TEST(Failures, HasTheSameBrightnessAllThroughAContest) {
  LABMOUSE_SKIP_SANITIZED();
  // Only mice that see walls as dark crash: either none or all runs of a contest do.
  FailureRates failure_rates = harmless();
  auto& by_brightness = failure_rates.paces.front().variations.front().by_brightness;
  constexpr std::size_t dark_classes = 3;
  for (std::size_t bright = 0; bright < dark_classes; ++bright) at(by_brightness[bright], Manoeuvre::turn).crash = 1.0;
  const PhysicalConditions conditions = at_errors(1.0);
  int dark_mice = 0;
  constexpr int contests = 60;
  for (std::uint64_t seed = 1; seed <= contests; ++seed) {
    const PhysicalRecord record = driven("flood", failure_rates, seed, conditions);
    const RobotSample mouse(*test::drive_model("kerise")->robot.hardware, conditions.errors, test::ring().size(), seed);
    const bool dark = mouse.brightness() < brightness_limits[dark_classes - 1];
    EXPECT_EQ(record.carried > 0, dark) << seed;
    dark_mice += dark ? 1 : 0;
  }
  EXPECT_GT(dark_mice, 0);
  EXPECT_LT(dark_mice, contests / 2);
}

/// Each wall is read by the rates of how bright it looks.
TEST(Failures, ReadsAWallByItsOwnBrightness) {
  const std::size_t dark_classes = 4;
  FailureRates failure_rates = harmless();
  for (std::size_t bright = 0; bright < dark_classes; ++bright)
    for (const Reading reading : {Reading::wall_beside, Reading::wall_ahead})
      wall_error(failure_rates.paces.front().variations.front().by_brightness[bright], reading);
  const PhysicalConditions conditions = at_errors(1.0);
  int dark = 0, bright = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Maze maze = test::ring();
    const PhysicalRecord record = driven("flood-return", failure_rates, seed, conditions, maze);
    const RobotSample mouse(*test::drive_model("kerise")->robot.hardware, conditions.errors, maze.size(), seed);
    for (const Look& look : record.looks)
      for (const bool left : {true, false}) {
        const Heading side = left ? left_of(look.pose.heading) : right_of(look.pose.heading);
        if (on_border(wall_at(look.pose.cell, side), maze.size()) || maze.is_open(look.pose.cell, side)) continue;
        const double gain = mouse.infrared[left ? 2 : 0];
        const bool is_dark = gain * mouse.reflectance(look.pose.cell, side) < brightness_limits[dark_classes - 1];
        EXPECT_EQ((left ? look.evidence.left : look.evidence.right) < 0, is_dark) << seed;
        ++(is_dark ? dark : bright);
      }
  }
  EXPECT_GT(dark, 10);
  EXPECT_GT(bright, 10);
}

TEST(Failures, ReadsAWallFromOneSideInTheSameWayEachTime) {
  const auto failure_rates = with([](FailureRatesByBrightness& some) {
    for (auto& of_reading : some.readings)
      for (ReadingRates& shares : of_reading) {
        shares = {};
        shares.front() = shares.back() = 0.5;
      }
  });
  int again = 0, wrong = 0, right = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::map<std::pair<int, Heading>, Evidence> read;
    for (const Look& look : driven("flood-return", failure_rates, seed).looks)
      for (const auto& [side, evidence] : {std::pair{left_of(look.pose.heading), look.evidence.left},
                                           std::pair{look.pose.heading, look.evidence.ahead},
                                           std::pair{right_of(look.pose.heading), look.evidence.right}}) {
        if (evidence == 0) continue;
        const auto [first, is_new] = read.try_emplace({test::ring().size().index(look.pose.cell), side}, evidence);
        EXPECT_EQ(first->second, evidence) << seed;
        again += is_new ? 0 : 1;
        ++((evidence > 0) == test::ring().is_open(look.pose.cell, side) ? right : wrong);
      }
  }
  EXPECT_GT(again, 10);
  EXPECT_GT(wrong, 3);
  EXPECT_GT(right, 3);
}

TEST(Failures, ReadsAllWallsAboutItOrNone) {
  LABMOUSE_SKIP_SANITIZED();
  const auto failure_rates = with([](FailureRatesByBrightness& some) {
    for (auto& reading : some.readings)
      for (ReadingRates& shares : reading) {
        for (double& share : shares) share /= 2.0;
        shares[evidence_class(0)] = 0.5;
      }
  });
  int silent = 0, looks = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Maze maze = test::ring();
    const PhysicalRecord record = driven("flood-return", failure_rates, seed, at_errors(1.0), maze);
    for (const Look& look : record.looks) {
      std::vector<Evidence> inner;
      const Heading ahead = look.pose.heading;
      for (const auto& [side, evidence] :
           {std::pair(left_of(ahead), look.evidence.left), std::pair(ahead, look.evidence.ahead),
            std::pair(right_of(ahead), look.evidence.right)})
        if (!on_border(wall_at(look.pose.cell, side), maze.size())) inner.push_back(evidence);
      if (inner.empty()) continue;
      ++looks;
      silent += inner.front() == 0 ? 1 : 0;
      EXPECT_TRUE(
          std::all_of(inner.begin(), inner.end(), [&](Evidence each) { return (each == 0) == (inner.front() == 0); }));
    }
  }
  EXPECT_NEAR(static_cast<double>(silent) / looks, 0.5, 0.1);
}

TEST(Failures, DrivesByWhatIsSoBrightUnderOtherVariationsWhereFewWereCounted) {
  FailureFile file;
  constexpr std::size_t usual = 4, dark = 0;
  const auto turn = static_cast<std::size_t>(Manoeuvre::turn);
  for (const double variation : {1.0, 2.0}) {
    file.tallies.push_back({variation, 1.0, {}});
    file.tallies.back().by_brightness[usual].manoeuvres[turn][0] = {100'000, 0, 0, {100'000}};
  }
  file.tallies.back().by_brightness[dark].manoeuvres[turn][0] = {1000, 900, 900, {100}};
  // The first variation of the model is that at which nothing goes wrong.
  const RatesAtVariation at_one = rates_of(file).paces.front().variations[1];
  ASSERT_EQ(at_one.variation, 1.0);
  EXPECT_GT(at_one.by_brightness[dark].manoeuvres[turn][0].crash, 0.8);
  EXPECT_LT(at_one.by_brightness[usual].manoeuvres[turn][0].crash, 0.01);
}

TEST(Failures, HasClassesOfBrightness) {
  EXPECT_EQ(brightness_class(0.1), 0U);
  EXPECT_EQ(brightness_class(0.4), 1U);
  EXPECT_EQ(brightness_class(1.0), 5U);
  EXPECT_EQ(brightness_class(7.0), brightness_classes - 1);
  const auto model = test::drive_model("kerise");
  std::array<int, brightness_classes> times{};
  for (std::uint64_t seed = 1; seed <= 400; ++seed)
    ++times[brightness_class(RobotSample(*model->robot.hardware, {}, {2, 2}, seed).brightness())];
  EXPECT_THAT(times, Each(::testing::Gt(0)));
}

/// A reading is as bright as the sensors that look there.
TEST(Failures, TakesTheSensorsThatLookAtAWall) {
  const auto model = test::drive_model("kerise");
  RobotSample mouse(*model->robot.hardware, no_errors, {2, 2}, 1);
  mouse.infrared[2] = 0.3;
  mouse.infrared[0] = 3.0;
  mouse.infrared[3] = 1.0;
  mouse.infrared[1] = 0.1;
  const Pose pose = {{0, 0}, Heading::east};
  EXPECT_EQ(brightness_class(mouse, pose, Heading::north, true), brightness_class(0.3));
  EXPECT_EQ(brightness_class(mouse, pose, Heading::south, true), brightness_class(3.0));
  EXPECT_EQ(brightness_class(mouse, pose, Heading::east, true), brightness_class(0.55));
}

TEST(Failures, IsHeldUnderTheNearestVariationsThatWereCounted) {
  LABMOUSE_SKIP_SANITIZED();
  const std::vector<double> scales = {0.0, 1.0, 3.0};
  const auto is = [&](double scale, std::size_t below, std::size_t above, double part) {
    const Between found = between(scales, scale, [](double each) { return each; });
    return found.below == below && found.above == above && std::abs(found.part - part) < 1e-12;
  };
  EXPECT_TRUE(is(0.0, 0, 0, 0.0));
  EXPECT_TRUE(is(0.25, 0, 1, 0.25));
  EXPECT_TRUE(is(1.0, 1, 1, 0.0));
  EXPECT_TRUE(is(2.5, 1, 2, 0.75));
  EXPECT_TRUE(is(9.0, 2, 2, 0.0));
  // Half of the contests between a harmless variation and one without a turn that ends well.
  FailureRates failure_rates = harmless();
  failure_rates.paces.front().variations.push_back(no_failures());
  failure_rates.paces.front().variations.back().variation = 3.0;
  for (FailureRatesByBrightness& by_brightness : failure_rates.paces.front().variations.back().by_brightness)
    at(by_brightness, Manoeuvre::turn).crash = 1.0;
  int crashed = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
    crashed += driven("flood", failure_rates, seed, at_errors(2.0)).carried > 0 ? 1 : 0;
  EXPECT_NEAR(crashed, 50, 20);
}

TEST(Failures, IsDrivenAtAPace) {
  PhysicalConditions slow = at_errors(1.0);
  slow.controller.pace = 0.5;
  const PhysicalRecord usual = driven("flood", harmless()), halved = driven("flood", harmless(), 1, slow);
  ASSERT_EQ(halved.drive.runs.size(), usual.drive.runs.size());
  EXPECT_EQ(halved.drive.runs[0].end, 2 * usual.drive.runs[0].end);
  const DriveRun &run = usual.drive.runs.back(), &slow_run = halved.drive.runs.back();
  EXPECT_EQ(*slow_run.gate_in - slow_run.begin, 2 * (*run.gate_in - run.begin));
  // What goes wrong at the usual pace need not at another.
  FailureRates failure_rates = harmless();
  failure_rates.paces.insert(failure_rates.paces.begin(), {0.5, {no_failures()}});
  at(failure_rates.paces.back().variations.front().by_brightness.back(), Manoeuvre::turn).crash = 1.0;
  for (FailureRatesByBrightness& by_brightness : failure_rates.paces.back().variations.front().by_brightness)
    at(by_brightness, Manoeuvre::turn).crash = 1.0;
  EXPECT_GT(driven("flood", failure_rates).carried, 0);
  EXPECT_EQ(driven("flood", failure_rates, 1, slow).carried, 0);
}

TEST(Failures, KnowsEvidenceByNats) {
  EXPECT_EQ(evidence_in(evidence_class(0)), 0);
  for (int evidence = -64; evidence <= 64; ++evidence) {
    const Evidence middle = evidence_in(evidence_class(static_cast<Evidence>(evidence)));
    EXPECT_LE(std::abs(middle - evidence), evidence_a_nat / 2) << evidence;
    EXPECT_EQ(middle > 0, evidence > 0);
    EXPECT_EQ(middle < 0, evidence < 0);
  }
}

TEST(Failures, AsksToBeCarriedWhereItsMapDoesNotFitIfThatIsLearned) {
  // What it sees again is the opposite of what it saw first.
  const auto failure_rates = with([](FailureRatesByBrightness& some) {
    for (const Reading reading : all_readings) {
      if (static_cast<int>(reading) < 4) continue;
      ReadingRates& shares = some.readings[static_cast<std::size_t>(reading)][0];
      shares = {};
      shares[is_of_wall(reading) ? 0 : evidence_classes - 1] = 1.0;
    }
  });
  const auto no_route_left = [&](MapKind map) {
    PhysicalConditions conditions = at_errors(1.0);
    conditions.map = map;
    const PhysicalRecord record = driven("flood-return", failure_rates, 1, conditions);
    EXPECT_GT(record.contradictions, 0);
    return std::count(record.ends.begin(), record.ends.end(), RunEnd::no_route_left);
  };
  EXPECT_GT(no_route_left(MapKind::learned), no_route_left(MapKind::log_odds));
}

}  // namespace
}  // namespace labmouse
