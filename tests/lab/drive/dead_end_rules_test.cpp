// Rules that count dead ends, in all worlds in seconds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "labmouse/contest/dead_ends.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/lab/bounds/drive_bound.hpp"
#include "labmouse/lab/finish_curves/finish_curves.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/replays/play_seconds.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::at_errors;
using test::Says;

DriveRules coverage() { return find_rules("coverage").rules; }

/// Three dead ends, at (1,0), (0,2) and (2,2), beside the way of three cells from the start to the goal.
const Maze& branches() {
  static const Maze maze = test::drawn(R"(
    o---o---o---o
    |   | G |   |
    o   o   o   o
    |           |
    o   o---o   o
    | S |       |
    o---o---o---o
  )");
  return maze;
}

/// The record of these actions in the world in seconds.
DriveRecordFile file_of(std::vector<Action> actions, const Maze& maze = branches()) {
  DriveRecordFile file = test::driven("flood", maze, "kerise", "coverage");
  Script mouse(maze.size(), std::move(actions));
  file.record = drive(maze, file.rules, *file.model, mouse);
  const DriveScore result = score(file.record, file.rules);
  file.recorded_score = result.best ? std::optional(result.runs[*result.best]) : std::nullopt;
  return file;
}

Action ahead(int rotation = 0) { return Action::step(rotation, 1); }

/// Straight to (0,2), which is a dead end, and back; then to the goal: five steps instead of three.
std::vector<Action> by_one_dead_end() { return {ahead(), ahead(), ahead(180), ahead(-90), ahead(-90)}; }

TEST(DeadEndRules, ScoreTheShareSeenBySteps) {
  const DriveRecordFile file = file_of(by_one_dead_end());
  ASSERT_TRUE(file.record.runs.at(0).dead_ends);
  EXPECT_EQ(*file.record.runs[0].dead_ends, (DeadEndCount{.seen = 1, .all = 3, .steps = 5, .fewest_steps = 3}));
  // 100 * 1/3 * 3/5 marks.
  EXPECT_EQ(score(file.record, file.rules).value(), 80'000'000);
  EXPECT_THAT(result_line(file), Says("20.000 of 100", "1/3", "3/5"));
}

TEST(DeadEndRules, HaveExactMarks) {
  DriveRules rules = coverage();
  EXPECT_EQ(marks_lost({.seen = 3, .all = 3, .steps = 7, .fewest_steps = 7}, rules), 0);
  EXPECT_EQ(marks_lost({.seen = 0, .all = 3, .steps = 7, .fewest_steps = 7}, rules), 100'000'000);
  EXPECT_EQ(marks_lost({.seen = 1, .all = 3, .steps = 7, .fewest_steps = 7}, rules), 66'666'667);
  EXPECT_EQ(marks_lost({.seen = 3, .all = 3, .steps = 14, .fewest_steps = 7}, rules), 50'000'000);
  // Steps cannot be fewer than the fewest.
  EXPECT_EQ(marks_lost({.seen = 3, .all = 3, .steps = 6, .fewest_steps = 7}, rules), 0);
  EXPECT_EQ(marks_lost({}, rules), 100'000'000);
  rules.marks = 60;
  EXPECT_EQ(marks_lost({.seen = 3, .all = 3, .steps = 14, .fewest_steps = 7}, rules), 30'000'000);
}

TEST(DeadEndRules, CountEachDeadEndOnce) {
  std::vector<Action> twice = {ahead(), ahead(), ahead(180), ahead(180), ahead(180), ahead(-90), ahead(-90)};
  const DriveRecordFile file = file_of(std::move(twice));
  ASSERT_TRUE(file.record.runs.at(0).dead_ends);
  EXPECT_EQ(file.record.runs[0].dead_ends->seen, 1);
  EXPECT_EQ(file.record.runs[0].dead_ends->steps, 7);
}

TEST(DeadEndRules, CountNothingBehindTheGoal) {
  std::vector<Action> on = by_one_dead_end();
  for (const int rotation : {180, -90, -90, 180}) on.push_back(ahead(rotation));
  const DriveRecordFile file = file_of(std::move(on));
  ASSERT_TRUE(file.record.runs.at(0).dead_ends);
  EXPECT_EQ(file.record.runs[0].dead_ends->seen, 1);
  EXPECT_EQ(file.record.runs[0].dead_ends->steps, 5);
}

TEST(DeadEndRules, GiveNothingToAMouseThatDoesNotArrive) {
  const DriveRecordFile file = file_of({ahead(), ahead(), ahead(180)});
  EXPECT_EQ(score(file.record, file.rules).value(), std::nullopt);
  EXPECT_EQ(replay(file), "");
}

