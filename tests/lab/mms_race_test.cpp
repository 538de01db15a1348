#include "labmouse/lab/races/mms_race.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "labmouse/lab/galleries/mms_folder.hpp"
#include "labmouse/lab/standings/mms_standings.hpp"
#include "labmouse/lab/system/files.hpp"
#include "tests/lab/mms_fixture.hpp"

namespace labmouse {
namespace {

using test::hook;
using test::loop;
using test::mms_mouse;
using test::plank;
using test::shaft;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A mouse that knows the maze and asks for the moves of its best run.
MmsMouse witness_of(const Maze& maze) {
  std::vector<std::string> words;
  for (const std::string& line : mms_best_commands(maze)) words.push_back("ask:" + line);
  return mms_mouse("witness", words);
}

TEST(MmsRace, HoldsEveryMouseInEveryMazeInTheOrderOfNames) {
  const MmsRace race =
      hold_mms_race({mms_mouse("b", {"ask:mazeWidth"}), mms_mouse("a", {"exit:2"})}, {plank(), loop()}, {});
  EXPECT_FALSE(race.stopped);
  EXPECT_EQ(race.mice[0].name, "mms:a");
  EXPECT_EQ(race.mazes[0].name, "loop");
  ASSERT_EQ(race.results.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(race.results[i].done);
    EXPECT_EQ(race.results[i].mouse, i / 2);
    EXPECT_EQ(race.results[i].maze, i % 2);
    EXPECT_EQ(race.results[i].run.end, i < 2 ? "exit code 2" : "exit code 0");
    EXPECT_EQ(race.results[i].run.lines, i < 2 ? 0 : 1);
  }
}

TEST(MmsRace, AMouseThatPlaysABestRunScoresTheBound) {
  for (const NamedMaze& maze : {plank(), test::corridor(), loop()}) {
    const MmsRace race = hold_mms_race({witness_of(maze.maze)}, {maze}, {});
    EXPECT_DOUBLE_EQ(*score_ratio(race, race.results[0]), 1.0) << maze.name;
    EXPECT_DOUBLE_EQ(*run_ratio(race, race.results[0]), 1.0) << maze.name;
  }
}

TEST(MmsRace, ResultsDoNotDependOnTheNumberOfThreads) {
  const auto scores = [](int jobs) {
    MmsRaceOrder order;
    order.jobs = jobs;
    std::vector<float> list;
    for (const MmsResult& result : hold_mms_race({witness_of(loop().maze), mms_mouse("turner", {"burst:99:turnLeft"})},
                                                 {loop(), plank(), hook()}, order)
                                       .results)
      list.push_back(result.run.statistics.total_turns);
    return list;
  };
  EXPECT_EQ(scores(1), scores(4));
}

TEST(MmsRace, KeepsLittleOfLongTexts) {
  const MmsRace race =
      hold_mms_race({mms_mouse("chatter", {"burst:50:what?", "errors:one", "errors:two", "errors:three", "errors:four",
                                           "errors:five", "errors:" + std::string(1000, 'x'), "say:setColor 0 0 G"})},
                    {plank()}, {});
  const MmsRun& run = race.results[0].run;
  EXPECT_EQ(run.invalid_lines, 50);
  EXPECT_EQ(run.log.size(), kept_log);
  EXPECT_EQ(run.errors, "two\nthree\nfour\nfive\n" + std::string(kept_text, 'x') + "\n");
  EXPECT_EQ(run.canvas, MmsCanvas());
}

TEST(MmsRace, TellsOfEachRunWithItsRecordWhereOneIsWanted) {
  std::vector<std::string> records;
  MmsRaceHooks hooks;
  hooks.finished = [&](const MmsRace&, const MmsResult& result, const std::string& record) {
    EXPECT_TRUE(result.done);
    records.push_back(record);
  };
  MmsRaceOrder order;
  hold_mms_race({mms_mouse("a", {"ask:turnLeft"})}, {plank()}, order, hooks);
  order.records = true;
  hold_mms_race({mms_mouse("a", {"ask:turnLeft"})}, {plank()}, order, hooks);
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0], "");
  EXPECT_THAT(records[1], HasSubstr("\"line\":\"turnLeft\""));
}

TEST(MmsRace, BeginsNoOtherRunOnceItIsStopped) {
  std::atomic<bool> stop = false;
  MmsRaceHooks hooks;
  hooks.stop = &stop;
  hooks.finished = [&](const MmsRace&, const MmsResult&, const std::string&) { stop = true; };
  MmsRaceOrder order;
  order.jobs = 1;
  const MmsRace race =
      hold_mms_race({mms_mouse("a", {}), mms_mouse("b", {"ask:turnLeft", "hang"})}, {plank(), hook()}, order, hooks);
  EXPECT_TRUE(race.stopped);
  EXPECT_EQ(std::count_if(race.results.begin(), race.results.end(), [](const MmsResult& r) { return r.done; }), 1);
}

TEST(MmsRace, ARunThatWasUnderWayIsEndedAndLeftOut) {
  std::atomic<bool> stop = false;
  MmsRaceHooks hooks;
  hooks.stop = &stop;
  hooks.finished = [&](const MmsRace&, const MmsResult& result, const std::string&) {
    EXPECT_EQ(result.mouse, 0U);
    stop = true;
  };
  MmsRaceOrder order;
  order.jobs = 2;
  const MmsRace race =
      hold_mms_race({mms_mouse("a", {}), mms_mouse("b", {"ask:turnLeft", "hang"})}, {plank()}, order, hooks);
  EXPECT_TRUE(race.stopped);
  EXPECT_FALSE(race.results[1].done);
}

