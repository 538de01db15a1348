// Bytes, lines, words and numbers.
#include "tests/external/mms_fixture.hpp"

namespace labmouse::test {
namespace {

class MmsLines : public testing::TestWithParam<Rule> {};
TEST_P(MmsLines, AreRead) { expect(GetParam()); }

constexpr Rule lines[] = {
    {"EachEndsWithALineFeed", field, "turnRight\nwallFront\nmazeWidth", "ack false 16"},
    {"CarriageReturnsAreDropped", field, "mazeWidth\r\nmaze\rHeight\r", "16 16"},
    {"ManyInOneReadKeepTheirOrder", corner,
     "wallRight\nmoveForward\nwallLeft\nmoveForward 2\ngetStat total-distance\nmazeWidth", "true ack true crash 6 3"},
    {"BlanksInFrontAndBehindDoNotCount", field, " wallFront ", "false"},
    {"BlanksInBetweenDoNotCount", field, "moveForward   2", "ack", "(1,5) north"},
    {"TabsDoNotSeparate", field, "moveForward\t2", "", "(1,1) north"},
    {"ATabInFrontMakesAnotherName", field, "\tmazeWidth", ""},
    {"AnEmptyOneHasNoReply", field, "", ""},
    {"OneOfBlanksHasNoReply", field, "   ", ""},
    {"AnUnknownNameHasNoReply", field, "hello", ""},
    {"NamesMindTheirCase", field, "mazewidth\nMazeWidth\nMAZEWIDTH", ""},
    {"ANameThatOnlyBeginsLikeACommandHasNoReply", field, "moveForwards\nturnRight180\nwallFrontLeftRight\nwasResets",
     ""},
    {"HalfANameHasNoReply", field, "move\nwall\nturn\nmaze", ""},
    {"TheWordInvalidIsNeverSent", field, "invalid\nnonsense\nmazeWidth", "16"},
    {"TheNextOneIsReadAsIfNothingWere", field, "nonsense\nmazeWidth", "16"},
    {"TurnRightTakesNoArgument", field, "turnRight 2", "", "(1,1) north"},
    {"TurnLeft45TakesNoArgument", field, "turnLeft45 1", "", "(1,1) north"},
    {"MazeWidthTakesNoArgument", field, "mazeWidth 3", ""},
    {"MazeHeightTakesNoArgument", field, "mazeHeight 3", ""},
    {"WasResetTakesNoArgument", field, "wasReset 1", ""},
    {"AckResetTakesNoArgument", field, "moveForward\nackReset x", "ack", "(1,3) north"},
    {"MoveForwardTakesOneArgument", field, "moveForward 1 1", "", "(1,1) north"},
    {"MoveForwardHalfTakesOneArgument", field, "moveForwardHalf 1 1", "", "(1,1) north"},
    {"WallFrontTakesOneArgument", field, "wallFront 1 1", ""},
    {"ManyWordsAreTooMany", field, "wallFront 1 2 3 4 5 6 7 8 9", ""},
    {"GetStatTakesAName", field, "getStat", ""},
    {"GetStatTakesOneName", field, "getStat score score", ""},
    {"GetStatKnowsItsNames", field, "getStat Score\ngetStat distance\ngetStat total_distance", ""},
};
INSTANTIATE_TEST_SUITE_P(Protocol, MmsLines, testing::ValuesIn(lines), name_of_rule);

class MmsNumbers : public testing::TestWithParam<Rule> {};
TEST_P(MmsNumbers, AreRead) { expect(GetParam()); }

constexpr Rule numbers[] = {
    {"MayHaveAPlus", field, "moveForward +2", "ack", "(1,5) north"},
    {"MayHaveZerosInFront", field, "moveForward 002", "ack", "(1,5) north"},
    {"MayHaveTabsRoundThem", field, "moveForward \t2\t", "ack", "(1,5) north"},
    {"AWordIsZero", field, "moveForward abc", "crash", "(1,1) north"},
    {"ADecimalPointIsZero", field, "moveForward 1.5", "crash", "(1,1) north"},
    {"AnExponentIsZero", field, "moveForward 1e0", "crash", "(1,1) north"},
    {"HexadecimalIsZero", field, "moveForward 0x2", "crash", "(1,1) north"},
    {"LettersBehindMakeItZero", field, "moveForward 2x", "crash", "(1,1) north"},
    {"TwoSignsAreZero", field, "moveForward +-2\nmoveForward ++2\nmoveForward --2", "crash crash crash", "(1,1) north"},
    {"ASignAloneIsZero", field, "moveForward +\nmoveForward -", "crash crash", "(1,1) north"},
    {"ATabAloneIsZero", field, "moveForward \t", "crash", "(1,1) north"},
    {"TheLargestOf32BitsIsOne", field, "moveForwardHalf 2147483647", "crash", "(1,31) north"},
    {"TwiceTheLargestIsStillALongWay", field, "moveForward 2147483647", "crash", "(1,31) north"},
    {"OneMoreIsZero", field, "moveForwardHalf 2147483648", "crash", "(1,1) north"},
    {"TheLeastOf32BitsIsLessThanOne", field, "moveForwardHalf -2147483648", "crash", "(1,1) north"},
    {"TwentyDigitsAreZero", field, "moveForward 99999999999999999999", "crash", "(1,1) north"},
};
INSTANTIATE_TEST_SUITE_P(Protocol, MmsNumbers, testing::ValuesIn(numbers), name_of_rule);

TEST(MmsLine, IsKeptUntilItsEndComes) {
  MmsHost host(field(), {});
  EXPECT_EQ(told(host, "mazeWidth\nmazeHei"), "16");  // and dropped where the end never comes
  LineBuffer buffer(100);
  std::string replies;
  for (const char letter : std::string_view("mazeWidth\n")) {
    buffer.append({&letter, 1});
    if (const auto line = buffer.next()) host.obey(*line, replies);
  }
  EXPECT_EQ(replies, "16\n");
}

TEST(MmsLine, CountsWhetherItIsAnsweredOrNot) {
  MmsHost host(field(), {});
  told(host, "mazeWidth\nsetColor 0 0 r\nnonsense\n\n");
  EXPECT_EQ(host.lines(), 4);
  EXPECT_EQ(host.invalid_lines(), 2);
}

TEST(MmsReplies, AreAppended) {
  MmsHost host(field(), {});
  std::string replies = "before\n";
  host.obey("mazeWidth", replies);
  EXPECT_EQ(replies, "before\n16\n");
}

}  // namespace
}  // namespace labmouse::test
