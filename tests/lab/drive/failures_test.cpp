#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/drive/drive_entries.hpp"
#include "labmouse/lab/drive/fidelity.hpp"
#include "labmouse/lab/failure_rates/failure_file.hpp"
#include "labmouse/lab/noise_curves/noise_curves.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::at_noise;
using test::Says;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

/// Under noise 1 as little goes wrong as under none, but for what a test changes.
FailureRates harmless() {
  FailureRates failure_rates;
  failure_rates.paces = {{1.0, {no_failures()}}};
  failure_rates.paces.front().noises.front().noise = 1.0;
  return failure_rates;
}

template <class Change>
FailureRates with(Change change) {
  FailureRates failure_rates = harmless();
  for (FailureRatesByDraw& by_draws : failure_rates.paces.front().noises.front().by_draws) change(by_draws);
  return failure_rates;
}

ManoeuvreRates& at(FailureRatesByDraw& failure_rates, Manoeuvre manoeuvre, std::size_t level = 0) {
  return failure_rates.manoeuvres[static_cast<std::size_t>(manoeuvre)][level];
}

void wall_error(FailureRatesByDraw& failure_rates, Reading reading, std::size_t level = 0) {
  for (const std::size_t again : {0U, 4U}) {
    ReadingRates& shares = failure_rates.readings[static_cast<std::size_t>(reading) + again][level];
    shares = {};
    shares[is_of_wall(reading) ? 0 : evidence_classes - 1] = 1.0;
  }
}

PhysicalRecord driven(const std::string& mouse, const FailureRates& failure_rates, std::uint64_t seed = 1,
                      const PhysicalConditions& conditions = at_noise(1.0), const Maze& maze = test::ring()) {
  const auto model = test::drive_model("kerise");
  const DriveRules rules = find_rules("all-japan").rules;
  Briefing briefing = brief(maze, rules, *model, seed);
  briefing.sight = 1;
  const BuiltinMouse& entry = *find_mouse(mouse);
  const auto strategy = entry.drive(briefing, Settings(entry.parameters));
  return drive_with_failures(maze, rules, *model, conditions, failure_rates, seed, *strategy);
}

/// What stands in the world of seconds.
DriveRecord driven_exactly(const std::string& mouse, const Maze& maze) {
  const auto model = test::drive_model("kerise");
  const DriveRules rules = find_rules("all-japan").rules;
  Briefing briefing = brief(maze, rules, *model, 1);
  briefing.sight = 1;
  const BuiltinMouse& entry = *find_mouse(mouse);
  const auto strategy = entry.drive(briefing, Settings(entry.parameters));
  return drive(maze, rules, *model, *strategy);
}

FailureOrder order_of(std::vector<double> noises, int runs) {
  FailureOrder order;
  order.model = test::drive_model("kerise");
  order.rules = find_rules("all-japan").rules;
  order.noises = std::move(noises);
  order.runs = runs;
  return order;
}

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
              test::driven_physically("flood", test::ring(), at_noise(1.0), seed).severity);
}

TEST(Failures, CrashesByTheChancesOfAManoeuvre) {
  const auto turns = with([](FailureRatesByDraw& failure_rates) {
    for (std::size_t level = 0; level < position_error_levels; ++level)
      at(failure_rates, Manoeuvre::turn, level) = {1.0, 0.0, {1.0}};
  });
  const PhysicalRecord record = driven("flood-return", turns);
  EXPECT_THAT(record.ends, SizeIs(5));
  EXPECT_THAT(record.ends, Each(RunEnd::position_lost));
  EXPECT_EQ(record.carried, 5);
  EXPECT_NE(record.drive.outcome, DriveOutcome::finished);
  const auto slides = with([](FailureRatesByDraw& failure_rates) {
    at(failure_rates, Manoeuvre::turn) = {1.0, 1.0, {1.0}};
  });
  EXPECT_THAT(driven("flood-return", slides).ends, Each(RunEnd::slid));
  // The clock runs on, and time to carry it back is part of it.
  for (std::size_t i = 1; i < record.drive.runs.size(); ++i)
    EXPECT_GE(record.drive.runs[i].begin, record.drive.runs[i - 1].end + PhysicalConditions().handling);
}

