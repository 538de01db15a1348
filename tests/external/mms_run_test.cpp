#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "labmouse/external/mms/run.hpp"
#include "tests/external/mms_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using namespace std::chrono_literals;
using test::Says;
using ::testing::HasSubstr;

Launch external(std::vector<std::string> words) {
  words.insert(words.begin(), LABMOUSE_MMS_PROGRAM);
  Launch launch;
  launch.words = std::move(words);
  launch.limits.silence = launch.limits.start = 20s;  // of those that answer, on a busy machine
  return launch;
}

MmsRun hosted(std::vector<std::string> words, const MmsOptions& options = {}) {
  return run_mms(external(std::move(words)), test::field(), options);
}

MmsRun hosted(const Launch& launch) { return run_mms(launch, test::field(), {}); }

TEST(MmsRun, AnswersAndCountsUntilTheProgramEnds) {
  const MmsRun run = hosted({"ask:mazeWidth", "need:16", "ask:wallLeft", "need:true", "ask:moveForward 3", "need:ack",
                             "ask:turnRight45", "say:setColor 2 1 G", "say:setText 0 0 hi"});
  EXPECT_EQ(run.outcome, MmsOutcome::complete);
  EXPECT_EQ(run.end, "exit code 0");
  EXPECT_EQ(run.lines, 6);
  EXPECT_EQ(run.statistics.total_distance, 6);
  EXPECT_EQ(run.statistics.total_turns, 1);
  EXPECT_EQ(run.pose, (HalfPose{{1, 7}, Compass::north_east}));
  EXPECT_EQ(run.canvas.colour({2, 1}), 'G');
  EXPECT_EQ(run.canvas.text({0, 0}), "hi");
  EXPECT_GT(run.clock, 1.2);
  EXPECT_GT(run.seconds, 0.0);
}

TEST(MmsRun, OtherExitCodesAreFailuresWhoseStatisticsCount) {
  const MmsRun run = hosted({"ask:moveForward", "errors:first", "errors:no way out", "exit:3"});
  EXPECT_EQ(run.outcome, MmsOutcome::failed);
  EXPECT_EQ(run.end, "exit code 3");
  EXPECT_EQ(run.statistics.total_distance, 2);
  EXPECT_EQ(run.errors, "first\nno way out\n");
}

TEST(MmsRun, SignalsAreFailuresWithTheirNames) {
  const MmsRun run = hosted({"signal:" + std::to_string(SIGTERM)});
  EXPECT_EQ(run.outcome, MmsOutcome::failed);
  EXPECT_THAT(run.end, Says("signal 15"));
}

TEST(MmsRun, OnesThatNeverEndDoSoAtTheSameLineHoweverFastTheyAre) {
  MmsOptions few;
  few.most_lines = 1000;
  const MmsRun run = hosted({"burst:5000:turnLeft", "hear:5000"}, few);
  EXPECT_EQ(run.outcome, MmsOutcome::never_ended);
  EXPECT_EQ(run.lines, 1000);
  EXPECT_EQ(run.statistics.total_turns, 1000);
  EXPECT_THAT(run.end, Says("1000 lines"));
  MmsOptions short_time;
  short_time.most_seconds = 10;
  const MmsRun slow = hosted({"burst:5000:turnLeft", "hear:5000"}, short_time);
  EXPECT_EQ(slow.outcome, MmsOutcome::never_ended);
  EXPECT_GE(slow.clock, 10.0);
  EXPECT_LT(slow.clock, 10.5);
  EXPECT_THAT(slow.end, Says("10 s"));
}

/// Into the goal of the field, and to and fro on its edge for ever.
const std::vector<std::string> there_and_on = {"ask:moveForward 7", "ask:turnRight", "ask:moveForward 7",
                                               "ask-on:moveForward/turnRight/turnRight"};

TEST(MmsRun, WhatAProgramReachedCountsThoughItNeverEnds) {
  const MmsRun run = hosted(there_and_on, {.most_seconds = 200});
  EXPECT_EQ(run.outcome, MmsOutcome::never_ended);
  EXPECT_TRUE(is_scored(run));
  // The straights of seven cells count 8 each.
  EXPECT_EQ(run.statistics.best_run_effective_distance, 16);
  EXPECT_FLOAT_EQ(run.statistics.score, 17 + 1.7F);
  EXPECT_GT(run.lines, 100);
  EXPECT_THAT(run.end, Says("200 s", "--simulated-limit", "from line 4 on", "6 commands", "(8,7) (7,7)"));
}