TEST(MmsRace, HandsItsOptionsOn) {
  MmsRaceOrder order;
  order.options.strict = true;
  EXPECT_EQ(hold_mms_race({mms_mouse("a", {"say:what?", "hang"})}, {plank()}, order).results[0].run.outcome,
            MmsOutcome::invalid);
}

TEST(MmsRaceFolder, SavesUnderTheNamesOfMouseAndMaze) {
  const auto folder = std::filesystem::temp_directory_path() / ("labmouse-mms-" + std::to_string(getpid()));
  NamedMaze maze = plank();
  maze.name = "far/away/plank.txt";
  const MmsRace race = test::imagined_race({"./a b", "./a:b"}, {maze, plank()});
  const MmsRaceFolder races(folder.string(), race);
  EXPECT_EQ(races.save({0, 0, true, {}}, "one"), "");
  EXPECT_EQ(races.save({1, 1, true, {}}, "two"), "");
  EXPECT_EQ(read_file((folder / "mms_._a_b/plank.jsonl").string()).content, "one");
  EXPECT_EQ(read_file((folder / "mms_._a_b~2/plank~2.jsonl").string()).content, "two");
  std::filesystem::remove_all(folder);
  EXPECT_THAT(MmsRaceFolder("/dev/null", race).save({0, 0, true, {}}, "x"), HasSubstr("error"));
}

TEST(LastLines, AreTheLastFiveThatSaySomething) {
  EXPECT_THAT(last_lines("a\nb\n\n  \nc\nd\ne\r\n\r\nf\n"), ElementsAre("b", "c", "d", "e\r", "f"));
  EXPECT_THAT(last_lines("only"), ElementsAre("only"));
  EXPECT_THAT(last_lines(""), ElementsAre());
  EXPECT_THAT(last_lines("\n\n"), ElementsAre());
}

TEST(LastLines, LeaveOutTheMarksOfATraceback) {
  EXPECT_THAT(last_lines("  a = b / c\n      ~~^~~\n    ^\n ~\t~\nd ^ e\n"), ElementsAre("  a = b / c", "d ^ e"));
}

/// Two mice in two mazes with a way to the centre and one without.
MmsRace two_mice() {
  MmsRace race = test::imagined_race({"a", "b"}, {loop(), plank(), shaft()});
  MmsRun unsolved;
  unsolved.outcome = MmsOutcome::hung;
  unsolved.statistics.total_effective_distance = 100;
  unsolved.lines = 7;
  unsolved.invalid_lines = 2;
  race.results = {{0, 0, true, test::imagined_run(40, 10, 180, 20)},
                  {0, 1, true, unsolved},
                  {0, 2, true, unsolved},
                  {1, 0, true, test::imagined_run(30, 6, 30, 6)},
                  {1, 1, true, test::imagined_run(2, 0, 2, 1)},
                  {1, 2, false, {}}};
  return race;
}

TEST(MmsStandings, CountTheScoreOfMmsForUnsolvedMazes) {
  const auto standings = mms_standings_of(two_mice());
  ASSERT_EQ(standings.size(), 2U);
  EXPECT_EQ(standings[0].mouse, 1U);  // the better one
  const MmsStanding& a = standings[1];
  EXPECT_EQ(a.runs, 2);
  EXPECT_EQ(a.solved, 1);
  EXPECT_DOUBLE_EQ(*a.mean_score, (70.0 + 2000.0) / 2);
  EXPECT_DOUBLE_EQ(*a.mean_solved_score, 70.0);
  EXPECT_DOUBLE_EQ(*a.mean_best_run, 50.0);
  EXPECT_DOUBLE_EQ(*a.mean_total, (200.0 + 100.0) / 2);
  EXPECT_LE(a.interval.low, *a.mean_score);
  EXPECT_GE(a.interval.high, *a.mean_score);
}

TEST(MmsStandings, CompareWithTheBound) {
  const MmsRace race = two_mice();
  const MmsStanding a = mms_standings_of(race)[1];
  EXPECT_DOUBLE_EQ(*a.mean_ratio, 70.0 / *race.bounds[0].score);
  EXPECT_DOUBLE_EQ(*a.mean_run_ratio, 50.0 / *race.bounds[0].run);
}

TEST(MmsStandings, CountLinesAndOutcomesOfAllThatWasDone) {
  const MmsStanding a = mms_standings_of(two_mice())[1];
  EXPECT_EQ(a.lines, 34);
  EXPECT_EQ(a.invalid_lines, 4);
  EXPECT_EQ(a.outcomes[static_cast<std::size_t>(MmsOutcome::complete)], 1);
  EXPECT_EQ(a.outcomes[static_cast<std::size_t>(MmsOutcome::hung)], 2);
}

TEST(MmsStandings, LeaveOutWhatWasNotDone) {
  MmsRace race = two_mice();
  for (MmsResult& result : race.results) result.done = false;
  const MmsStanding standing = mms_standings_of(race)[0];
  EXPECT_EQ(standing.runs, 0);
  EXPECT_FALSE(standing.mean_score || standing.mean_ratio || standing.mean_total || standing.mean_seconds);
}

TEST(MmsStandings, AMazeThatStartsInItsGoalHasNoRatio) {
  MmsRace race = test::imagined_race({"a"}, {hook()});
  race.results = {{0, 0, true, test::imagined_run(0, 0, 0, 1)}};
  const MmsStanding standing = mms_standings_of(race)[0];
  EXPECT_EQ(standing.solved, 1);
  EXPECT_FALSE(standing.mean_run_ratio);
}

}  // namespace
}  // namespace labmouse
