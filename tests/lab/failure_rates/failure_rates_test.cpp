#include "labmouse/lab/failure_rates/failure_rates.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "labmouse/lab/text/json.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::at_errors;
using test::mice;
using test::Says;
using ::testing::SizeIs;

std::vector<NamedMaze> rings() { return {{"ring", test::ring()}, {"other", test::ring()}}; }

FailureOrder order(std::vector<double> variations, int runs) {
  FailureOrder order;
  order.model = test::drive_model("kerise");
  order.rules = find_rules("all-japan").rules;
  order.variations = std::move(variations);
  order.runs = runs;
  return order;
}

std::int64_t ends(const ManoeuvreCount& count) {
  return std::accumulate(count.after.begin(), count.after.end(), std::int64_t{0});
}

ManoeuvreCount all_of(const FailureCounts& tally) {
  ManoeuvreCount sum;
  for (std::size_t level = 0; level < position_error_levels; ++level) sum += tally.at(level);
  return sum;
}

/// The counts of one contest in the ring, of all classes of brightness.
FailureCounts counted(const PhysicalRecord& record, double cell, const RobotSample& sample, double pace = 1.0) {
  FailureTally tally;
  tally.pace = pace;
  count_failures(record, test::ring(), cell, sample, tally);
  return tally.all();
}

RobotSample nominal() {
  return RobotSample(*test::drive_model("kerise")->robot.hardware, no_errors, test::ring().size(), 1);
}

/// Readings count where walls look as bright as that one does, all else where they do on average.
TEST(FailureRates, AreByBrightness) {
  const PhysicalConditions conditions = [] {
    PhysicalConditions usual;
    usual.trace_every = 5;
    return usual;
  }();
  constexpr std::uint64_t seed = 3;
  const PhysicalRecord record = test::driven_physically("flood-return", test::ring(), conditions, seed);
  const RobotSample sample(*test::drive_model("kerise")->robot.hardware, conditions.errors, test::ring().size(), seed);
  FailureTally tally;
  count_failures(record, test::ring(), 90.0, sample, tally);
  std::array<std::int64_t, brightness_classes> expected{};
  for (const Look& look : record.looks)
    for (const Heading side : {left_of(look.pose.heading), look.pose.heading, right_of(look.pose.heading)})
      if (!on_border(wall_at(look.pose.cell, side), test::ring().size()))
        ++expected[brightness_class(sample, look.pose, side, !test::ring().is_open(look.pose.cell, side))];
  for (std::size_t bright = 0; bright < brightness_classes; ++bright) {
    const FailureCounts& counts = tally.by_brightness[bright];
    EXPECT_EQ(counts.contests, bright == brightness_class(sample.brightness()) ? 1 : 0);
    std::int64_t readings = 0;
    for (const auto& of_kind : counts.readings)
      for (const ReadingCount& count : of_kind) readings += count.times();
    EXPECT_EQ(readings, expected[bright]) << bright;
  }
}

TEST(FailureRates, AreNoneWithoutVariation) {
  const auto tallies = measure_rates(order({0.0}, 1), mice("flood-return,certify"), rings()).tallies;
  ASSERT_THAT(tallies, SizeIs(1));
  const FailureCounts counts = tallies[0].all();
  EXPECT_EQ(counts.contests, 4);
  EXPECT_EQ(counts.finished, 4);
  EXPECT_EQ(all_of(counts).crashes, 0);
  EXPECT_EQ(counts.at(position_error_levels - 1).times, 0);
  for (const Reading reading : all_readings)
    for (const ReadingCount& count : counts.readings[static_cast<std::size_t>(reading)])
      EXPECT_EQ(count.wrong(reading), 0);
  for (const Manoeuvre manoeuvre : {Manoeuvre::corridor, Manoeuvre::turn, Manoeuvre::halt, Manoeuvre::start,
                                    Manoeuvre::run_straight, Manoeuvre::run_turn})
    EXPECT_GT(counts.of(manoeuvre).times, 0) << name_of(manoeuvre);
}