TEST(MmsRun, TheScoreOfOneThatNeverEndsDependsOnNoLimit) {
  const MmsStatistics few = hosted(there_and_on, {.most_lines = 100}).statistics;
  EXPECT_EQ(few, hosted(there_and_on, {.most_lines = 5000}).statistics);
  Launch timed = external(there_and_on);
  timed.limits.contest = 150ms;
  const MmsRun run = run_mms(timed, test::field(), {.most_seconds = 1'000'000});
  EXPECT_EQ(run.outcome, MmsOutcome::never_ended);
  EXPECT_EQ(few, run.statistics);
}

TEST(MmsRun, OneThatNeverEndsNorReachesTheGoalHasNoScore) {
  const MmsRun run = hosted({"ask-on:moveForward/turnRight"}, {.most_lines = 5000});
  EXPECT_EQ(run.outcome, MmsOutcome::never_ended);
  EXPECT_FALSE(is_scored(run));
  EXPECT_EQ(run.statistics.score, 2000);
  EXPECT_GT(run.statistics.total_turns, 2000);
}

TEST(MmsRun, OneThatHangsInTheGoalHasItsScore) {
  for (const char* end : {"hang", "work", "ask:turnright"}) {
    Launch silent = external({"ask:moveForward 7", "ask:turnRight", "ask:moveForward 7", "ask:turnRight", end});
    silent.limits.silence = silent.limits.decision = 60ms;
    const MmsRun run = hosted(silent);
    EXPECT_EQ(run.outcome, MmsOutcome::hung) << end;
    EXPECT_TRUE(is_scored(run)) << end;
    EXPECT_FLOAT_EQ(run.statistics.score, 17 + 1.8F) << end;
  }
}

TEST(MmsRun, WhatTheMachineEndedHasNoScore) {
  for (const MmsOutcome outcome : {MmsOutcome::too_many_processes, MmsOutcome::too_much_memory,
                                   MmsOutcome::too_much_written, MmsOutcome::not_judged}) {
    MmsRun run;
    run.statistics.finished = true;
    EXPECT_TRUE(is_scored(run));
    run.outcome = outcome;
    EXPECT_FALSE(is_scored(run));
  }
}

TEST(MmsRun, SilenceAtTheStartEndsIt) {
  Launch silent = external({"hang"});
  silent.limits.start = 60ms;
  const MmsRun run = hosted(silent);
  EXPECT_EQ(run.outcome, MmsOutcome::hung);
  EXPECT_THAT(run.end, Says("0.06 s", "starting", "flush"));
}

TEST(MmsRun, WhatAProgramSaysOfItsEndHidesNothing) {
  Launch silent = external({"errors:thinking", "ask:turnright"});
  silent.limits.silence = 60ms;
  const MmsRun run = hosted(silent);
  EXPECT_EQ(run.outcome, MmsOutcome::hung);
  EXPECT_EQ(run.errors, "thinking\n");
}

TEST(MmsRun, SilenceLaterEndsItByALimitOfItsOwn) {
  Launch silent = external({"ask:moveForward", "hang"});
  silent.limits.silence = 60ms;
  const MmsRun run = hosted(silent);
  EXPECT_EQ(run.outcome, MmsOutcome::hung);
  EXPECT_THAT(run.end, Says("no line", "0.06 s"));
  EXPECT_EQ(run.statistics.total_distance, 2);
}

TEST(MmsRun, WorkWithoutALineEndsIt) {
  Launch working = external({"ask:moveForward", "work"});
  working.limits.decision = 60ms;
  const MmsRun run = hosted(working);
  EXPECT_EQ(run.outcome, MmsOutcome::hung);
  EXPECT_THAT(run.end, Says("processor time", "--decision-limit"));
}

TEST(MmsRun, BytesOfALineThatNeverEndsAreSilence) {
  Launch dripping = external({"ask:mazeWidth", "drip"});
  dripping.limits.silence = 100ms;
  EXPECT_EQ(hosted(dripping).outcome, MmsOutcome::hung);
}

