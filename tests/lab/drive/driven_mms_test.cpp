// Programs for mms that drive in the worlds in seconds.
#include "labmouse/external/mms/driven_mms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "tests/lab/drive/physical_fixture.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;

/// Two cells to the north, then one to the east: the goal.
const Maze& hook() {
  static const Maze maze = test::drawn(R"(
    o---o---o
    |     G |
    o   o---o
    |   |   |
    o   o   o
    | S |   |
    o---o---o
  )");
  return maze;
}

struct Driven {
  DriveRecord record;
  std::string words;
};

/// A contest of mms_program with these words; see tests/external/mms/mms_program.cpp.
Driven driven(std::vector<std::string> words, const Maze& maze = hook(), ExternalLimits limits = {}) {
  const auto model = test::drive_model("classic");
  const DriveRules rules = find_rules("all-japan").rules;
  Launch launch;
  words.insert(words.begin(), LABMOUSE_MMS_PROGRAM);
  launch.words = std::move(words);
  launch.limits = limits;
  launch.limits.silence = std::chrono::seconds(20);  // on a busy machine
  DrivenMms mouse(launch, brief(maze, rules, *model, 1));
  Driven done;
  done.record = drive(maze, rules, *model, mouse);
  done.words = mouse.report().last_words;
  return done;
}

std::vector<std::string> to_the_goal() {
  return {"ask:moveForward 2", "need:ack", "ask:turnRight", "need:ack", "ask:moveForward", "need:ack"};
}

