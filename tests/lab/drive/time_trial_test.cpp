// Time trials: laps of the outermost ring, in all worlds in seconds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "labmouse/contest/lap_route.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/lab/bounds/drive_bound.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/records/drive_story.hpp"
#include "labmouse/lab/replays/play_seconds.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::at_errors;
using test::Says;
using ::testing::Each;
using ::testing::SizeIs;

DriveRules time_trial() { return find_rules("time-trial").rules; }

const Maze& course() {
  static const Maze maze(MazeDraft({6, 5}, MazeDraft::Inside::open));
  return maze;
}

/// The record of a time trial in the world in seconds, or of festina in the physical world under a noise.
DriveRecordFile file_of(std::optional<double> noise = std::nullopt, std::uint64_t seed = 1) {
  DriveRecordFile file = noise ? test::physical_file("festina", at_errors(*noise), seed)
                               : test::driven("flood", course(), "kerise", "time-trial");
  file.maze = course();
  file.rules = time_trial();
  if (noise) {
    PhysicalRecord record =
        test::driven_physically("festina", course(), at_errors(*noise), seed, file.rules, file.model->robot.name);
    file.record = std::move(record.drive);
    file.physical->notes = std::move(record);
    file.physical->conditions.map = MapKind::log_odds;  // festina's own
  }
  const DriveScore result = score(file.record, file.rules);
  file.recorded_score = result.best ? std::optional(result.runs[*result.best]) : std::nullopt;
  return file;
}

DriveRecordFile read(const std::string& text) {
  ReadDriveRecordResult result = read_drive_record(text);
  EXPECT_TRUE(result.file) << (result.problems.empty() ? "" : result.problems.front().reason);
  return result.file ? std::move(*result.file) : file_of();
}

std::string changed(std::string text, const std::string& old, const std::string& now) {
  const auto place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return place == std::string::npos ? text : text.replace(place, old.size(), now);
}

std::size_t laps_in(const DriveRecord& record) {
  std::size_t laps = 0;
  for (const DriveRun& run : record.runs) laps += run.laps.size();
  return laps;
}

/// The record in the failure model with these chances of a crash in a turn, at that pace.
PhysicalRecord with_failures(double crash, double pace, std::uint64_t seed = 1) {
  FailureRates rates;
  rates.paces = {{pace, {no_failures()}}};
  rates.paces.front().variations.front().variation = 1.0;
  for (FailureRatesByBrightness& by_brightness : rates.paces.front().variations.front().by_brightness)
    for (ManoeuvreRates& level : by_brightness.manoeuvres[static_cast<std::size_t>(Manoeuvre::run_turn)])
      level = {crash, 0.0, {1.0}};
  PhysicalConditions conditions = at_errors(1.0);
  conditions.controller.pace = pace;
  const auto model = test::drive_model("kerise");
  Script mouse(course().size(), {});
  return drive_with_failures(course(), time_trial(), *model, conditions, rates, seed, mouse);
}

TEST(TimeTrial, InSecondsScoresTheFastestLap) {
  const DriveRecordFile file = file_of();
  const DriveRun& run = file.record.runs.front();
  const MazeTime lap = std::min<MazeTime>(run.laps.at(0) - run.gate_out.value(), flying_lap(course(), *file.model));
  EXPECT_EQ(score(file.record, file.rules).value(), lap);
  EXPECT_EQ(laps_in(file.record), 5U);
  const DriveBound bound = drive_bound_of(course(), file.rules, *file.model);
  EXPECT_EQ(bound.score, lap);
  EXPECT_EQ(bound.fastest, lap);
  // None is in time.
  DriveRules short_time = file.rules;
  short_time.time_limit = run.laps[0] - 1;
  EXPECT_EQ(drive_bound_of(course(), short_time, *file.model).score, std::nullopt);
}

TEST(TimeTrial, IsReadAsItWasWrittenAndDrivesAgain) {
  for (const auto noise : {std::optional<double>(), std::optional(0.0), std::optional(4.0)}) {
    const DriveRecordFile written = file_of(noise);
    const DriveRecordFile file = read(write_drive_record(written));
    EXPECT_EQ(file.rules.counts, Counted::lap);
    EXPECT_EQ(file.record, written.record);
    EXPECT_EQ(file.recorded_score, written.recorded_score);
    EXPECT_EQ(write_drive_record(file), write_drive_record(written));
    EXPECT_EQ(replay(file), "");
  }
}