TEST(MmsRun, AWholeContestHasItsLimit) {
  Launch asking = external({"ask-on:mazeWidth"});
  asking.limits.contest = 150ms;
  const MmsRun run = hosted(asking);
  EXPECT_EQ(run.outcome, MmsOutcome::never_ended);
  EXPECT_THAT(run.end, Says("0.15 s", "--contest-limit", "'mazeWidth'", "(0,0)"));
}

TEST(MmsRun, ALineThatIsTooLongIsAFlood) {
  Launch rambling = external({"part:" + std::string(200, 'a'), "hang"});
  rambling.limits.longest_line = 100;
  const MmsRun run = hosted(rambling);
  EXPECT_EQ(run.outcome, MmsOutcome::flooded);
  EXPECT_THAT(run.end, Says("line", "100 bytes"));
}

TEST(MmsRun, RepliesThatNobodyReadsAreAFlood) {
  Launch deaf = external({"pour:mazeWidth"});
  deaf.limits.most_unread = 100'000;
  const MmsRun run = hosted(deaf);
  EXPECT_EQ(run.outcome, MmsOutcome::flooded);
  EXPECT_THAT(run.end, Says("100000 bytes", "replies"));
}

TEST(MmsRun, LinesInOneWriteGetTheirRepliesInOrder) {
  EXPECT_EQ(hosted({"burst:4000:mazeWidth", "say:wallFront", "hear:4000", "need:16", "hear:1", "need:false"}).outcome,
            MmsOutcome::complete);
}

TEST(MmsRun, AMillionLinesAtOnceAreObeyed) {
  const MmsRun run = hosted({"burst:1000000:turnRight", "hear:1000000", "need:ack"}, {.most_seconds = 1'000'000});
  EXPECT_EQ(run.outcome, MmsOutcome::complete);
  EXPECT_EQ(run.statistics.total_turns, 1'000'000);
}

