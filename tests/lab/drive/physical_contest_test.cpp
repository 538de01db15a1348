#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "labmouse/contest/logged_tick.hpp"
#include "labmouse/contest/physical.hpp"
#include "tests/contest/scripted.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::at_errors;
using test::driven_physically;
using ::testing::Each;
using ::testing::Gt;
using ::testing::IsEmpty;
using ::testing::Le;
using ::testing::SizeIs;

using Kind = DriveRun::Kind;

/// Noise in which this mouse crashes now and then.
PhysicalConditions rough() {
  PhysicalConditions conditions = at_errors(4.0);
  conditions.errors.variation = 2.0;
  return conditions;
}

/// The first contest in which a run but the last ends by that, by seed.
template <class Predicate>
PhysicalRecord first_with(Predicate is_it, const DriveRules& rules = find_rules("all-japan").rules,
                          const std::string& mouse = "flood-return") {
  for (std::uint64_t seed = 1; seed < 200; ++seed) {
    PhysicalRecord record = driven_physically(mouse, test::ring(), rough(), seed, rules);
    if (is_it(record)) return record;
  }
  ADD_FAILURE() << "no contest of 200 was like that";
  return {};
}
bool crashes_early(const PhysicalRecord& record) {
  return record.ends.size() > 1 && is_crash(record.ends.front()) && record.drive.runs.size() > 1;
}

/// Without the fan, tyres of little grip bound the acceleration of the search run and of the way home.
TEST(PhysicalContest, RunsTheFanInSpeedRunsAlone) {
  DriveModel model = *test::drive_model("kerise");
  model.robot.hardware->tyres.grip = 2500.0;
  model.robot.hardware->tyres.downforce = 6000.0;
  PhysicalConditions conditions = at_errors(0.0);
  std::vector<LoggedTick> log;
  conditions.log = &log;
  const DriveRules rules = find_rules("all-japan").rules;
  Briefing briefing = brief(test::ring(), rules, model, 1);
  briefing.sight = 1;
  const BuiltinMouse& entry = *find_mouse("festina");
  const auto strategy = entry.drive(briefing, Settings(entry.parameters));
  const PhysicalRecord record = drive_physically(test::ring(), rules, model, conditions, 1, *strategy);
  std::map<Kind, double> most;
  // The log leaves out the time in which a hand carries the mouse.
  MazeTime carried = 0;
  for (std::size_t i = 0; i < record.drive.runs.size(); ++i) {
    const DriveRun& run = record.drive.runs[i];
    for (MazeTime time = run.begin - carried; time < run.end - carried; time += 1000)
      most[run.kind] =
          std::max(most[run.kind], std::abs(log.at(static_cast<std::size_t>(time / 1000)).motion.speeding));
    if (is_crash(record.ends[i])) carried += conditions.handling;
  }
  EXPECT_LE(most[Kind::search], 2500.01);
  EXPECT_LE(most[Kind::home], 2500.01);
  EXPECT_GT(most[Kind::speed], 2600.0);
  EXPECT_GE(std::count_if(record.drive.runs.begin(), record.drive.runs.end(),
                          [](const DriveRun& run) { return run.kind == Kind::home; }),
            2);
}

