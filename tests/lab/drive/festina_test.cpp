// How festina chooses its pace and its runs, in the failure model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/physical.hpp"
#include "tests/lab/drive/failures_fixture.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::at;
using test::at_errors;
using test::driven;
using test::driven_exactly;
using test::harmless;
using test::with;

std::vector<double> paces_of(const PhysicalRecord& record, DriveRun::Kind kind) {
  std::vector<double> paces;
  for (const DriveRun& run : record.drive.runs)
    if (run.kind == kind) paces.push_back(run.pace);
  return paces;
}

/// Beyond that pace each of those manoeuvres is a crash.
FailureRates too_fast_beyond(double pace, std::initializer_list<Manoeuvre> manoeuvres) {
  FailureRates failure_rates = harmless();
  failure_rates.paces = {{pace, failure_rates.paces[0].variations}, {pace + 1e-6, failure_rates.paces[0].variations}};
  for (FailureRatesByBrightness& by_brightness : failure_rates.paces.back().variations.front().by_brightness)
    for (const Manoeuvre manoeuvre : manoeuvres) at(by_brightness, manoeuvre).crash = 1.0;
  return failure_rates;
}

TEST(Festina, SearchesMoreSlowlyAfterEachCrash) {
  const PhysicalRecord record = driven("festina", too_fast_beyond(0.7, {Manoeuvre::turn}));
  const std::vector<double> paces = paces_of(record, DriveRun::Kind::search);
  ASSERT_GE(paces.size(), 2U);
  EXPECT_TRUE(std::is_sorted(paces.rbegin(), paces.rend()));
  EXPECT_GT(paces.front(), 0.7);
  EXPECT_LE(paces.back(), 0.7);
  EXPECT_EQ(record.drive.outcome, DriveOutcome::finished);
  // Others try again as fast as before.
  EXPECT_NE(driven("ariadne", too_fast_beyond(0.7, {Manoeuvre::turn})).drive.outcome, DriveOutcome::finished);
}

TEST(Festina, RunsSlowerAfterACrashAndFasterAfterAnotherRun) {
  const auto failure_rates =
      too_fast_beyond(0.8, {Manoeuvre::run_straight, Manoeuvre::run_turn, Manoeuvre::run_diagonal});
  const std::vector<double> paces = paces_of(driven("festina", failure_rates), DriveRun::Kind::speed);
  ASSERT_GE(paces.size(), 3U);
  EXPECT_GT(paces[0], 0.8);
  EXPECT_LE(paces[1], 0.8);
  EXPECT_GT(paces[2], paces[1]);
  EXPECT_LT(paces[2], paces[0]);
  // One that went well at the usual pace cannot be bettered.
  const std::vector<double> well = paces_of(driven("festina", harmless()), DriveRun::Kind::speed);
  ASSERT_EQ(well.size(), 2U);
  EXPECT_LT(well[0], 1.0);
  EXPECT_EQ(well[1], 1.0);
}

/// The kinds of all runs but those home.
std::vector<DriveRun::Kind> kinds_of(const PhysicalRecord& record) {
  std::vector<DriveRun::Kind> kinds;
  for (const DriveRun& run : record.drive.runs)
    if (run.kind != DriveRun::Kind::home) kinds.push_back(run.kind);
  return kinds;
}

TEST(Festina, MakesSureOfARunWhereNoFastOneEndsWell) {
  using enum DriveRun::Kind;
  const auto failure_rates =
      with([](FailureRatesByBrightness& some) { at(some, Manoeuvre::run_straight).crash = 1.0; });
  const PhysicalRecord record = driven("festina", failure_rates);
  EXPECT_THAT(kinds_of(record), ::testing::ElementsAre(search, speed, speed, speed, search));
  // By known ways it is no slower than the search was.
  std::vector<MazeTime> times;
  for (const DriveRun& run : record.drive.runs)
    if (run.kind == search) times.push_back(run.gate_in.value() - run.gate_out.value());
  EXPECT_LE(times.back(), times.front());
  EXPECT_EQ(score(record.drive, find_rules("all-japan").rules).value(), times.back());
  // Of a mouse with a run that ended well the last one is fast.
  EXPECT_EQ(kinds_of(driven("festina", too_fast_beyond(0.7, {Manoeuvre::run_straight}))).back(), speed);
}