TEST(DeadEndRules, TakeStartAndGoalsForNoDeadEnds) {
  EXPECT_EQ(dead_ends_in(branches()).count(), 3);
  EXPECT_FALSE(dead_ends_in(branches()).contains({0, 0}));
  EXPECT_FALSE(dead_ends_in(branches()).contains({1, 2}));
  const auto world = seconds_world(coverage(), test::drive_model("classic"));
  EXPECT_EQ(world->refuse(branches()), "");
  EXPECT_THAT(world->refuse(Maze(MazeDraft({6, 5}, MazeDraft::Inside::open))), Says("dead end", "--rules"));
}

TEST(DeadEndRules, HaveABoundWhereAGoalIsReached) {
  const auto model = test::drive_model("kerise");
  EXPECT_EQ(drive_bound_of(branches(), coverage(), *model).score, 0);
  DriveRules short_time = coverage();
  short_time.time_limit = 1000;
  EXPECT_EQ(drive_bound_of(branches(), short_time, *model).score, std::nullopt);
}

TEST(DeadEndRules, AreReadAndReplayedFromRecords) {
  for (const bool physical : {false, true}) {
    DriveRecordFile file = file_of(by_one_dead_end());
    if (physical) {
      file = test::physical_file("flood", at_errors(0.0));
      file.maze = branches();
      file.rules = coverage();
      PhysicalRecord record = test::driven_physically("flood", branches(), at_errors(0.0), 1, file.rules);
      file.record = std::move(record.drive);
      file.physical->notes = std::move(record);
      file.recorded_score = score(file.record, file.rules).runs.at(0);
    }
    const std::string text = write_drive_record(file);
    const ReadDriveRecordResult result = read_drive_record(text);
    ASSERT_TRUE(result.file);
    EXPECT_EQ(result.file->record, file.record);
    EXPECT_EQ(result.file->rules.counts, Counted::dead_end);
    EXPECT_EQ(result.file->rules.marks, 100);
    EXPECT_EQ(replay(*result.file), "");
    DriveRecordFile wrong = *result.file;
    ++wrong.record.runs.at(0).dead_ends->seen;
    EXPECT_NE(replay(wrong), "");
    EXPECT_EQ(play_json(file)["traits"]["unit"], "marks lost");
    EXPECT_NE(draw_contest(file).find("marks lost"), std::string::npos);
  }
}

TEST(DeadEndRules, AreReadFromAFile) {
  const std::string text =
      "source = \"Ours\"\ncounts = \"dead end\"\ntime_limit = 60\nruns = 1\nclock = \"gate to gate\"\n";
  EXPECT_EQ(read_drive_rules(text + "marks = 60\n", "ours").rules.value().marks, 60);
  const auto problems = [](const std::string& wrong) {
    std::string all;
    for (const Problem& problem : read_drive_rules(wrong, "ours").problems) all += problem.reason + "\n";
    return all;
  };
  EXPECT_THAT(problems(text), Says("'marks'", "1 to 10000"));
  EXPECT_THAT(problems(text + "marks = 60\ntouch_penalty = 2\n"), Says("'touch_penalty'", "dead end"));
  EXPECT_THAT(problems("source = \"Ours\"\ntime_limit = 60\nruns = 1\nclock = \"gate to gate\"\nmarks = 60\n"),
              Says("'marks'", "\"run\""));
}

/// A race of flood in the physical world. At variation 2 it crashes in some contests.
Race race_at(double variation) {
  RaceOrder order;
  order.world = physical_world(coverage(), test::drive_model("kerise"), test::at_variation(variation));
  order.runs = 20;
  order.jobs = 1;
  return hold_race(read_specs("flood").contestants, {{"branches", branches()}}, order);
}

TEST(DeadEndRules, CountAFailedContestAsAllMarksLost) {
  const Race race = race_at(2.0);
  const Standing standing = standings_of(race).front();
  ASSERT_LT(standing.finished, standing.runs);
  ASSERT_GT(standing.finished, 0);
  const double at_limit =
      (standing.finished * standing.mean_all.value() + 100.0 * (standing.runs - standing.finished)) / standing.runs;
  EXPECT_NEAR(standing.mean_at_limit.value(), at_limit, 1e-9);
  EXPECT_NEAR(std::get<double>(figure_of(race, standing, "mean_par1")), at_limit, 1e-9);
}

TEST(DeadEndRules, NameTheirUnitInTables) {
  const Race race = race_at(2.0);
  EXPECT_THAT(table_of(race, false, false), Says("marks lost", "100 marks"));
  const std::vector<Race> races = {race_at(0.0), race};
  EXPECT_THAT(table_of(finish_curves(races), race.world()), Says("marks lost", "counts 100"));
  // All lines of the leaderboard are equally long.
  std::vector<std::size_t> lengths;
  std::istringstream lines(leaderboard_of(race, false, true));
  for (std::string line; std::getline(lines, line);) lengths.push_back(line.size());
  EXPECT_THAT(lengths, testing::Each(lengths.front()));
}

}  // namespace
}  // namespace labmouse