TEST(TimeTrial, DisagreesWhereALapOrTheScoreWasChanged) {
  for (const auto noise : {std::optional<double>(), std::optional(0.0)}) {
    const DriveRecordFile file = file_of(noise);
    const std::string text = write_drive_record(file), lap = std::to_string(file.record.runs.at(0).laps.at(1));
    EXPECT_NE(replay(read(changed(text, lap, std::to_string(file.record.runs.at(0).laps.at(1) - 1)))), "");
    EXPECT_NE(replay(read(changed(text, "\"most_runs\":5", "\"most_runs\":4"))), "");
    EXPECT_NE(replay(read(changed(text, "\"score\":{\"value\":", "\"score\":{\"value\":1"))), "");
  }
}

TEST(TimeTrial, OfWhichTheEndIsMissingAgreesAsFarAsItGoes) {
  const std::string text = write_drive_record(file_of());
  int parts = 0;
  for (std::size_t end = text.find('\n'); end + 1 < text.size(); end = text.find('\n', end + 1), ++parts)
    EXPECT_EQ(replay(read(text.substr(0, end + 1))), "") << parts;
  EXPECT_GT(parts, 40);
}

TEST(TimeTrial, InAMazeWithoutACourseDoesNotDriveAgain) {
  // A record that was changed by hand.
  DriveRecordFile file = file_of();
  file.maze = test::ring().with_start({1, 1}, Heading::north);
  EXPECT_NE(replay(file), "");
}

TEST(TimeTrial, InThePhysicalWorldIsTimedByTheTrueMouse) {
  const DriveRecordFile file = file_of(0.0);
  ASSERT_THAT(file.record.runs, SizeIs(1));
  const DriveRun& run = file.record.runs.front();
  ASSERT_THAT(run.laps, SizeIs(5));
  EXPECT_THAT(file.physical->notes.ends, Each(RunEnd::done));
  // festina drives its first run at a pace of its own.
  EXPECT_LT(run.pace, 1.0);
  const double lap = flying_lap(course(), *file.model) / run.pace;
  for (std::size_t i = 1; i < run.laps.size(); ++i)
    EXPECT_NEAR(static_cast<double>(run.laps[i] - run.laps[i - 1]), lap, 0.02 * lap) << i;
}

TEST(TimeTrial, BeginsAgainAtTheStartAfterACrash) {
  // Of the seeds under this noise, some crash in every contest.
  int crashes = 0, slower = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    PhysicalConditions conditions = at_errors(8.0);
    conditions.errors.variation = 4.0;
    const PhysicalRecord record =
        test::driven_physically("festina", course(), conditions, seed, time_trial(), "kerise");
    EXPECT_LE(laps_in(record.drive), 5U);
    ASSERT_EQ(record.ends.size(), record.drive.runs.size());
    for (std::size_t i = 0; i + 1 < record.drive.runs.size(); ++i) {
      const DriveRun &run = record.drive.runs[i], &next = record.drive.runs[i + 1];
      EXPECT_NE(record.ends[i], RunEnd::done);
      EXPECT_TRUE(next.touched);
      EXPECT_GE(next.begin, run.end + conditions.handling);
      crashes += is_crash(record.ends[i]) ? 1 : 0;
      slower += next.pace < run.pace ? 1 : 0;
    }
    // The time may be over before it begins again.
    const int runs = static_cast<int>(record.drive.runs.size());
    EXPECT_GE(record.carried, runs - 1);
    EXPECT_LE(record.carried, runs);
  }
  EXPECT_GT(crashes, 0);
  EXPECT_GT(slower, 0);
}

