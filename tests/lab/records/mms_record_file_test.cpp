// Records of mms: read back, and given to the simulator again.
#include "labmouse/lab/records/mms_record_file.hpp"

#include <gmock/gmock.h>

#include "labmouse/lab/records/mms_record.hpp"
#include "labmouse/lab/replays/mms_replay.hpp"
#include "tests/lab/records/mms_record_fixture.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::changed;
using test::mms_recorded;
using test::ProblemAt;
using test::Says;
using test::SaysAt;
using ::testing::HasSubstr;

const std::vector<std::string> walk = {"setColor 0 0 G", "turnRight", "moveForward", "setText 1 0 goal", "ackReset"};

MmsRecordFile read(const std::string& text) {
  ReadMmsRecordResult result = read_mms_record(text);
  if (!result.file) ADD_FAILURE() << result.problems.front().line << ": " << result.problems.front().reason;
  return result.file ? *result.file : MmsRecordFile();
}

Problem problem(const std::string& text) {
  const ReadMmsRecordResult result = read_mms_record(text);
  EXPECT_FALSE(result.file.has_value());
  return result.problems.empty() ? Problem() : result.problems.front();
}

std::string disagreement(const std::string& text) {
  return replay(read(text), [](std::size_t, const MmsHost&) {});
}

TEST(MmsRecordFile, IsReadAsItWasWritten) {
  const MmsRecordFile file = read(mms_recorded(walk));
  EXPECT_EQ(file.mouse, "mms:./mouse");
  EXPECT_EQ(file.maze_name, "plank");
  EXPECT_EQ(file.maze->size(), (Size{3, 1}));
  ASSERT_EQ(file.events.size(), 5U);
  EXPECT_EQ(file.events[2].line, "moveForward");
  EXPECT_EQ(file.events[2].reply, "ack");
  EXPECT_EQ(file.events[2].pose, (HalfPose{{3, 1}, Compass::east}));
  EXPECT_GT(file.events[2].clock, 0);
  EXPECT_EQ(file.events[3].reply, "");
  ASSERT_TRUE(file.end);
  EXPECT_EQ(file.end->outcome, "complete");
  EXPECT_EQ(file.end->end, "exit code 0");
  EXPECT_TRUE(file.end->statistics.finished);
  EXPECT_EQ(file.end->statistics.total_turns, 1);
  EXPECT_EQ(file.end->lines, 5);
  EXPECT_EQ(disagreement(mms_recorded(walk)), "");
}

TEST(MmsRecordFile, MayBreakOff) {
  const std::string whole = mms_recorded(walk);
  const std::string cut = whole.substr(0, whole.rfind("\n{\"outcome") + 12);
  EXPECT_FALSE(read(cut).end);
  EXPECT_EQ(read(cut).events.size(), 5U);
  EXPECT_EQ(disagreement(cut), "");
}

TEST(MmsRecordFile, MayLeaveEventsOut) {
  const MmsRecordFile file = read(mms_recorded(walk, 2));
  EXPECT_EQ(file.events.size(), 2U);
  EXPECT_EQ(file.left_out, 3);
  EXPECT_EQ(disagreement(mms_recorded(walk, 2)), "");
}

TEST(MmsRecordFile, ThatIsNoneIsRefusedWithItsLine) {
  const std::string good = mms_recorded(walk);
  EXPECT_THAT(problem("").reason, HasSubstr("empty"));
  EXPECT_THAT(problem("{").reason, HasSubstr("JSON"));
  EXPECT_THAT(problem("[]").reason, HasSubstr("object"));
  EXPECT_THAT(problem(changed(good, "mms record", "record")).reason, Says("header", "mms"));
  EXPECT_THAT(problem(changed(good, "\"format\":1", "\"format\":2")).reason, Says("format", "1", "version"));
  EXPECT_THAT(problem(changed(good, "\"maze\"", "\"labyrinth\"")).reason, Says("'maze'", "missing"));
  EXPECT_THAT(problem(changed(good, "\"drawing\"", "\"draft\"")).reason, Says("'maze.drawing'", "missing"));
  EXPECT_THAT(problem(good + good).reason, HasSubstr("end of the record"));
  EXPECT_THAT(problem(changed(good, "\"statistics\"", "\"sums\"")), ProblemAt(7, 1, "'statistics'", "missing"));
  EXPECT_THAT(problem(changed(good, "\"total-turns\":1", "\"total-turns\":\"1\"")).reason,
              Says("'statistics.total-turns'", "number"));
  EXPECT_THAT(problem(changed(good, "\"lines\":5", "\"lines\":5.5")).reason, Says("'lines'", "whole number"));
  EXPECT_THAT(problem(changed(good, "\"log\":[]", "\"log\":[1]")).reason, Says("log", "not a string"));
}