TEST(MmsRun, RepliesBeyondWhatAPipeHoldsWaitForTheirReader) {
  const MmsRun run = hosted({"trickle:40000:mazeWidth", "say:wallFront", "hear:40000", "need:16", "hear:1",
                             "need:false", "ask:turnRight", "need:ack"});
  EXPECT_EQ(run.outcome, MmsOutcome::complete);
  EXPECT_EQ(run.lines, 40'002);
}

TEST(MmsRun, WhoClosesItsInputIsObeyedToItsEnd) {
  const MmsRun run = hosted({"ask:mazeWidth", "deafen", "trickle:2000:turnRight"});
  EXPECT_EQ(run.outcome, MmsOutcome::complete);
  EXPECT_EQ(run.statistics.total_turns, 2000);
}

TEST(MmsRun, LinesThatTheProgramLeftBehindAreObeyedToo) {
  const MmsRun run = hosted({"burst:50000:turnRight"}, {.most_seconds = 1'000'000});
  EXPECT_EQ(run.outcome, MmsOutcome::complete);
  EXPECT_EQ(run.lines, 50'000);
}

TEST(MmsRun, AnIncompleteLastLineIsDropped) {
  const MmsRun run = hosted({"ask:turnRight", "part:turnRight"});
  EXPECT_EQ(run.outcome, MmsOutcome::complete);
  EXPECT_EQ(run.lines, 1);
}

TEST(MmsRun, ALineWithoutAReplyHangsWhoWaitsForIt) {
  Launch waiting = external({"ask:turnright"});
  waiting.limits.silence = 60ms;
  const MmsRun run = hosted(waiting);
  EXPECT_EQ(run.outcome, MmsOutcome::hung);
  EXPECT_EQ(run.invalid_lines, 1);
  ASSERT_EQ(run.log.size(), 1U);
  EXPECT_THAT(run.log[0], HasSubstr("turnright"));
}

TEST(MmsRun, AStrictRunEndsAtALineWithoutAReply) {
  const MmsRun run = hosted({"ask:moveForward", "ask:turnright"}, {.strict = true});
  EXPECT_EQ(run.outcome, MmsOutcome::invalid);
  EXPECT_EQ(run.end, run.log.front());
  EXPECT_EQ(run.statistics.total_distance, 2);
}

TEST(MmsRun, WhoWaitsForResetIsNotWaitedFor) {
  const MmsRun run = hosted({"ask:moveForward", "ask-on:wasReset"});
  EXPECT_EQ(run.outcome, MmsOutcome::waiting);
  EXPECT_EQ(run.statistics.total_distance, 2);
}

TEST(MmsRun, ResetCanBePressed) {
  const MmsRun run =
      hosted({"burst:100:wasReset", "hear:100", "ask:wasReset", "need:true", "ask:ackReset"}, {.presses = 1});
  EXPECT_EQ(run.outcome, MmsOutcome::complete);
}

TEST(MmsRun, AClosedOutputEndsIt) {
  EXPECT_EQ(hosted({"ask:moveForward", "close", "hang"}).outcome, MmsOutcome::closed);
}

TEST(MmsRun, WhoLeavesOthersBehindIsNotWaitedFor) {
  const MmsRun run = hosted({"ask:moveForward", "leave"});
  EXPECT_EQ(run.outcome, MmsOutcome::left);
  EXPECT_THAT(run.end, Says("exit code 0", "process", "still running"));
}

TEST(MmsRun, WhatCannotBeStartedSaysWhy) {
  Launch nothing;
  nothing.words = {"/no/such/mouse"};
  const MmsRun run = hosted(nothing);
  EXPECT_EQ(run.outcome, MmsOutcome::not_started);
  EXPECT_THAT(run.end, HasSubstr("/no/such/mouse"));
}

TEST(MmsRun, CanBeStopped) {
  std::atomic<bool> stop = false;
  Launch launch = external({"ask:moveForward", "hang"});
  launch.stop = &stop;
  const MmsRun run = run_mms(launch, test::field(), {}, [&](const MmsEvent&, const MmsHost&) { stop = true; });
  EXPECT_EQ(run.outcome, MmsOutcome::interrupted);
}

TEST(MmsRun, TheListenerHearsOfWhatChanges) {
  std::vector<std::string> heard;
  run_mms(external({"ask:mazeWidth", "ask:moveForward 2", "say:setColor 1 1 G", "ask:wallFront"}), test::field(), {},
          [&](const MmsEvent& event, const MmsHost& host) {
            EXPECT_EQ(event.pose, host.pose());
            heard.push_back(std::string(event.line) + "=" + std::string(event.reply));
          });
  EXPECT_THAT(heard, ::testing::ElementsAre("moveForward 2=ack", "setColor 1 1 G="));
}

TEST(MmsRun, TheTimeOfTheListenerIsNotTheProgramsOwn) {
  Launch launch = external({"ask:moveForward", "ask:moveForward"});
  launch.limits.contest = 1s;
  const MmsRun run = run_mms(launch, test::field(), {}, [](const MmsEvent&, const MmsHost&) {
    for (const auto end = std::chrono::steady_clock::now() + 700ms; std::chrono::steady_clock::now() < end;) {
    }
  });
  EXPECT_EQ(run.outcome, MmsOutcome::complete);
  EXPECT_LT(run.seconds, 1.0);
}

TEST(MmsRun, EveryOutcomeHasItsName) {
  EXPECT_EQ(name_of(MmsOutcome::complete), "complete");
  EXPECT_EQ(name_of(MmsOutcome::never_ended), "never ended");
  EXPECT_EQ(name_of(MmsOutcome::not_started), "not started");
  EXPECT_EQ(name_of(MmsOutcome::interrupted), "interrupted");
  EXPECT_EQ(name_of(MmsOutcome::not_judged), "not judged");
}

TEST(MmsRun, OutcomesAreReadUnderTheirNamesAndThoseOfEarlierVersions) {
  for (int i = 0; i <= static_cast<int>(MmsOutcome::not_judged); ++i)
    EXPECT_EQ(mms_outcome_of(name_of(static_cast<MmsOutcome>(i))), static_cast<MmsOutcome>(i));
  EXPECT_EQ(mms_outcome_of("endless"), MmsOutcome::never_ended);
  EXPECT_EQ(mms_outcome_of("out of time"), MmsOutcome::never_ended);
  EXPECT_EQ(mms_outcome_of("happy"), std::nullopt);
}

}  // namespace
}  // namespace labmouse