TEST(TimeTrial, InTheFailureModelTakesTheTimesOfItsPace) {
  const PhysicalRecord good = with_failures(0.0, 0.5);
  ASSERT_THAT(good.drive.runs, SizeIs(1));
  ASSERT_THAT(good.drive.runs.front().laps, SizeIs(5));
  const auto& laps = good.drive.runs.front().laps;
  EXPECT_NEAR(static_cast<double>(laps[2] - laps[1]), 2.0 * flying_lap(course(), *test::drive_model("kerise")), 2.0);
  const PhysicalRecord bad = with_failures(1.0, 1.0);
  EXPECT_EQ(bad.drive.outcome, DriveOutcome::out_of_time);
  EXPECT_EQ(laps_in(bad.drive), 0U);
  EXPECT_GT(bad.carried, 10);
  // A lap that ends in a crash does not count; those before it do.
  int broken = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const PhysicalRecord some = with_failures(0.1, 1.0, seed);
    for (const DriveRun& run : some.drive.runs)
      for (const MazeTime lap : run.laps) EXPECT_LE(lap, run.end);
    broken += some.drive.runs.size() > 1 && laps_in(some.drive) > 0 ? 1 : 0;
    EXPECT_LE(laps_in(some.drive), 5U);
  }
  EXPECT_GT(broken, 0);
}

TEST(TimeTrial, RefusesMazesWithoutACourse) {
  const auto world = seconds_world(time_trial(), test::drive_model("classic"));
  EXPECT_EQ(world->refuse(course()), "");
  MazeDraft draft({6, 5}, MazeDraft::Inside::open);
  draft.close({5, 2}, Heading::north);
  EXPECT_THAT(world->refuse(Maze(draft)), Says("north", "(5,2)", "--rules"));
  EXPECT_THAT(world->refuse(course().with_start({2, 2}, Heading::north)), Says("(2,2)", "corner"));
  EXPECT_THAT(world->refuse(Maze(MazeDraft({33, 8}, MazeDraft::Inside::open))), Says("33x8", "32x32"));
  EXPECT_EQ(seconds_world(find_rules("uk").rules, test::drive_model("classic"))->refuse(Maze(draft)), "");
}

TEST(TimeTrial, IsOnlyForMiceThatOurControllerDrives) {
  const auto mice = read_specs("controller:sh").contestants;
  ASSERT_THAT(mice, SizeIs(1));
  const PhysicalConditions conditions;
  const auto world = [&](const char* rules) {
    return physical_world(find_rules(rules).rules, test::drive_model("kerise"), conditions);
  };
  EXPECT_EQ(world("uk")->refuse(mice.front()), "");
  EXPECT_THAT(world("time-trial")->refuse(mice.front()), Says("lap", "--rules"));
}

TEST(TimeTrial, IsShownAsOtherContestsAre) {
  for (const auto noise : {std::optional<double>(), std::optional(0.0)}) {
    const DriveRecordFile file = file_of(noise);
    const Json play = play_json(file);
    const auto value = static_cast<double>(file.recorded_score.value().value) / 1e6;
    EXPECT_EQ(play["score"], value);
    EXPECT_EQ(play["scores"].back(), value);
    EXPECT_EQ(play["drive"]["runs"][0]["kind"], "laps");
    EXPECT_EQ(play["drive"]["runs"][0]["laps"].size(), 5U);
    EXPECT_GT(play["drive"]["runs"][0]["to"], 100);
    EXPECT_TRUE(play["goal_frame"].is_number());
    EXPECT_EQ(play["traits"]["runs"].size(), 4U);
    EXPECT_THAT(result_line(file), Says("lap " + std::to_string(file.recorded_score->lap)));
    EXPECT_THAT(story_of(file), Says("lap 5"));
    EXPECT_NE(draw_contest(file).find("m/s"), std::string::npos);
  }
}

TEST(TimeTrial, ChangesNothingInRecordsOfRuns) {
  EXPECT_FALSE(rules_json(find_rules("uk").rules).contains("counts"));
  const std::string text = write_drive_record(test::driven("flood"));
  EXPECT_EQ(text.find("\"lap"), std::string::npos);
}

TEST(TimeTrial, OfSeveralRobotsIsWonByTheFasterOne) {
  const auto score_with = [](const char* robot) {
    RaceOrder order;
    order.world = seconds_world(time_trial(), test::drive_model(robot));
    order.jobs = 1;
    const std::vector<NamedMaze> mazes = {{"course", course()}};
    const Race race = hold_race(read_specs("flood").contestants, mazes, order);
    EXPECT_EQ(race.results.front().outcome, "finished");
    EXPECT_EQ(race.results.front().ratio, 1.0);
    return race.results.front().score.value_or(0.0);
  };
  EXPECT_NE(score_with("classic"), score_with("mm2021"));
}

}  // namespace
}  // namespace labmouse