/// Counted once more, without asking at what.
TEST(FailureRates, CountEachManoeuvreAndEachCrashOnce) {
  const double cell = test::drive_model("kerise")->tables.cell;
  PhysicalConditions conditions = at_errors(4.0);
  conditions.trace_every = 5;
  std::int64_t crashes = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(40U); ++seed) {
    const PhysicalRecord record = test::driven_physically("flood-return", test::ring(), conditions, seed);
    const RobotSample sample(*test::drive_model("kerise")->robot.hardware, conditions.errors, test::ring().size(),
                             seed);
    const FailureCounts tally = counted(record, cell, sample);
    std::int64_t moves = 0, segments = 0, crashed = 0;
    for (std::size_t i = 0; i < record.drive.runs.size(); ++i) {
      const DriveRun& run = record.drive.runs[i];
      moves += static_cast<std::int64_t>(run.moves.size());
      // Walls that were misread are no manoeuvre's fault.
      crashed += is_crash(record.ends[i]) && record.ends[i] != RunEnd::wall_error ? 1 : 0;
      // What it drives behind the goal counts nowhere.
      if (run.kind == DriveRun::Kind::speed && record.ends[i] == RunEnd::done)
        for (const DriveSegment& segment : run.route.segments)
          segments += run.begin + segment.begin < run.gate_in ? 1 : 0;
    }
    const ManoeuvreCount all = all_of(tally);
    EXPECT_EQ(all.crashes, crashed) << seed;
    EXPECT_EQ(ends(all), all.times - all.crashes);
    EXPECT_GE(ends(all), moves + segments);
    std::int64_t in_search = 0;
    for (const Manoeuvre manoeuvre : all_manoeuvres)
      if (manoeuvre < Manoeuvre::run_straight) in_search += ends(tally.of(manoeuvre));
    EXPECT_EQ(in_search, moves);
    std::int64_t readings = 0;
    for (const auto& of_kind : tally.readings)
      for (const ReadingCount& count : of_kind) {
        readings += count.times();
        EXPECT_LE(count.wrong(Reading::gap_ahead) + count.wrong(Reading::wall_ahead) + count.silent(), count.times());
      }
    EXPECT_LE(readings, 3 * static_cast<std::int64_t>(record.looks.size()));
    EXPECT_GT(readings, 0);
    crashes += crashed;
  }
  EXPECT_GT(crashes, 0);
}

TEST(FailureRates, CountACrashAtWhatWasDrivenAtThatPace) {
  PhysicalRecord record = test::driven_physically("flood-return", test::ring(), at_errors(0.0), 1);
  auto& runs = record.drive.runs;
  const auto fast = std::find_if(runs.begin(), runs.end(), [](const DriveRun& run) {
    return run.kind == DriveRun::Kind::speed && run.route.segments.size() > 1;
  });
  ASSERT_NE(fast, runs.end());
  const auto& segments = fast->route.segments;
  ASSERT_NE(manoeuvre_of(segments[0]), manoeuvre_of(segments[1]));
  // It crashes when at its usual pace it had come into the second segment.
  fast->gate_in.reset();
  fast->end = fast->begin + (segments[1].begin + segments[1].end) / 2;
  record.ends[static_cast<std::size_t>(fast - runs.begin())] = RunEnd::slid;
  runs.erase(fast + 1, runs.end());
  record.ends.resize(runs.size());
  const auto crashes_at = [&](double pace, std::size_t segment) {
    return counted(record, 90.0, nominal(), pace).of(manoeuvre_of(segments[segment])).crashes;
  };
  EXPECT_EQ(crashes_at(1.0, 1), 1);
  EXPECT_EQ(crashes_at(1.0, 0), 0);
  EXPECT_EQ(crashes_at(0.2, 0), 1);
  EXPECT_EQ(crashes_at(0.2, 1), 0);
  fast->pace = 0.2;
  EXPECT_EQ(crashes_at(1.0, 0), 1);
}