std::vector<std::string> then(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void expect_finished(const Driven& done, std::size_t moves) {
  EXPECT_EQ(done.record.outcome, DriveOutcome::finished) << done.words;
  EXPECT_EQ(done.words, "");
  ASSERT_EQ(done.record.runs.size(), 3U);
  EXPECT_EQ(done.record.runs[0].moves.size(), moves);
  EXPECT_EQ(done.record.runs[2].kind, DriveRun::Kind::speed);
}

TEST(DrivenMms, MakesASpeedRunOnceTheProgramHasEndedBehindTheGoal) {
  expect_finished(driven(to_the_goal()), 3);
  expect_finished(driven(then(to_the_goal(), {"exit:5"})), 3);
}

TEST(DrivenMms, EndsItsSearchBackAtTheStart) {
  const std::vector<std::string> back = {"ask:turnLeft", "ask:turnLeft", "ask:moveForward",
                                         "need:ack",     "ask:turnLeft", "ask:moveForward 2"};
  expect_finished(driven(then(then(to_the_goal(), back), {"hang"})), 6);
}

TEST(DrivenMms, EndsItsSearchByAResetOrByWaiting) {
  expect_finished(driven(then(to_the_goal(), {"ask:ackReset", "hang"})), 3);
  expect_finished(driven(then(to_the_goal(), {"ask-on:wasReset"})), 3);
  expect_finished(driven(then(to_the_goal(), {"ask-on:wallFront"})), 3);
}

TEST(DrivenMms, AnswersFromTheMapOfTheMouse) {
  expect_finished(driven(then({"ask:mazeWidth",
                               "need:2",
                               "ask:mazeHeight",
                               "need:3",
                               "ask:wallFront",
                               "need:false",
                               "ask:wallLeft",
                               "need:true",
                               "ask:wallRight",
                               "need:true",
                               "ask:wallBack",
                               "need:true",
                               "ask:getStat total-turns",
                               "need:0",
                               "say:setColor 0 0 G",
                               "say:nonsense",
                               "ask:turnLeft",
                               "ask:turnRight",
                               "ask:wasReset",
                               "need:false"},
                              to_the_goal())),
                  3);
}

TEST(DrivenMms, MayTurnByFortyFiveDegrees) {
  expect_finished(driven({"ask:moveForward 2", "ask:turnRight45", "ask:turnRight45", "ask:moveForward", "need:ack"}),
                  3);
}

TEST(DrivenMms, GetsACrashForAWallInItsWay) {
  expect_finished(driven({"ask:moveForward 3", "need:crash", "ask:moveForward", "need:crash", "ask:turnRight",
                          "ask:moveForward", "need:ack"}),
                  3);
}

TEST(DrivenMms, GetsACrashForAWallThatTheMouseHadNotSeen) {
  // Beyond the first cell there is a wall, which is seen only from there.
  const Maze maze = test::drawn(R"(
    o---o---o
    | G     |
    o---o   o
    |       |
    o   o---o
    | S |   |
    o---o---o
  )");
  expect_finished(
      driven({"ask:moveForward 2", "need:crash", "ask:wallFront", "need:true", "ask:turnRight", "ask:moveForward",
              "need:ack", "ask:turnLeft", "ask:moveForward", "need:ack", "ask:turnLeft", "ask:moveForward", "need:ack"},
             maze),
      4);
}

TEST(DrivenMms, MayNotLeaveItsRepliesUnread) {
  ExternalLimits limits;
  limits.most_unread = 1000;
  EXPECT_EQ(driven({"burst:90000:wallFront", "hang"}, hook(), limits).record.reason, ForfeitReason::flooded);
}

TEST(DrivenMms, StartsWhereTheMazeSays) {
  const Maze maze = hook().with_start({0, 2}, Heading::south).with_goals(CellSet::of({0, 0}));
  expect_finished(driven({"ask:moveForward", "ask:turnLeft", "ask:ackReset", "ask:wallLeft", "need:false",
                          "ask:wallBack", "need:true", "ask:moveForward 2", "need:ack"},
                         maze),
                  4);
}

TEST(DrivenMms, MayGoBackToTheStartByAReset) {
  expect_finished(
      driven(then({"ask:moveForward", "ask:turnRight", "ask:ackReset", "need:ack", "ask:wallBack", "need:true"},
                  to_the_goal())),
      5);
}

TEST(DrivenMms, ForfeitsWhereItDoesNotGetToTheGoal) {
  const Driven ended = driven({"ask:moveForward", "errors:I am lost", "exit:3"});
  EXPECT_EQ(ended.record.reason, ForfeitReason::ended_early);
  EXPECT_THAT(ended.words, Says("exit code 3", "I am lost"));
  EXPECT_EQ(driven({"ask-on:wallFront"}).record.reason, ForfeitReason::out_of_time);
  EXPECT_EQ(driven({"ask-on:wasReset"}).record.reason, ForfeitReason::out_of_time);
  const Driven half = driven({"ask:moveForwardHalf"});
  EXPECT_EQ(half.record.reason, ForfeitReason::invalid_answer);
  EXPECT_THAT(half.words, Says("half a cell", "whole cells"));
  // Behind a goal, too, where to end or to do nothing any more ends the search.
  EXPECT_EQ(driven(then(to_the_goal(), {"ask:turnLeft", "ask:turnLeft", "ask:moveForwardHalf"})).record.reason,
            ForfeitReason::invalid_answer);
  EXPECT_EQ(driven(then(to_the_goal(), {"say:" + std::string(5'000, 'x')})).record.reason, ForfeitReason::flooded);
}

TEST(DrivenMms, SeesPostsAtFortyFiveDegrees) {
  expect_finished(
      driven(then({"ask:wallFrontLeft", "need:true", "ask:moveForwardHalf 0", "need:crash"}, to_the_goal())), 3);
}

TEST(ExternalMice, DoNotRaceInTimeTrials) {
  for (const char* world : {"seconds", "failures", "physical"})
    EXPECT_THAT(enter(read_specs("program:true").contestants, world, {{"rules", "time-trial"}}).error,
                Says("external", "lap"));
}

TEST(DrivenMms, DoesNotStart) {
  const auto model = test::drive_model("classic");
  const DriveRules rules = find_rules("all-japan").rules;
  Launch launch;
  launch.words = {"./no-such-program"};
  DrivenMms mouse(launch, brief(hook(), rules, *model, 1));
  EXPECT_EQ(drive(hook(), rules, *model, mouse).reason, ForfeitReason::not_started);
  EXPECT_FALSE(mouse.report().started);
}

TEST(ExternalMice, RaceInEveryWorldInSeconds) {
  const std::string robot = LABMOUSE_SOURCE_DIR "/templates/robots/flood_and_return.py";
  const std::string program = "python3 \"" LABMOUSE_SOURCE_DIR "/templates/program.py\"";
  for (const char* world : {"seconds", "failures", "physical"}) {
    SCOPED_TRACE(world);
    const SpecResult mice = read_specs("capstone:" + robot + ",program:" + program);
    WorldSettings settings;
    if (world != std::string_view("seconds")) settings = {{"variation", "lab"}};
    const auto entered = enter(read_specs("capstone:" + robot).contestants, world, settings);
    ASSERT_EQ(entered.error, "");
    auto both = entered.entries.front();
    both.mice.push_back(read_specs("program:" + program).contestants.front());
    RaceOrder order;
    order.world = both.world;
    const Race race = hold_race(both.mice, {{"ring", test::ring()}}, order);
    ASSERT_EQ(race.results.size(), 2U);
    for (const ContestResult& result : race.results) EXPECT_EQ(result.outcome, "finished");
  }
}

TEST(ExternalMice, GetTheSameSeedInAllMazesWhereTheyDrive) {
  // It prints its seed, and ends.
  const auto entered = enter(
      read_specs("program:sh -c \"while read word n; do case $word in seed) echo $n >&2;; begin) exit;; esac; done\"")
          .contestants,
      "failures", {});
  ASSERT_EQ(entered.error, "");
  RaceOrder order;
  order.world = entered.entries.front().world;
  const Race race = hold_race(entered.entries.front().mice, {{"a", test::ring()}, {"b", test::ring()}}, order);
  ASSERT_EQ(race.results.size(), 2U);
  EXPECT_NE(race.results[0].seed, race.results[1].seed);
  for (const ContestResult& result : race.results)
    EXPECT_THAT(std::get<std::string>(figure_of(race, result, said_last)), Says(std::to_string(result.told)));
}

TEST(MmsPrograms, RaceInTheWorldOfMmsUnlessAnotherIsNamed) {
  const auto by_default = enter(read_specs("mms:true").contestants, "", {});
  ASSERT_EQ(by_default.entries.size(), 1U);
  EXPECT_EQ(by_default.entries.front().world->traits().name, "mms");
  EXPECT_EQ(enter(read_specs("mms:true").contestants, "physical", {}).error, "");
}

}  // namespace
}  // namespace labmouse
