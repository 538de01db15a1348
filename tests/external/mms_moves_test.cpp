// Moves, turns, and being put back.
#include "tests/external/mms_fixture.hpp"

namespace labmouse::test {
namespace {

class MmsMoves : public testing::TestWithParam<Rule> {};
TEST_P(MmsMoves, Go) { expect(GetParam()); }

constexpr Rule moves[] = {
    {"OneCell", field, "moveForward", "ack", "(1,3) north"},
    {"SeveralCells", field, "moveForward 15", "ack", "(1,31) north"},
    {"HalfACell", field, "moveForwardHalf", "ack", "(1,2) north"},
    {"SeveralHalfCells", field, "moveForwardHalf 5", "ack", "(1,6) north"},
    {"OfACellAreTwoHalfSteps", field, "moveForward\ngetStat total-distance", "ack 2", "(1,3) north"},
    {"FromAWallGoOnInHalves", field, "moveForwardHalf\nmoveForward", "ack ack", "(1,4) north"},
    {"ToTheEast", field, "turnRight\nmoveForward 2", "ack ack", "(5,1) east"},
    {"OfZeroCrash", field, "moveForward 0\nmoveForwardHalf 0", "crash crash", "(1,1) north"},
    {"OfLessThanZeroCrash", field, "moveForward 3\nmoveForward -1\nmoveForwardHalf -1", "ack crash crash",
     "(1,7) north"},
    {"OfLessThanOneCountNothing", field,
     "moveForward 0\nmoveForward -3\ngetStat total-distance\ngetStat total-effective-distance", "crash crash 0 0"},
    {"IntoAWallCrashAtOnce", corner, "turnRight\nmoveForward\nmoveForwardHalf", "ack crash crash", "(1,1) east"},
    {"IntoAWallCountNothing", corner, "turnRight\nmoveForward 4\ngetStat total-distance\ngetStat current-run-distance",
     "ack crash 0 0"},
    {"IntoAWallAtOnceBeginNoRun", corner, "ackReset\nturnRight\nmoveForward\ngetStat current-run-effective-distance",
     "ack ack crash 0"},
    {"GoAsFarAsTheWayIsFree", field, "moveForward 40", "crash", "(1,31) north"},
    {"ThatCrashCountWhatWasAskedFor", field, "moveForward 40\ngetStat total-distance\ngetStat total-effective-distance",
     "crash 80 41"},
    {"InHalvesThatCrashCountWhatWasAskedFor", corner,
     "moveForwardHalf 9\ngetStat total-distance\ngetStat total-effective-distance", "crash 9 5.5", "(1,5) north"},
    {"ThatEndAtTheWallDoNotCrash", corner, "moveForward 2", "ack", "(1,5) north"},
    {"StopAtTheCentreBeforeAWall", corner, "moveForwardHalf 5", "crash", "(1,5) north"},
    {"AreGoodAgainAfterACrash", corner, "moveForward 9\nturnRight\nmoveForward\nwallFront", "crash ack ack true",
     "(3,5) east"},
    {"AfterACrashCountNoPenalty", field, "moveForward 40\nturnRight\nmoveForward\ngetStat total-effective-distance",
     "crash ack ack 43"},
    {"OnADiagonalGoFromWallToWall", field, "moveForwardHalf\nturnRight45\nmoveForwardHalf", "ack ack ack",
     "(2,3) north-east"},
    {"OnADiagonalByCellsAreTwoHalfSteps", field, "moveForwardHalf\nturnRight45\nmoveForward 2", "ack ack ack",
     "(5,6) north-east"},
    {"OnADiagonalStopBeforeAWall", field, "moveForwardHalf\nturnRight45\nmoveForwardHalf 99", "ack ack crash",
     "(30,31) north-east"},
    {"OnADiagonalCrashIntoAWallAtOnce", corner, "moveForwardHalf\nturnRight45\nmoveForwardHalf", "ack ack crash",
     "(1,2) north-east"},
    {"OnADiagonalFromACentreCrash", field, "turnRight45\nmoveForward\nmoveForwardHalf", "ack crash crash",
     "(1,1) north-east"},
    {"AlongAWallCrash", field, "moveForwardHalf\nturnRight\nmoveForwardHalf", "ack ack crash", "(1,2) east"},
    {"OnDiagonalsWeave", field,
     "moveForwardHalf\nturnRight45\nmoveForwardHalf\nturnRight90\nmoveForwardHalf\nturnLeft90\nmoveForwardHalf 2",
     "ack ack ack ack ack ack ack", "(5,4) north-east"},
    {"OnDiagonalsGoSouthWestAndNorthWest", field,
     "moveForward 3\nmoveForwardHalf\nturnRight45\nmoveForwardHalf 3\nturnRight90\nturnRight90\nmoveForwardHalf "
     "2\nturnRight90\n"
     "moveForwardHalf",
     "ack ack ack ack ack ack ack ack ack", "(1,10) north-west"},
};
INSTANTIATE_TEST_SUITE_P(Protocol, MmsMoves, testing::ValuesIn(moves), name_of_rule);

class MmsTurns : public testing::TestWithParam<Rule> {};
TEST_P(MmsTurns, Turn) { expect(GetParam()); }

constexpr Rule turns[] = {
    {"Right", field, "turnRight", "ack", "(1,1) east"},
    {"Left", field, "turnLeft", "ack", "(1,1) west"},
    {"Right90", field, "turnRight90", "ack", "(1,1) east"},
    {"Left90", field, "turnLeft90", "ack", "(1,1) west"},
    {"Right45", field, "turnRight45", "ack", "(1,1) north-east"},
    {"Left45", field, "turnLeft45", "ack", "(1,1) north-west"},
    {"AllTheWayRound", field, "turnRight45\nturnRight\nturnRight45\nturnRight\nturnRight90", "ack ack ack ack ack",
     "(1,1) north"},
    {"OnWalls", field, "moveForwardHalf\nturnLeft45\nturnLeft", "ack ack ack", "(1,2) south-west"},
    {"InABox", box, "turnRight45\nturnLeft", "ack ack", "(1,1) north-west"},
};
INSTANTIATE_TEST_SUITE_P(Protocol, MmsTurns, testing::ValuesIn(turns), name_of_rule);

class MmsReset : public testing::TestWithParam<Rule> {};
TEST_P(MmsReset, IsAnswered) { expect(GetParam()); }

constexpr Rule resets[] = {
    {"WasNotPressed", field, "wasReset", "false"},
    {"MayBeAcknowledgedUnpressed", field, "ackReset\nwasReset", "ack false"},
    {"PutsTheMouseBack", field, "moveForward 3\nturnRight45\nackReset", "ack ack ack", "(1,1) north"},
    {"CostsFifteenInTheNextRun", field, "moveForward\nackReset\nmoveForward\ngetStat current-run-effective-distance",
     "ack ack ack 17"},
    {"CostsFifteenInTheTotal", field, "moveForward\nackReset\nmoveForward\ngetStat total-effective-distance",
     "ack ack ack 19"},
    {"CostsNoDistance", field, "ackReset\nmoveForward\ngetStat total-distance\ngetStat current-run-distance",
     "ack ack 2 2"},
    {"CostsNothingBeforeTheNextRun", field, "ackReset\nturnRight\ngetStat total-effective-distance", "ack ack 0"},
    {"CostsAtTheStartToo", field, "ackReset\nmoveForward\ngetStat total-effective-distance", "ack ack 17"},
    {"TwiceInARowCostsOnce", field, "ackReset\nackReset\nmoveForward\ngetStat total-effective-distance",
     "ack ack ack 17"},
    {"CostsOnlyTheNextRun", corner,
     "ackReset\nmoveForward\nturnRight\nturnRight\nmoveForward\nturnRight\nturnRight\nmoveForward\n"
     "getStat current-run-effective-distance\ngetStat total-effective-distance",
     "ack ack ack ack ack ack ack ack 2 21"},
    {"CancelsTheRun", field, "moveForward\nackReset\nturnRight\ngetStat current-run-turns\ngetStat total-turns",
     "ack ack ack 0 1"},
    {"LeavesTheCancelledRunToBeRead", field, "moveForward 2\nackReset\ngetStat current-run-distance", "ack ack 4"},
};
INSTANTIATE_TEST_SUITE_P(Protocol, MmsReset, testing::ValuesIn(resets), name_of_rule);

TEST(MmsReset, IsTrueFromThePressToTheAcknowledgement) {
  MmsHost host(field(), {});
  told(host, "moveForward\n");
  host.press_reset();
  EXPECT_EQ(told(host, "wasReset\nmoveForward\nwasReset\nackReset\nwasReset\n"), "true ack true ack false");
  EXPECT_EQ(words_of(host.pose()), "(1,1) north");
}

TEST(MmsReset, KeepsTheDrawing) {
  MmsHost host(field(), {});
  told(host, "setWall 0 0 n\nsetColor 1 1 r\nsetText 2 2 abc\n");
  const MmsCanvas before = host.canvas();
  told(host, "ackReset\n");
  EXPECT_EQ(host.canvas(), before);
}

}  // namespace
}  // namespace labmouse::test