TEST(PhysicalContest, GoesWithoutNoiseAsInSeconds) {
  LABMOUSE_SKIP_SANITIZED();
  for (const char* robot : {"kerise", "classic", "beginner"})
    for (const char* mouse : {"flood", "flood-return", "certify", "ariadne"}) {
      const DriveRules rules = find_rules("all-japan").rules;
      const PhysicalRecord record = driven_physically(mouse, test::ring(), at_errors(0.0), 1, rules, robot);
      EXPECT_EQ(record.drive.outcome, DriveOutcome::finished) << mouse << ' ' << robot;
      EXPECT_THAT(record.touches, IsEmpty());
      EXPECT_EQ(record.wrong_walls + record.contradictions + record.carried, 0);
      EXPECT_THAT(record.ends, Each(RunEnd::done));
      const auto best = score(record.drive, rules).value();
      ASSERT_TRUE(best);
      // Bodies need a little longer than plans; by all-japan only the speed run counts.
      const auto model = test::drive_model(robot);
      const BuiltinMouse& entry = *find_mouse(mouse);
      const auto strategy = entry.drive(brief(test::ring(), rules, *model, 1), Settings(entry.parameters));
      const auto planned = score(drive(test::ring(), rules, *model, *strategy), rules).value();
      EXPECT_GT(*best, *planned);
      EXPECT_LT(static_cast<double>(*best), 1.25 * static_cast<double>(*planned) + 100'000.0) << mouse << ' ' << robot;
    }
}

TEST(PhysicalContest, OwesAllChanceToItsSeed) {
  const auto held = [](double noise, std::uint64_t seed) {
    return driven_physically("flood-return", test::ring(), at_errors(noise), seed);
  };
  EXPECT_EQ(held(1.0, 7), held(1.0, 7));
  EXPECT_NE(held(1.0, 7).drive, held(1.0, 8).drive);
  EXPECT_EQ(held(0.0, 7).drive, held(0.0, 8).drive);
}

TEST(PhysicalContest, AHandCarriesAMouseThatCrashed) {
  const PhysicalRecord record = first_with(crashes_early);
  const auto& runs = record.drive.runs;
  ASSERT_EQ(record.ends.size(), runs.size());
  EXPECT_FALSE(runs[0].touched);
  EXPECT_TRUE(runs[1].touched);
  EXPECT_EQ(runs[1].kind == Kind::home, false);
  EXPECT_GE(runs[1].begin, runs[0].end + PhysicalConditions().handling);
  EXPECT_GE(record.carried, 1);
  // It crashed when its run ended, and it knows what it knew.
  const auto crash =
      std::find_if(record.touches.begin(), record.touches.end(), [](const WallTouch& t) { return t.crash; });
  ASSERT_NE(crash, record.touches.end());
  EXPECT_EQ(crash->time, runs[0].end);
  WallSet forgotten = runs[0].open;
  forgotten -= runs[1].open;
  EXPECT_TRUE(forgotten.empty());
}

TEST(PhysicalContest, EveryCrashEndsARunAndIsCarried) {
  for (std::uint64_t seed = 1; seed <= test::fewer(30U); ++seed) {
    const PhysicalRecord record = driven_physically("flood-return", test::ring(), rough(), seed);
    const auto crashed = std::count_if(record.ends.begin(), record.ends.end(), is_crash);
    const auto touched =
        std::count_if(record.touches.begin(), record.touches.end(), [](const WallTouch& touch) { return touch.crash; });
    // One behind the goal of a speed run is no end of it.
    EXPECT_LE(crashed, touched);
    EXPECT_GE(record.carried, touched - 1);
    EXPECT_LE(record.carried, touched + 1);
  }
}

TEST(PhysicalContest, ATouchCostsWhatTheRulesSay) {
  LABMOUSE_SKIP_SANITIZED();
  DriveRules rules = find_rules("uk-2018").rules;
  ASSERT_GT(rules.touch_penalty, 0);
  const PhysicalRecord record = first_with(
      [&](const PhysicalRecord& held) { return crashes_early(held) && score(held.drive, rules).best.has_value(); },
      rules);
  const DriveScore with = score(record.drive, rules);
  rules.touch_penalty = 0;
  const DriveScore without = score(record.drive, rules);
  ASSERT_EQ(with.runs.size(), without.runs.size());
  bool any = false;
  for (std::size_t i = 0; i < with.runs.size(); ++i) {
    const bool touched = record.drive.runs[with.runs[i].run].touched;
    any = any || touched;
    EXPECT_EQ(with.runs[i].value - without.runs[i].value, touched ? find_rules("uk-2018").rules.touch_penalty : 0);
  }
  EXPECT_TRUE(any);
}

TEST(PhysicalContest, HasNoMoreRunsAndTimeThanTheRulesGive) {
  DriveRules rules = find_rules("all-japan").rules;
  rules.most_runs = 2;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const PhysicalRecord record = driven_physically("certify", test::ring(), rough(), seed, rules);
    EXPECT_LE(std::count_if(record.drive.runs.begin(), record.drive.runs.end(),
                            [](const DriveRun& run) { return run.kind != Kind::home; }),
              2);
  }
  rules.time_limit = 900'000;
  const PhysicalRecord late = driven_physically("certify", test::ring(), at_errors(0.0), 1, rules);
  EXPECT_THAT(late.ends, testing::ElementsAre(RunEnd::out_of_time));
  EXPECT_EQ(late.drive.outcome, DriveOutcome::out_of_time);
  EXPECT_EQ(late.drive.runs.back().end, rules.time_limit);
  EXPECT_FALSE(score(late.drive, rules).best);
}

