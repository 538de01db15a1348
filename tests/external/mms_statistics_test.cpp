// What is counted, and the score.
#include <cstdio>

#include "labmouse/external/mms/statistics.hpp"
#include "tests/external/mms_fixture.hpp"

namespace labmouse::test {
namespace {

class MmsCount : public testing::TestWithParam<Rule> {};
TEST_P(MmsCount, IsRight) { expect(GetParam()); }

#define TOTALS "getStat total-distance\ngetStat total-effective-distance\ngetStat total-turns"
#define CURRENT "getStat current-run-distance\ngetStat current-run-effective-distance\ngetStat current-run-turns"
#define BEST "getStat best-run-distance\ngetStat best-run-effective-distance\ngetStat best-run-turns\ngetStat score"
// To the goal of `corner`, by 4 + 2 + 2 half steps (3 + 2 + 2 effective) and two turns.
#define TO_GOAL "moveForward 2\nturnRight\nmoveForward\nturnRight\nmoveForward\n"

constexpr Rule counts[] = {
    {"TotalsBeginWithZero", field, TOTALS, "0 0 0"},
    {"CurrentRunBeginsWithZero", field, CURRENT, "0 0 0"},
    {"BestRunBeginsWithMinusOneAndTheScoreWith2000", field, BEST, "-1 -1 -1 2000"},

    {"OneHalfStepIsOne", field, "moveForwardHalf\n" TOTALS, "ack 1 1 0"},
    {"TwoHalfStepsAreTwo", field, "moveForwardHalf 2\n" TOTALS, "ack 2 2 0"},
    {"ThreeHalfStepsAreTwoAndAHalf", field, "moveForwardHalf 3\n" TOTALS, "ack 3 2.5 0"},
    {"FourHalfStepsAreThree", field, "moveForwardHalf 4\n" TOTALS, "ack 4 3 0"},
    {"OneCellIsTwo", field, "moveForward\n" TOTALS, "ack 2 2 0"},
    {"TwoCellsAreThree", field, "moveForward 2\n" TOTALS, "ack 4 3 0"},
    {"FiveCellsAreTenAndSix", field, "moveForward 5\n" TOTALS, "ack 10 6 0"},
    {"CommandsCountOneByOne", field, "moveForward\nmoveForward\nmoveForward\n" TOTALS, "ack ack ack 6 6 0"},
    {"DiagonalStepsCountAsOthers", field, "moveForwardHalf\nturnRight45\nmoveForwardHalf 4\n" TOTALS,
     "ack ack ack 5 4 1"},
    {"TurnsCountOneEach", field, "turnRight\nturnLeft45\nturnRight90\nturnRight45\n" TOTALS, "ack ack ack ack 0 0 4"},

    {"TurnsBeforeTheFirstMoveAreNotTheRuns", field, "turnRight\nmoveForward\nturnLeft\n" TOTALS "\n" CURRENT,
     "ack ack ack 2 2 2 2 2 1"},
    {"RunBeginsWithTheFirstMove", field, "moveForward 3\nturnRight\nmoveForward\n" CURRENT, "ack ack ack 8 6 1"},
    {"RunBeginsWithHalfAMove", field, "moveForwardHalf\nmoveForwardHalf\n" CURRENT, "ack ack 2 2 0"},
    {"RunBeginsWithAMoveThatCrashesLater", corner, "moveForward 9\nturnRight\n" CURRENT, "crash ack 18 10 1"},
    {"RunEndsAtTheStart", field, "moveForward\nturnRight\nturnRight\nmoveForward\nturnRight\nturnRight\n" CURRENT,
     "ack ack ack ack ack ack 4 4 2"},
    {"RunBeginsAnewAtTheStart", field,
     "moveForward\nturnRight\nturnRight\nmoveForward\nturnRight\nturnRight\nmoveForward 4\n" CURRENT,
     "ack ack ack ack ack ack ack 8 5 0"},
    {"RunGoesOnBesideTheStart", field, "moveForward\nturnRight\nturnRight\nmoveForwardHalf\nturnRight\n" CURRENT,
     "ack ack ack ack ack 3 3 3"},
    {"TotalsGoOnAtTheStart", field, "moveForward\nturnRight\nturnRight\nmoveForward\nturnRight\n" TOTALS,
     "ack ack ack ack ack 4 4 3"},

    {"GoalFinishesTheRun", corner, TO_GOAL BEST, "ack ack ack ack ack 8 7 2 9.9"},
    {"GoalIsTheCentreNotTheMark", corner,
     "moveForward 2\nturnRight\nmoveForward\nturnRight\nmoveForward\nackReset\ngetStat best-run-turns",
     "ack ack ack ack ack ack 2"},
    {"GoalThatIsMarkedIsNone", corner,
     "moveForward 2\nturnRight\nmoveForward\nturnRight\nmoveForward\nturnLeft\nmoveForward\nturnRight\n"
     "moveForward\ngetStat best-run-distance\ngetStat total-distance",
     "ack ack ack ack ack ack ack ack ack 8 12"},
    {"GoalBeginsAtItsSouthWall", field, "moveForward 6\nturnRight\nmoveForward 7\nturnLeft\nmoveForwardHalf\n" BEST,
     "ack ack ack ack ack 27 16 2 19.8"},
    {"GoalBeginsAtItsWestWall", field, "moveForward 7\nturnRight\nmoveForwardHalf 13\n" BEST,
     "ack ack ack 27 15.5 1 18.15"},
    {"GoalEndsBeforeItsEastWall", plank, "turnRight\nmoveForwardHalf 3\n" BEST, "ack ack -1 -1 -1 2000", "(4,1) east"},
    {"GoalIsNotReachedByDrivingThrough", plank, "turnRight\nmoveForward 2\n" BEST, "ack ack -1 -1 -1 2000"},
    {"GoalIsReachedByACrashInIt", corner, "moveForward 2\nturnRight\nmoveForward\nturnRight\nmoveForward 2\n" BEST,
     "ack ack ack ack crash 10 8 2 11"},
    {"GoalIsReachedOnADiagonal", corner,
     "moveForwardHalf 3\nturnRight45\nmoveForwardHalf\nturnRight\nmoveForwardHalf\nturnRight45\nmoveForwardHalf\n" BEST,
     "ack ack ack ack ack ack ack 6 5.5 3 9.35"},
    {"NothingIsBookedInTheRunAfterTheGoal", corner, TO_GOAL "turnLeft\nmoveForward\n" CURRENT,
     "ack ack ack ack ack ack ack 8 7 2"},
    {"TurningInTheGoalChangesNoBestRun", corner, TO_GOAL "turnLeft\nturnLeft45\n" BEST,
     "ack ack ack ack ack ack ack 8 7 2 10.1"},
    {"ScoreFollowsTheTotal", corner, TO_GOAL "getStat score\nturnLeft\ngetStat score\nmoveForward\ngetStat score",
     "ack ack ack ack ack 9.9 ack 10 ack 10.2"},
    {"ScoreIs2000UntilTheGoal", corner, "moveForward 2\nturnRight\nmoveForward\ngetStat score", "ack ack ack 2000"},
    {"ScoreStaysAfterACancelledRun", corner, TO_GOAL "ackReset\nmoveForward\ngetStat score\nackReset\ngetStat score",
     "ack ack ack ack ack ack ack 11.6 ack 11.6"},
    {"PenaltyCountsInTheRunAndInTheTotal", corner, "ackReset\n" TO_GOAL BEST "\n" TOTALS,
     "ack ack ack ack ack ack 8 22 2 26.4 8 22 2"},
    {"PenaltyOfARunThatIsNoBetterLeavesTheBest", corner, TO_GOAL "ackReset\n" TO_GOAL BEST,
     "ack ack ack ack ack ack ack ack ack ack ack 8 7 2 12.3"},
    {"ARunThatIsBetterIsTheBest", corner,
     "ackReset\n" TO_GOAL
     "turnRight\nturnRight\nmoveForward\nturnLeft\nmoveForward\nturnLeft\nmoveForward 2\nturnRight\nturnRight\n" TO_GOAL
         BEST,
     "ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack 8 7 2 13.6"},
    {"ARunThatIsNoBetterIsNot", corner,
     TO_GOAL "turnRight\nturnRight\nmoveForward\nturnLeft\nmoveForward\nturnLeft\nmoveForward 2\nturnRight\nturnRight\n"
             "moveForward\nmoveForward\nturnRight\nmoveForward\nturnRight\nmoveForwardHalf\nmoveForwardHalf\n" BEST,
     "ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack ack 8 7 2 12.2"},

    {"StartInTheGoalIsSolvedByATurn", box, "turnRight\n" BEST, "ack 0 0 0 0.1"},
    {"StartInTheGoalIsNotSolvedByACrash", box, "moveForward\n" BEST, "crash -1 -1 -1 2000"},
    {"StartInTheGoalIsNotSolvedByAReset", box, "ackReset\n" BEST, "ack -1 -1 -1 2000"},

    {"AMillionIsMinusOne", field,
     "moveForward 499999\ngetStat total-distance\nmoveForward 1\nmoveForwardHalf 2\ngetStat total-distance\n"
     "turnRight\nturnRight\nmoveForward\ngetStat total-distance\ngetStat current-run-distance\ngetStat "
     "total-effective-distance",
     "crash 999998 crash crash 999998 ack ack ack -1 -1 500002"},
    {"AMillionIsAnExponentInFractions", field,
     "moveForwardHalf 2000000\ngetStat total-effective-distance\ngetStat total-distance", "crash 1e+06 -1"},
    {"FractionsHaveSixDigits", field, "moveForwardHalf 246911\ngetStat total-effective-distance", "crash 123456"},
};
INSTANTIATE_TEST_SUITE_P(Protocol, MmsCount, testing::ValuesIn(counts), name_of_rule);

TEST(MmsStatisticReply, IsWhatCWouldPrint) {
  MmsStatistics statistics;
  for (const float value : {0.0F, 12.5F, 2000.0F, 265.2F, 0.1F, 26.4F, 9.35F, 1234.55F, 99999.95F, 123456.7F, 999999.4F,
                            999999.6F, 1e6F, 1234567.0F, 1e10F, 4e9F, 1e-5F, 3.0e38F}) {
    char printed[32];
    std::snprintf(printed, sizeof printed, "%g", static_cast<double>(value));
    statistics.score = value;
    EXPECT_EQ(statistic_reply(statistics, "score"), printed);
  }
}

TEST(MmsStatisticReply, HasTenNames) {
  EXPECT_EQ(statistic_names().size(), 10U);
  MmsStatistics statistics;
  statistics.total_distance = 1, statistics.total_effective_distance = 2, statistics.total_turns = 3;
  statistics.current_run_distance = 4, statistics.current_run_effective_distance = 5, statistics.current_run_turns = 6;
  statistics.best_run_distance = 7, statistics.best_run_effective_distance = 8, statistics.best_run_turns = 9;
  statistics.score = 10;
  std::string replies;
  for (const auto* name : {"total-distance", "total-effective-distance", "total-turns", "current-run-distance",
                           "current-run-effective-distance", "current-run-turns", "best-run-distance",
                           "best-run-effective-distance", "best-run-turns", "score"})
    replies += statistic_reply(statistics, name).value_or("none") + " ";
  EXPECT_EQ(replies, "1 2 3 4 5 6 7 8 9 10 ");
  EXPECT_EQ(statistic_reply(statistics, "scores"), std::nullopt);
  EXPECT_EQ(statistic_reply(statistics, ""), std::nullopt);
}

TEST(MmsLedger, SayWhetherARunIsOn) {
  MmsHost host(corner(), {});
  EXPECT_FALSE(host.ledger().in_run());
  told(host, "ackReset\n");
  EXPECT_EQ(host.ledger().pending_penalty(), 15);
  told(host, "moveForward 2\n");
  EXPECT_TRUE(host.ledger().in_run());
  EXPECT_EQ(host.ledger().pending_penalty(), 0);
  told(host, "turnRight\nmoveForward\nturnRight\nmoveForward\n");
  EXPECT_FALSE(host.ledger().in_run());
  EXPECT_TRUE(host.statistics().finished);
}

}  // namespace
}  // namespace labmouse::test