TEST(Failures, KeepsItsPositionErrorFromManoeuvreToManoeuvre) {
  // Whoever starts is led far off its believed position, and there a turn is the end.
  const auto failure_rates = with([](FailureRatesByDraw& some) {
    at(some, Manoeuvre::start) = {0.0, 0.0, {0.0, 0.0, 0.0, 0.0, 1.0}};
    for (const Manoeuvre straight : {Manoeuvre::open_cell, Manoeuvre::half_cell, Manoeuvre::corridor})
      at(some, straight, 4) = {0.0, 0.0, {0.0, 0.0, 0.0, 0.0, 1.0}};
    at(some, Manoeuvre::turn, 4) = {1.0, 0.0, {1.0}};
  });
  EXPECT_THAT(driven("flood", failure_rates).ends, Each(RunEnd::position_lost));
}

TEST(Failures, DrivesIntoWallsThatItTakesForGaps) {
  const auto failure_rates = with([](FailureRatesByDraw& some) {
    wall_error(some, Reading::wall_beside);
    wall_error(some, Reading::wall_ahead);
  });
  const PhysicalRecord record = driven("flood", failure_rates);
  EXPECT_THAT(record.ends, Contains(RunEnd::wall_error));
  EXPECT_GT(record.wrong_walls, 0);
}

TEST(Failures, SeesNoWayWhereGapsAreTakenForWallsAndLooksAgainWithAMapThatDoubts) {
  const auto failure_rates = with([](FailureRatesByDraw& some) {
    wall_error(some, Reading::gap_beside);
    wall_error(some, Reading::gap_ahead);
  });
  const PhysicalRecord first = driven("flood", failure_rates);
  EXPECT_EQ(first.drive.outcome, DriveOutcome::forfeit);
  EXPECT_EQ(first.drive.reason, ForfeitReason::no_route);
  PhysicalConditions weighing = at_noise(1.0);
  weighing.map = MapKind::log_odds;
  EXPECT_GT(driven("flood", failure_rates, 1, weighing).drive.walls.size(), first.drive.walls.size());
}

TEST(Failures, IsTheSameAgainByTheSameSeedAndAnotherByAnother) {
  const auto failure_rates = with([](FailureRatesByDraw& some) {
    for (const Manoeuvre manoeuvre : all_manoeuvres) at(some, manoeuvre) = {0.05, 0.5, {0.6, 0.4}};
  });
  EXPECT_EQ(driven("flood-return", failure_rates, 7), driven("flood-return", failure_rates, 7));
  EXPECT_NE(driven("flood-return", failure_rates, 7), driven("flood-return", failure_rates, 8));
}

TEST(Failures, IsWeakAllThroughAContest) {
  LABMOUSE_SKIP_SANITIZED();
  // Only weak mice crash: either none or all runs of a contest do.
  FailureRates failure_rates = harmless();
  auto& by_draws = failure_rates.paces.front().noises.front().by_draws;
  for (std::size_t draws = static_cast<std::size_t>(Draws::tyres_below_50); draws < draw_classes; ++draws)
    at(by_draws[draws], Manoeuvre::turn).crash = 1.0;
  PhysicalConditions conditions = at_noise(1.0);
  conditions.noise.variation = 5.0;
  int weak_mice = 0;
  constexpr int contests = 60;
  for (std::uint64_t seed = 1; seed <= contests; ++seed) {
    const PhysicalRecord record = driven("flood", failure_rates, seed, conditions);
    const RobotSample mouse(*test::drive_model("kerise")->robot.hardware, conditions.noise, test::ring().size(), seed);
    const bool weak = draws_of(mouse) >= Draws::tyres_below_50;
    EXPECT_EQ(record.carried > 0, weak) << seed;
    weak_mice += weak ? 1 : 0;
  }
  EXPECT_GT(weak_mice, 0);
  EXPECT_LT(weak_mice, contests / 3);
}