TEST(MmsRecordFile, WithAWrongEventIsRefusedWithItsLine) {
  const std::string good = mms_recorded(walk);
  EXPECT_THAT(problem(changed(good, "\"line\":\"turnRight\"", "\"lime\":\"turnRight\"")),
              ProblemAt(3, 1, "'line'", "missing"));
  EXPECT_THAT(problem(changed(good, "[3,1]", "[3]")), ProblemAt(4, 1, "place", "[x, y]"));
  EXPECT_THAT(problem(changed(good, "[3,1]", "[7,1]")).reason, Says("'place'", "0 to 6"));
  EXPECT_THAT(problem(changed(good, "\"heading\":\"east\"", "\"heading\":\"up\"")).reason, Says("heading", "eight"));
  EXPECT_THAT(problem(changed(good, "\"clock\":0.0", "\"clock\":-1")).reason, Says("'clock'", "negative"));
}

TEST(MmsRecordFile, ThatDoesNotFitItsMazeIsToldOf) {
  const std::string good = mms_recorded(walk);
  EXPECT_THAT(disagreement(changed(good, "[3,1]", "[5,1]")),
              SaysAt("event 3", "ack at [5,1] heading east", "ack at [3,1] heading east"));
  EXPECT_THAT(disagreement(changed(good, "\"moveForward\"", "\"moveForward 3\"")),
              SaysAt("event 3", "ack at [3,1] heading east", "crash at [5,1] heading east"));
  EXPECT_THAT(disagreement(changed(good, "\"turnRight\"", "\"wallFront\"")),
              SaysAt("event 2", "neither moves", "nor draws"));
  EXPECT_THAT(disagreement(changed(good, "\"total-turns\":1", "\"total-turns\":2")), Says("total-turns 2", "1"));
  EXPECT_THAT(disagreement(changed(good, "\"finished\":true", "\"finished\":false")), Says("disagree", "goal"));
}

/// A record of a mouse that never ended, which turns on after it has reached the goal, under that name of its outcome.
std::string never_ended(const std::string& outcome, const MmsStatistics& statistics, int turns = 20) {
  MmsHost host(test::plank().maze, {.most_seconds = 1'000'000});
  MmsRecorder recorder("mms:./mouse", test::plank());
  host.on_event([&](const MmsEvent& event) { recorder.add(event); });
  std::string replies;
  host.obey("turnRight", replies);
  host.obey("moveForward", replies);
  for (; turns > 0; --turns) host.obey("turnRight", replies);
  MmsRun run;
  run.outcome = MmsOutcome::never_ended;
  run.statistics = statistics;
  return changed(recorder.finish(run), "\"never ended\"", "\"" + outcome + "\"");
}

MmsStatistics after_turns(int turns) {
  MmsLedger ledger;
  ledger.count_turn();
  ledger.count_move(2, true);
  ledger.count_arrival(true, false);
  for (; turns > 0; --turns) ledger.count_turn();
  return ledger.statistics();
}

TEST(MmsRecordFile, OfOneThatNeverEndedHasTheStatisticsOfItsBestRun) {
  EXPECT_EQ(disagreement(never_ended("never ended", after_turns(0))), "");
  EXPECT_THAT(disagreement(never_ended("never ended", after_turns(20))), Says("total-turns 21", "1"));
  const MmsReplay played = replay_of(read(never_ended("never ended", after_turns(0))));
  EXPECT_EQ(played.run.outcome, MmsOutcome::never_ended);
  EXPECT_TRUE(is_scored(played.run));
  EXPECT_EQ(played.run.statistics, after_turns(0));
}

TEST(MmsRecordFile, OfEarlierVersionsHasThoseOfItsEnd) {
  for (const char* outcome : {"endless", "out of time"}) {
    EXPECT_EQ(disagreement(never_ended(outcome, after_turns(20))), "");
    const MmsReplay played = replay_of(read(never_ended(outcome, after_turns(20))));
    EXPECT_EQ(played.run.outcome, MmsOutcome::never_ended);
    EXPECT_EQ(played.run.statistics, after_turns(0));
  }
}

TEST(MmsRecordFile, MayBeLongerThanTheUsualLimitOfSimulatedTime) {
  LABMOUSE_SKIP_SANITIZED();
  // A turn takes 0.13 s, so these take 3900 s.
  EXPECT_EQ(disagreement(never_ended("never ended", after_turns(0), 30'000)), "");
}

}  // namespace
}  // namespace labmouse