TEST(FailureRates, KnowThePositionErrorOfAMouse) {
  EXPECT_EQ(position_error_level(0.0), 0U);
  EXPECT_EQ(position_error_level(0.019), 0U);
  EXPECT_EQ(position_error_level(0.02), 1U);
  EXPECT_EQ(position_error_level(0.5), position_error_levels - 1);
  // A mouse that goes one cell north with an error of 10 mm before and none behind.
  PhysicalRecord record;
  DriveRun run;
  run.begin = 0;
  run.end = 600'000;
  const Pose first = {test::ring().start(), Heading::north};
  run.moves.push_back({0, 300'000, first, Action::step(0, 1), {{0, 1}, Heading::north}});
  run.moves.push_back({300'000, 600'000, {{0, 1}, Heading::north}, Action::step(0, 1), {{0, 2}, Heading::north}});
  record.drive.runs.push_back(run);
  record.ends.push_back(RunEnd::done);
  const auto point = [](MazeTime time, double by) {
    return TracePoint{time, {{45.0 + by, 45.0}, 0.0}, BodyPose{{45.0, 45.0}, 0.0}, {}};
  };
  record.trace = {point(0, 0.0), point(295'000, 10.0), point(600'000, 0.0)};
  const FailureCounts tally = counted(record, 90.0, nominal());
  const std::size_t level = position_error_level(10.0 / 90.0);
  EXPECT_EQ(tally.manoeuvres[static_cast<std::size_t>(Manoeuvre::start)][0].after[level], 1);
  EXPECT_EQ(tally.at(level).times, 1);
  EXPECT_EQ(tally.at(level).after[0], 1);
}

TEST(FailureRates, GrowWithVariationAndAreTheSameOnAnyNumberOfThreads) {
  LABMOUSE_SKIP_SANITIZED();
  FailureOrder asked = order({0.5, 2.0}, test::thorough ? 6 : 2);
  asked.jobs = 1;
  const auto two = mice("flood-return,certify");
  const auto alone = measure_rates(asked, two, rings());
  asked.jobs = 4;
  const auto together = measure_rates(asked, two, rings());
  EXPECT_EQ(json_of(alone, asked, two, 2), json_of(together, asked, two, 2));
  const auto share_of_position_error = [](const FailureTally& tally) {
    const FailureCounts counts = tally.all();
    return 1.0 - static_cast<double>(counts.at(0).times) / static_cast<double>(all_of(counts).times);
  };
  EXPECT_GT(share_of_position_error(alone.tallies[1]), 2.0 * share_of_position_error(alone.tallies[0]));
}

TEST(FailureRates, AreATableAndJson) {
  const FailureOrder asked = order({2.0}, 1);
  const auto two = mice("flood-return,certify");
  const auto measured = measure_rates(asked, two, rings());
  const std::string table = table_of(measured, asked);
  for (const Manoeuvre manoeuvre : all_manoeuvres) EXPECT_THAT(table, Says(std::string(name_of(manoeuvre))));
  FailureOrder narrow = asked;
  narrow.conditions.errors.noise /= 2.0;
  EXPECT_NE(table, table_of(measured, narrow));
  const ReadJson json = ReadJson::parse(json_of(measured, asked, two, 2));
  EXPECT_THAT(json["mice"].get<std::vector<std::string>>(), ::testing::UnorderedElementsAre("certify", "flood-return"));
  const ReadJson& by_brightness = json["variations"][0]["by_brightness"];
  std::int64_t contests = 0;
  for (const ReadJson& some : by_brightness) contests += some["contests"].get<std::int64_t>();
  EXPECT_EQ(contests, 4);
  EXPECT_EQ(by_brightness[0]["manoeuvres"]["corridor"].size(), position_error_levels);
  EXPECT_EQ(by_brightness[0]["readings"]["gap ahead"].size(), position_error_levels);
  EXPECT_EQ(json["stopped"], false);
}

TEST(FailureRates, KeepWhatWasCountedBeforeTheyWereStopped) {
  FailureOrder asked = order({1.0}, 1);
  asked.jobs = 1;
  const auto two = mice("flood-return,certify");
  std::atomic<bool> stop = false;
  std::size_t done = 0;
  FailureHooks hooks;
  hooks.stop = &stop;
  hooks.finished = [&](std::size_t all) {
    EXPECT_EQ(all, 4U);
    stop = ++done == 2;
  };
  const auto measured = measure_rates(asked, two, rings(), hooks);
  EXPECT_EQ(done, 2U);
  EXPECT_TRUE(measured.stopped);
  EXPECT_EQ(measured.tallies.at(0).all().contests, 2);
  EXPECT_NE(table_of(measured, asked), table_of(MeasuredRates{measured.tallies, false}, asked));
  EXPECT_EQ(ReadJson::parse(json_of(measured, asked, two, 2))["stopped"], true);
  const std::string file = write_rates(measured, asked, two, 2);
  EXPECT_THAT(read_rates(file, "mine.json").error, Says("mine.json", "stopped"));
  EXPECT_TRUE(read_rates(write_rates({measured.tallies, false}, asked, two, 2), "mine.json").file);
}

}  // namespace
}  // namespace labmouse