TEST(Failures, ReadsAllWallsAboutItOrNone) {
  LABMOUSE_SKIP_SANITIZED();
  const auto failure_rates = with([](FailureRatesByDraw& some) {
    for (auto& reading : some.readings)
      for (ReadingRates& shares : reading) {
        for (double& share : shares) share /= 2.0;
        shares[evidence_class(0)] = 0.5;
      }
  });
  int silent = 0, looks = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Maze maze = test::ring();
    const PhysicalRecord record = driven("flood-return", failure_rates, seed, at_noise(1.0), maze);
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

TEST(Failures, DrivesByWhatWeakMiceDoUnderOtherNoisesWhereFewWereCounted) {
  FailureFile file;
  const auto weak = static_cast<std::size_t>(Draws::motor_below_15);
  const auto turn = static_cast<std::size_t>(Manoeuvre::turn);
  for (const double noise : {1.0, 2.0}) {
    file.tallies.push_back({noise, 1.0, {}});
    file.tallies.back().by_draws[0].manoeuvres[turn][0] = {100'000, 0, 0, {100'000}};
  }
  file.tallies.back().by_draws[weak].manoeuvres[turn][0] = {1000, 900, 900, {100}};
  // The first noise of the world is that at which nothing goes wrong.
  const RatesAtNoise at_one = rates_of(file).paces.front().noises[1];
  ASSERT_EQ(at_one.noise, 1.0);
  EXPECT_GT(at_one.by_draws[weak].manoeuvres[turn][0].crash, 0.8);
  EXPECT_LT(at_one.by_draws[0].manoeuvres[turn][0].crash, 0.01);
}

TEST(Failures, HasSoundMiceAndWeakOnes) {
  const auto model = test::drive_model("kerise");
  NoiseLevel level;
  level.variation = 8.0;
  std::array<int, draw_classes> times{};
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    level.all = 1.0 + static_cast<double>(seed % 3);
    const RobotSample mouse(*model->robot.hardware, level, {2, 2}, seed);
    const Draws draws = draws_of(mouse);
    ++times[static_cast<std::size_t>(draws)];
    const double motor = mouse.weaker_motor();
    const bool sturdy = motor >= 0.3 && mouse.grip >= 0.5;
    EXPECT_EQ(draws <= Draws::infrared_very_unequal, sturdy) << motor << ' ' << mouse.grip;
    EXPECT_EQ(draws == Draws::sound, sturdy && mouse.infrared_deviation() <= 0.3) << mouse.infrared_deviation();
    EXPECT_EQ(draws == Draws::infrared_very_unequal, sturdy && mouse.infrared_deviation() > 0.5)
        << mouse.infrared_deviation();
    EXPECT_EQ(draws == Draws::motor_below_15, motor < 0.15) << motor;
    EXPECT_EQ(draws == Draws::tyres_below_20, mouse.grip < 0.2 && motor >= 0.2) << motor << ' ' << mouse.grip;
    // Of two weaknesses the worse one.
    EXPECT_EQ(draws == Draws::motor_below_30, motor >= 0.25 && motor < 0.3 && mouse.grip >= 0.3) << motor;
  }
  EXPECT_THAT(times, Each(::testing::Gt(0)));
}

TEST(Failures, IsHeldUnderTheNearestNoisesThatWereCounted) {
  LABMOUSE_SKIP_SANITIZED();
  const std::vector<double> noises = {0.0, 1.0, 3.0};
  const auto is = [&](double noise, std::size_t below, std::size_t above, double part) {
    const Between found = between(noises, noise, [](double each) { return each; });
    return found.below == below && found.above == above && std::abs(found.part - part) < 1e-12;
  };
  EXPECT_TRUE(is(0.0, 0, 0, 0.0));
  EXPECT_TRUE(is(0.25, 0, 1, 0.25));
  EXPECT_TRUE(is(1.0, 1, 1, 0.0));
  EXPECT_TRUE(is(2.5, 1, 2, 0.75));
  EXPECT_TRUE(is(9.0, 2, 2, 0.0));
  // Half of the contests between a harmless noise and one without a turn that ends well.
  FailureRates failure_rates = harmless();
  failure_rates.paces.front().noises.push_back(no_failures());
  failure_rates.paces.front().noises.back().noise = 3.0;
  for (FailureRatesByDraw& by_draws : failure_rates.paces.front().noises.back().by_draws)
    at(by_draws, Manoeuvre::turn).crash = 1.0;
  int crashed = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
    crashed += driven("flood", failure_rates, seed, at_noise(2.0)).carried > 0 ? 1 : 0;
  EXPECT_NEAR(crashed, 50, 20);
}