TEST(PhysicalContest, WhatAMouseHasReadStays) {
  int contradictions = 0, wrong_walls = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(60U); ++seed) {
    const PhysicalRecord record = driven_physically("certify", test::ring(), rough(), seed);
    std::set<Wall> seen;
    int wrong = 0;
    for (const WallSeen& wall : record.drive.walls) {
      EXPECT_TRUE(seen.insert(wall.wall).second);
      wrong += wall.open != test::ring().is_open(wall.wall.cell, wall.wall.side);
    }
    EXPECT_EQ(record.wrong_walls, wrong);
    contradictions += record.contradictions;
    wrong_walls += wrong;
  }
  // Of a few contests, none may have any.
  if (!test::thorough) return;
  EXPECT_GT(contradictions, 0);
  EXPECT_GT(wrong_walls, 0);
}

PhysicalConditions weighing(PhysicalConditions conditions) {
  conditions.map = MapKind::log_odds;
  return conditions;
}

TEST(PhysicalContest, AMapThatWeighsChangesNothingWhereAllReadingsAgree) {
  for (const char* mouse : {"flood", "flood-return", "certify", "ariadne"})
    EXPECT_EQ(driven_physically(mouse, test::ring(), weighing(at_errors(0.0))),
              driven_physically(mouse, test::ring(), at_errors(0.0)))
        << mouse;
}

TEST(PhysicalContest, AMapThatWeighsTurnsWallsOverAndLosesFewerContests) {
  LABMOUSE_SKIP_SANITIZED();
  std::array<int, all_map_kinds.size()> finished{};
  int turned = 0;
  for (const MapKind kind : all_map_kinds)
    for (std::uint64_t seed = 1; seed <= test::fewer(60U); ++seed) {
      PhysicalConditions conditions = rough();
      conditions.map = kind;
      const PhysicalRecord record = driven_physically("certify", test::ring(), conditions, seed);
      finished[static_cast<std::size_t>(kind)] += record.drive.outcome == DriveOutcome::finished ? 1 : 0;
      std::map<Wall, bool> taken;
      for (const WallSeen& wall : record.drive.walls) {
        const auto [before, is_new] = taken.try_emplace(wall.wall, wall.open);
        if (is_new) continue;
        ++turned;
        EXPECT_NE(kind, MapKind::first);
        before->second = wall.open;
      }
      EXPECT_NE(record.drive.reason, ForfeitReason::lost) << seed;
      EXPECT_NE(record.drive.reason, ForfeitReason::contradiction) << seed;
    }
  // Eight contests are too few for a difference, and for a wall that turns over.
  EXPECT_GE(finished[1], finished[0] + (test::thorough ? 1 : 0));
  EXPECT_GE(turned, test::thorough ? 1 : 0);
}

TEST(PhysicalContest, TracesBothMice) {
  PhysicalConditions conditions = at_errors(1.0);
  conditions.trace_every = 10;
  const PhysicalRecord traced = driven_physically("flood-return", test::ring(), conditions);
  ASSERT_THAT(traced.trace, SizeIs(Gt(100U)));
  double largest = 0.0;
  for (std::size_t i = 0; i < traced.trace.size(); ++i) {
    EXPECT_EQ(traced.trace[i].time, 10'000 * static_cast<MazeTime>(i + 1));
    ASSERT_TRUE(traced.trace[i].estimate);
    const Position off = traced.trace[i].estimate->position - traced.trace[i].truth.position;
    largest = std::max(largest, std::max(std::abs(off.x), std::abs(off.y)));
  }
  EXPECT_GT(largest, 0.01);
  EXPECT_LT(largest, 45.0);
  // Whether one is written changes nothing else.
  PhysicalRecord plain = driven_physically("flood-return", test::ring(), at_errors(1.0));
  plain.trace = traced.trace;
  EXPECT_EQ(plain, traced);
}

TEST(PhysicalContest, AMindThatAsksForWhatIsNotThereIsLost) {
  const auto outcome_of = [](std::vector<Action> script) {
    test::Scripted mouse(std::move(script));
    return drive_physically(test::ring(), find_rules("all-japan").rules, *test::drive_model("kerise"), at_errors(0.0),
                            1, mouse);
  };
  // Through a wall; home before a goal; and a speed run over a way that is not known.
  for (const auto& script : {std::vector<Action>{Action::step(90, 1)}, {Action::step(0, 1), Action::reset()}}) {
    const PhysicalRecord record = outcome_of(script);
    EXPECT_EQ(record.drive.outcome, DriveOutcome::forfeit);
    EXPECT_EQ(record.drive.reason, ForfeitReason::lost);
    EXPECT_EQ(record.ends.back(), RunEnd::given_up);
  }
  const PhysicalRecord record = outcome_of({Action::reset()});
  EXPECT_EQ(record.drive.reason, ForfeitReason::no_route);
  EXPECT_EQ(record.ends.back(), RunEnd::no_route_left);
}

}  // namespace
}  // namespace labmouse