TEST(Festina, MakesSureOfARunInTimeWhereRunsAreMany) {
  using enum DriveRun::Kind;
  const auto model = test::drive_model("kerise");
  const DriveRules rules = find_rules("uk-2018").rules;
  const Maze maze = test::ring();
  const Briefing briefing = brief(maze, rules, *model, 1);
  const auto failure_rates =
      with([](FailureRatesByBrightness& some) { at(some, Manoeuvre::run_straight).crash = 1.0; });
  const auto kinds = [&](const std::string& spec) {
    const auto strategy = test::mice(spec).front().driving_strategy(maze, briefing);
    return kinds_of(drive_with_failures(maze, rules, *model, at_errors(1.0), failure_rates, 1, *strategy));
  };
  const auto made = kinds("festina");
  ASSERT_GT(made.size(), 6U);
  EXPECT_THAT(std::vector(made.begin(), made.begin() + 6),
              ::testing::ElementsAre(search, speed, speed, speed, search, speed));
  EXPECT_EQ(std::count(made.begin() + 6, made.end() - 1, search), 0);
  const auto without = kinds("festina:safe=no");
  EXPECT_EQ(std::count(without.begin(), without.end(), search), 1);
}

TEST(Festina, SearchesNoSlowerThanATimeLimitAllows) {
  const auto pace = [](Size size) {
    const auto model = test::drive_model("kerise");
    Briefing briefing;
    briefing.size = size;
    briefing.goals = CellSet::of({1, 1});
    briefing.sight = 1;
    briefing.drive = {.model = model.get(), .time_limit = find_rules("all-japan").rules.time_limit};
    const auto mouse = festina_mouse.drive(briefing, Settings(festina_mouse.parameters));
    const double first = mouse->pace(false);
    for (int crash = 0; crash < 20; ++crash) mouse->carried(0);
    return std::pair(first, mouse->pace(false));
  };
  EXPECT_EQ(pace({16, 16}).first, 1.0);
  EXPECT_LT(pace({16, 16}).second, 0.5);
  EXPECT_EQ(pace({32, 32}).second, 1.0);
}

TEST(Festina, IsAsCarefulAsTheRulesAskFor) {
  LABMOUSE_SKIP_SANITIZED();
  const auto model = test::drive_model("kerise");
  const auto first = [&](const DriveRules& rules) {
    return festina_mouse.drive(brief(test::ring(), rules, *model, 1), Settings(festina_mouse.parameters))->pace(true);
  };
  const DriveRules few = find_rules("all-japan").rules, many = find_rules("uk-2018").rules;
  DriveRules bonus = many;
  bonus.untouched_bonus = 10'000'000;
  EXPECT_LT(first(few), 1.0);
  EXPECT_LT(first(bonus), first(few));
  EXPECT_EQ(first(many), 1.0);
  const Contestant told = test::mice("festina:run=0.5").front();
  EXPECT_EQ(told.driving_strategy(test::ring(), brief(test::ring(), many, *model, 1))->pace(true), 0.5);
}

TEST(Festina, ExploresByTheRules) {
  // Where the time in the maze counts, certify explores longer than ariadne.
  const auto model = test::drive_model("kerise");
  const Maze maze = maze_named("contest-05").value();
  const auto searched = [&](const std::string& rules, const std::string& spec) {
    const Briefing briefing = brief(maze, find_rules(rules).rules, *model, 1);
    const auto mouse = test::mice(spec).front().driving_strategy(maze, briefing);
    return drive(maze, find_rules(rules).rules, *model, *mouse).decisions;
  };
  EXPECT_EQ(searched("all-japan", "festina"), searched("all-japan", "certify"));
  EXPECT_EQ(searched("thirtieth", "festina"), searched("thirtieth", "ariadne"));
  EXPECT_NE(searched("thirtieth", "certify"), searched("thirtieth", "ariadne"));
}

TEST(Festina, IsTheStrategyThatExploresForItWhereNothingGoesWrong) {
  const DriveRules rules = find_rules("all-japan").rules;
  EXPECT_EQ(score(driven_exactly("festina", test::ring()), rules).value(),
            score(driven_exactly("ariadne", test::ring()), rules).value());
}

}  // namespace
}  // namespace labmouse