TEST(Failures, IsDrivenAtAPace) {
  PhysicalConditions slow = at_noise(1.0);
  slow.controller.pace = 0.5;
  const PhysicalRecord usual = driven("flood", harmless()), halved = driven("flood", harmless(), 1, slow);
  ASSERT_EQ(halved.drive.runs.size(), usual.drive.runs.size());
  EXPECT_EQ(halved.drive.runs[0].end, 2 * usual.drive.runs[0].end);
  const DriveRun &run = usual.drive.runs.back(), &slow_run = halved.drive.runs.back();
  EXPECT_EQ(*slow_run.gate_in - slow_run.begin, 2 * (*run.gate_in - run.begin));
  // What goes wrong at the usual pace need not at another.
  FailureRates failure_rates = harmless();
  failure_rates.paces.insert(failure_rates.paces.begin(), {0.5, {no_failures()}});
  at(failure_rates.paces.back().noises.front().by_draws.back(), Manoeuvre::turn).crash = 1.0;
  for (FailureRatesByDraw& by_draws : failure_rates.paces.back().noises.front().by_draws)
    at(by_draws, Manoeuvre::turn).crash = 1.0;
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

std::vector<double> paces_of(const PhysicalRecord& record, DriveRun::Kind kind) {
  std::vector<double> paces;
  for (const DriveRun& run : record.drive.runs)
    if (run.kind == kind) paces.push_back(run.pace);
  return paces;
}

TEST(Failures, AsksToBeCarriedWhereItsMapDoesNotFitIfThatIsLearned) {
  // What it sees again is the opposite of what it saw first.
  const auto failure_rates = with([](FailureRatesByDraw& some) {
    for (const Reading reading : all_readings) {
      if (static_cast<int>(reading) < 4) continue;
      ReadingRates& shares = some.readings[static_cast<std::size_t>(reading)][0];
      shares = {};
      shares[is_of_wall(reading) ? 0 : evidence_classes - 1] = 1.0;
    }
  });
  const auto no_route_left = [&](MapKind map) {
    PhysicalConditions conditions = at_noise(1.0);
    conditions.map = map;
    const PhysicalRecord record = driven("flood-return", failure_rates, 1, conditions);
    EXPECT_GT(record.contradictions, 0);
    return std::count(record.ends.begin(), record.ends.end(), RunEnd::no_route_left);
  };
  EXPECT_GT(no_route_left(MapKind::learned), no_route_left(MapKind::log_odds));
}

/// Beyond that pace each of those manoeuvres is a crash.
FailureRates too_fast_beyond(double pace, std::initializer_list<Manoeuvre> manoeuvres) {
  FailureRates failure_rates = harmless();
  failure_rates.paces = {{pace, failure_rates.paces[0].noises}, {pace + 1e-6, failure_rates.paces[0].noises}};
  for (FailureRatesByDraw& by_draws : failure_rates.paces.back().noises.front().by_draws)
    for (const Manoeuvre manoeuvre : manoeuvres) at(by_draws, manoeuvre).crash = 1.0;
  return failure_rates;
}

TEST(Festina, SearchesMoreSlowlyAfterEachCrash) {
  const PhysicalRecord record = driven("festina", too_fast_beyond(0.5, {Manoeuvre::turn}));
  const std::vector<double> paces = paces_of(record, DriveRun::Kind::search);
  ASSERT_GE(paces.size(), 2U);
  EXPECT_TRUE(std::is_sorted(paces.rbegin(), paces.rend()));
  EXPECT_GT(paces.front(), 0.5);
  EXPECT_LE(paces.back(), 0.5);
  EXPECT_EQ(record.drive.outcome, DriveOutcome::finished);
  // Others try again as fast as before.
  EXPECT_NE(driven("ariadne", too_fast_beyond(0.5, {Manoeuvre::turn})).drive.outcome, DriveOutcome::finished);
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
  const auto failure_rates = with([](FailureRatesByDraw& some) { at(some, Manoeuvre::run_straight).crash = 1.0; });
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
  const auto failure_rates = with([](FailureRatesByDraw& some) { at(some, Manoeuvre::run_straight).crash = 1.0; });
  const auto kinds = [&](const std::string& spec) {
    const auto strategy = test::mice(spec).front().driving_strategy(maze, briefing);
    return kinds_of(drive_with_failures(maze, rules, *model, at_noise(1.0), failure_rates, 1, *strategy));
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

/// As `labmouse failure rates` counts them.
std::string counted(const FailureOrder& order) {
  const auto mice = test::mice("flood-return");
  const std::vector<NamedMaze> mazes = {{"ring", test::ring()}};
  return write_rates(measure_rates(order, mice, mazes), order, mice, mazes.size());
}

TEST(FailureFile, HasAllThatWasCounted) {
  const FailureOrder order = order_of({1.0, 4.0}, 3);
  const auto tallies =
      measure_rates(order, test::mice("flood-return"), std::vector<NamedMaze>{{"ring", test::ring()}}).tallies;
  const FoundRates read = read_rates(counted(order), "some/mine.json");
  ASSERT_TRUE(read.file) << read.error;
  EXPECT_EQ(read.file->tallies, tallies);
  EXPECT_EQ(read.file->name, "mine");
  EXPECT_EQ(read.file->robot, "kerise");
  EXPECT_EQ(read.file->variation, order.conditions.noise.variation);
}

TEST(FailureFile, RefusesWhatIsNone) {
  const std::string good = counted(order_of({1.0}, 1));
  const auto refused = [&](auto change) {
    auto json = nlohmann::json::parse(good);
    change(json);
    const FoundRates read = read_rates(json.dump(), "mine.json");
    EXPECT_FALSE(read.file);
    return read.error;
  };
  EXPECT_THAT(read_rates("{}", "mine.json").error, Says("mine.json", "no file of failure rates"));
  EXPECT_THAT(refused([](auto& json) { json["labmouse_failure_rates"] = 99; }), HasSubstr("labmouse_failure_rates"));
  EXPECT_THAT(refused([](auto& json) { json["noises"] = nlohmann::json::array(); }), HasSubstr("noises"));
  EXPECT_THAT(refused([](auto& json) { json["noises"].push_back(json["noises"][0]); }), HasSubstr("increase"));
  EXPECT_THAT(refused([](auto& json) { json["noises"][0]["by_draws"].erase(0); }), HasSubstr("by_draws"));
  EXPECT_THAT(refused([](auto& json) { json["noises"][0]["by_draws"][0]["put"][0] = -1; }), HasSubstr("put"));
  EXPECT_THAT(refused([](auto& json) { json["noises"][0]["by_draws"][0].erase("readings"); }), HasSubstr("readings"));
  EXPECT_THAT(refused([](auto& json) {
                auto& turn = json["noises"][0]["by_draws"][0]["manoeuvres"]["turn"][0];
                turn[0] = turn[0].template get<int>() + 1;
              }),
              HasSubstr("add up"));
  EXPECT_THAT(refused([](auto& json) {
                json["noises"][0]["by_draws"][0]["readings"]["gap ahead"][0] = std::vector<int>(18, 1);
              }),
              HasSubstr("gap ahead"));
  EXPECT_THAT(find_rates("kerize").error, Says("kerize", "kerise"));
}

TEST(FailureFile, SaysHowLikelyAllIs) {
  FailureFile file;
  FailureTally& tally = file.tallies.emplace_back();
  tally.noise = 2.0;
  auto& turns = tally.by_draws[1].manoeuvres[static_cast<std::size_t>(Manoeuvre::turn)][0];
  turns = {100'000, 10'000, 2'500, {45'000, 45'000, 0, 0, 0}};
  tally.by_draws[1].readings[static_cast<std::size_t>(Reading::gap_beside)][0].by_evidence[evidence_classes - 1] = 1000;
  const FailureRates failure_rates = rates_of(file);
  // Without noise nothing goes wrong.
  ASSERT_THAT(failure_rates.paces, SizeIs(1));
  const auto& noises = failure_rates.paces[0].noises;
  ASSERT_THAT(noises, SizeIs(2));
  EXPECT_EQ(noises[0].noise, 0.0);
  EXPECT_EQ(noises[1].noise, 2.0);
  FailureRatesByDraw counted = noises[1].by_draws[1], other = noises[1].by_draws[4];
  EXPECT_NEAR(at(counted, Manoeuvre::turn).crash, 0.1, 1e-3);
  EXPECT_NEAR(at(counted, Manoeuvre::turn).slid, 0.25, 1e-3);
  EXPECT_NEAR(at(counted, Manoeuvre::turn).after[1], 0.5, 1e-3);
  // What was not counted is as it is elsewhere, and what was counted nowhere stays as it is.
  EXPECT_NEAR(at(other, Manoeuvre::turn).crash, 0.1, 1e-3);
  EXPECT_NEAR(at(other, Manoeuvre::corridor).crash, 0.1, 1e-3);
  EXPECT_EQ(at(other, Manoeuvre::corridor, 3).crash, 0.0);
  EXPECT_EQ(at(other, Manoeuvre::corridor, 3).after[3], 1.0);
  const auto& gaps = counted.readings[static_cast<std::size_t>(Reading::gap_beside)];
  EXPECT_GT(gaps[0][evidence_classes - 1], 0.95);
  EXPECT_EQ(gaps[1][0], 1.0);
}

TEST(FailureWorld, IsMadeOfWhatItIsToldAndMadeAgainOfItsConditions) {
  const WorldResult made = failures_entry.make({{"noise", "2.5"}, {"map", "log-odds"}});
  ASSERT_TRUE(made.world) << made.error;
  RaceOrder order;
  order.world = made.world;
  order.runs = 2;
  const Race race = hold_race(test::mice("flood"), {{"ring", test::ring()}}, order);
  const auto group = nlohmann::json::parse(json_of(race, {})).at("groups").at(0);
  EXPECT_EQ(group.at("world"), "failures");
  EXPECT_EQ(group.at("failure_rates"), "kerise");
  EXPECT_EQ(group.at("map"), "log-odds");
  const auto again = restore_world("failures", group.dump());
  ASSERT_TRUE(again);
  order.world = again;
  const Race twice = hold_race(test::mice("flood"), {{"ring", test::ring()}}, order);
  EXPECT_EQ(json_of(twice, {}), json_of(race, {}));
  auto other = group;
  other["failure_rates_hash"] = "0";
  EXPECT_FALSE(restore_world("failures", other.dump()));
}

TEST(FailureWorld, RefusesWhatItCannotUse) {
  const auto error = [](const WorldSettings& settings) {
    const WorldResult made = failures_entry.make(settings);
    EXPECT_FALSE(made.world);
    return made.error;
  };
  EXPECT_THAT(error({{"noise", "77"}}), Says("--noise", "77", "kerise"));
  EXPECT_THAT(error({{"robot", "classic"}}), Says("--failure-rates", "kerise", "classic"));
  EXPECT_THAT(error({{"failure-rates", "none"}}), HasSubstr("none"));
  EXPECT_THAT(error({{"map", "none"}}), HasSubstr("--map"));
}

TEST(FailureWorld, KeepsRecordsThatAreDrivenAgainByTheFailureRatesThatTheProgramBrings) {
  LABMOUSE_SKIP_SANITIZED();
  RaceOrder order;
  order.world = failures_entry.make({{"noise", "4"}, {"pace", "0.8"}}).world;
  order.runs = 3;
  RaceHooks hooks;
  std::vector<std::string> records;
  hooks.keep = [](const ContestResult&) { return Keep{true, false}; };
  hooks.finished = [&](const Race&, const ContestResult&, const ContestOutput& held) {
    records.push_back(held.record);
  };
  hold_race(test::mice("festina"), {{"ring", test::ring()}}, order, hooks);
  ASSERT_THAT(records, SizeIs(3));
  for (const std::string& text : records) {
    ReadDriveRecordResult read = read_drive_record(text);
    ASSERT_TRUE(read.file) << describe("", read.problems.front());
    EXPECT_TRUE(read.file->physical->notes.by_failure_model);
    EXPECT_EQ(read.file->physical->conditions.map, MapKind::log_odds);
    const auto& runs = read.file->record.runs;
    EXPECT_TRUE(std::any_of(runs.begin(), runs.end(), [](const DriveRun& run) { return run.pace < 1.0; }));
    EXPECT_EQ(replay_physically(*read.file), "");
    read.file->record.runs.front().pace = 0.5;
    EXPECT_THAT(replay_physically(*read.file), HasSubstr("line"));
    read.file->physical->rates_hash = "0";
    EXPECT_THAT(replay_physically(*read.file), Says("kerise", "not driven again"));
    read.file->physical->edition = failures_edition + 1;
    EXPECT_THAT(replay_physically(*read.file), Says("failures", "edition"));
  }
}

TEST(FailureWorld, RacesOnceForEachNoise) {
  const auto entered = enter(test::mice("flood,certify"), "failures", {{"noise", "0,2.5,4"}});
  ASSERT_EQ(entered.error, "");
  ASSERT_THAT(entered.entries, SizeIs(3));
  EXPECT_THAT(enter(test::mice("flood"), "failures", {{"noise", "0,,4"}}).error, HasSubstr("--noise"));
  EXPECT_THAT(sole_entry(entered.entries).error, HasSubstr("one"));
}

TEST(NoiseCurves, ShowWhatBecomesOfMiceAsNoiseGrows) {
  std::vector<Race> races;
  for (const auto& entry : enter(test::mice("flood,certify"), "failures", {{"noise", "4,0"}}).entries) {
    RaceOrder order;
    order.world = entry.world;
    order.runs = 30;
    races.push_back(hold_race(entry.mice, {{"ring", test::ring()}}, order));
  }
  const auto curves = noise_curves(races);
  ASSERT_THAT(curves, SizeIs(2));
  for (const NoiseCurve& curve : curves) {
    ASSERT_THAT(curve.points, SizeIs(2));
    EXPECT_EQ(curve.points[0].noise, 0.0);
    EXPECT_EQ(curve.points[0].finished, 30);
    const NoisePoint& last = curve.points[1];
    int ended = 0;
    for (const int count : last.ended) ended += count;
    EXPECT_EQ(last.contests, 30);
    EXPECT_EQ(last.finished + ended, 30);
    EXPECT_GE(*last.par1, *curve.points[0].par1);
  }
  EXPECT_THAT(table_of(curves, races.back().world()), Says("flood", "certify", "100.0", "in s;", "counts 300"));
  const std::string picture = draw_curves(curves, "A <title>");
  EXPECT_THAT(picture, Says("<svg", "certify", "&lt;title&gt;"));
  EXPECT_THAT(noise_curves(std::span(races).first(1)), IsEmpty());
}

TEST(Fidelity, ComparesTheSameContestsInBothWorlds) {
  const FailureOrder order = order_of({0.0, 2.0}, 2);
  const FoundRates failure_rates = find_rates("kerise");
  ASSERT_TRUE(failure_rates.file) << failure_rates.error;
  const std::vector<NamedMaze> mazes = {{"ring", test::ring()}, {"other", test::ring()}};
  const auto all = compare_worlds(order, *failure_rates.file, test::mice("flood,certify"), mazes);
  ASSERT_THAT(all, SizeIs(4));
  EXPECT_EQ(all[0].contests, 4);
  EXPECT_EQ(all[0].physical, 4);
  EXPECT_EQ(all[0].failures, 4);
  EXPECT_TRUE(is_faithful(all[0], {}));
  Fidelity far = {"m", 1.0, 100, 90, 86, -0.04, Interval{-0.045, -0.035}};
  EXPECT_FALSE(is_faithful(far, {}));
  EXPECT_TRUE(is_faithful(far, {0.04, 0.05}));
  far.interval = Interval{-0.06, 0.0};
  EXPECT_FALSE(is_faithful(far, {0.04, 0.05}));
  EXPECT_THAT(table_of(std::vector{far}, {}), Says("too far", "-4.0"));
}

}  // namespace
}  // namespace labmouse
