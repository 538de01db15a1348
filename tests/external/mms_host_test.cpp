// Who hosts: the log, strictness, presses of Reset, the clock, events.
#include <gmock/gmock.h>

#include "tests/external/mms_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse::test {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A bad line, what becomes of it, and why.
struct Diagnosis {
  const char* line;
  const char* effect;
  const char* reason;
  const char* suggestion = nullptr;
};

void PrintTo(const Diagnosis& diagnosis, std::ostream* out) { *out << diagnosis.line; }

class MmsLog : public testing::TestWithParam<Diagnosis> {};

TEST_P(MmsLog, SaysWhatIsWrong) {
  const auto [line, effect, reason, suggestion] = GetParam();
  MmsHost host(field(), {});
  told(host, std::string(line) + "\n");
  const std::string begin = std::string("line 1: '") + line + "' ";
  ASSERT_THAT(host.log(), ElementsAre(StartsWith(begin)));
  const std::string sentence = host.log().front().substr(begin.size());
  EXPECT_THAT(sentence, Says(effect, reason));
  if (suggestion == nullptr)
    EXPECT_THAT(sentence, Not(HasSubstr("did you mean")));
  else
    EXPECT_THAT(sentence, EndsWith(std::string("did you mean ") + suggestion + "?"));
}

constexpr Diagnosis diagnoses[] = {
    {"", "no reply", "empty"},
    {"  ", "no reply", "empty"},
    {"turnRight 2", "no reply", "no argument"},
    {"ackReset x", "no reply", "no argument"},
    {"moveForward 1 2", "no reply", "one number"},
    {"wallLeft 1 2 3 4 5 6", "no reply", "one number"},
    {"getStat", "no reply", "name of a statistic"},
    {"getStat Score", "no reply", "no such statistic", "score"},
    {"getStat total-effective-distances", "no reply", "no such statistic", "total-effective-distance"},
    {"getStat time", "no reply", "no such statistic"},
    {"movForward", "no reply", "no such command", "moveForward"},
    {"MoveForward 2", "no reply", "no such command", "moveForward"},
    {"move_forward", "no reply", "no such command", "moveForward"},
    {"moveForwrad", "no reply", "no such command", "moveForward"},
    {"turnRigth", "no reply", "no such command", "turnRight"},
    {"turnleft", "no reply", "no such command", "turnLeft"},
    {"turnRight4", "no reply", "no such command", "turnRight"},
    {"wallfront", "no reply", "no such command", "wallFront"},
    {"hello", "no reply", "no such command"},
    {"clearAllColorX", "no reply", "no such command", "clearAllColor"},
    {"setWall 1 2 q", "ignored", "nesw"},
    {"setWall 1 2", "ignored", "takes X Y D"},
    {"setWall 1 b n", "ignored", "whole numbers"},
    {"setColor 1 2 red", "ignored", "kbacgorwyBCAGORVY"},
    {"setColor 1 2", "ignored", "takes X Y C"},
    {"clearColor 1", "ignored", "takes X Y"},
    {"clearText 1 2 3", "ignored", "takes X Y"},
    {"clearAllText 1", "ignored", "no argument"},
    {"setText 1", "ignored", "X Y TEXT"},
    {"setText  1 2 abc", "ignored", "X Y TEXT"},
    {"setText a 2 abc", "ignored", "whole numbers"},
};
INSTANTIATE_TEST_SUITE_P(Sentences, MmsLog, testing::ValuesIn(diagnoses));

TEST(MmsLog, CountsItsLines) {
  MmsHost host(field(), {});
  told(host, "mazeWidth\n\nmazeWidth\nhello\n");
  EXPECT_THAT(host.log(), ElementsAre(StartsWith("line 2: '' "), StartsWith("line 4: 'hello' ")));
}

TEST(MmsLog, KeepsTheFirstHundred) {
  MmsHost host(field(), {});
  for (int i = 0; i < 250; ++i) told(host, "hello\n");
  EXPECT_EQ(host.log().size(), 100U);
  EXPECT_EQ(host.invalid_lines(), 250);
}

TEST(MmsLog, ShowsNoControlsAndNoEndlessLines) {
  MmsHost host(field(), {});
  told(host, "\x1b[2J\x07\xC3\xA9 one\n" + std::string(3000, 'x') + "\n");
  EXPECT_THAT(host.log(), ElementsAre(StartsWith("line 1: '\\x1b[2J\\x07\\xc3\\xa9 one' "),
                                      StartsWith("line 2: '" + std::string(60, 'x') + "...' ")));
}

TEST(MmsStrict, EndsWithTheFirstBadLine) {
  MmsHost host(field(), {.strict = true});
  EXPECT_EQ(told(host, "mazeWidth\nsetColor 99 99 r\nmoveForward 0\n"), "16 crash");  // these are well-formed
  EXPECT_TRUE(host.goes_on());
  EXPECT_EQ(told(host, "turnRight 2\nmazeWidth\nmoveForward\n"), "");
  EXPECT_FALSE(host.goes_on());
  EXPECT_FALSE(host.waits());
  EXPECT_EQ(host.lines(), 4);
  EXPECT_EQ(words_of(host.pose()), "(1,1) north");
}

TEST(MmsStrict, MindsLinesThatWouldDraw) {
  MmsHost host(field(), {.strict = true});
  told(host, "setWall 0 0 N\n");
  EXPECT_FALSE(host.goes_on());
}

TEST(MmsStrict, IsNotTheDefault) {
  MmsHost host(field(), {});
  told(host, "nonsense\n");
  EXPECT_TRUE(host.goes_on());
}

std::string times(int count, std::string_view line) {
  std::string lines;
  for (int i = 0; i < count; ++i) lines += std::string(line) + "\n";
  return lines;
}

TEST(MmsPresses, EndTheRunOfWhoWaitsForNone) {
  MmsHost host(field(), {});
  EXPECT_EQ(told(host, times(99, "wasReset")).size(), 99 * 6 - 1U);
  EXPECT_TRUE(host.goes_on());
  EXPECT_FALSE(host.waits());
  EXPECT_EQ(told(host, "wasReset\n"), "false");
  EXPECT_FALSE(host.goes_on());
  EXPECT_TRUE(host.waits());
  EXPECT_EQ(told(host, "mazeWidth\n"), "");
}

TEST(MmsPresses, ComeAfterAHundredQuestions) {
  MmsHost host(field(), {.presses = 2});
  for (int press = 0; press < 2; ++press) {
    EXPECT_EQ(told(host, times(99, "wasReset") + "mazeWidth\n").find("true"), std::string::npos);
    const std::string replies = told(host, times(100, "wasReset"));
    EXPECT_EQ(replies.find("true"), std::string::npos);
    EXPECT_TRUE(host.goes_on());
    EXPECT_EQ(told(host, "wasReset\nwasReset\nackReset\nwasReset\n"), "true true ack false");
    told(host, "mazeWidth\n");
  }
  told(host, times(100, "wasReset"));
  EXPECT_TRUE(host.waits());
}

TEST(MmsPresses, NeedQuestionsWithNothingBetween) {
  for (const auto* between : {"wallFront", "setColor 0 0 r", "hello", "", "ackReset"}) {
    MmsHost host(field(), {});
    told(host, times(99, "wasReset") + between + "\n" + times(99, "wasReset"));
    EXPECT_FALSE(host.waits()) << between;
  }
}

TEST(MmsPresses, QuestionsThatAreAnsweredYesAreNoWaiting) {
  MmsHost host(field(), {});
  host.press_reset();
  told(host, times(500, "wasReset"));
  EXPECT_TRUE(host.goes_on());
}

TEST(MmsPresses, FromOutsideEndTheWaiting) {
  MmsHost host(field(), {});
  told(host, times(100, "wasReset"));
  host.press_reset();
  EXPECT_TRUE(host.goes_on());
  EXPECT_EQ(told(host, "wasReset\n"), "true");
}

TEST(MmsClock, CountsWorkAtTheDefaultSpeed) {
  const auto seconds = [](const char* lines) {
    MmsHost host(field(), {});
    told(host, lines);
    return host.clock();
  };
  EXPECT_EQ(seconds("mazeWidth\nwallFront\nsetColor 0 0 r\nackReset\nhello\n"), 0);
  EXPECT_NEAR(seconds("moveForward\n"), 100 / 253.0706, 1e-6);
  EXPECT_NEAR(seconds("moveForwardHalf\n"), 50 / 253.0706, 1e-6);
  EXPECT_NEAR(seconds("turnRight\n"), 33.33 / 253.0706, 1e-6);
  EXPECT_NEAR(seconds("turnLeft90\n"), 33.33 / 253.0706, 1e-6);
  EXPECT_NEAR(seconds("turnLeft45\n"), 16.66 / 253.0706, 1e-6);
  EXPECT_NEAR(seconds("moveForwardHalf\nturnRight45\nmoveForwardHalf 2\n"), (50 + 16.66 + 2 * 70.71) / 253.0706, 1e-6);
  EXPECT_NEAR(seconds("moveForward 40\n"), 30 * 50 / 253.0706, 1e-6);  // the way that it went
  EXPECT_EQ(seconds("moveForward 0\nturnLeft 1\n"), 0);
}

TEST(MmsEvents, AreLinesThatChangedSomething) {
  MmsHost host(plank(), {});
  std::vector<std::string> events;
  host.on_event([&](const MmsEvent& event) {
    events.push_back(std::string(event.line) + " > " + std::string(event.reply) + " " + words_of(event.pose));
    EXPECT_EQ(event.clock, host.clock());
  });
  told(
      host,
      "mazeWidth\nmoveForward\nwallFront\nmoveForward\nturnRight45\nmoveForwardHalf -1\nsetWall 0 0 n\nsetColor 9 9 r\n"
      "hello\nsetText 0 0 x\nclearAllColor\nclearAllText\nwasReset\ngetStat score\nturnRight45\nmoveForward "
      "9\nackReset\n");
  EXPECT_THAT(events, ElementsAre("moveForward > ack (1,3) north", "turnRight45 > ack (1,3) north-east",
                                  "setWall 0 0 n >  (1,3) north-east", "setText 0 0 x >  (1,3) north-east",
                                  "clearAllColor >  (1,3) north-east", "clearAllText >  (1,3) north-east",
                                  "turnRight45 > ack (1,3) east", "moveForward 9 > crash (5,3) east",
                                  "ackReset > ack (1,1) north"));
}

TEST(MmsHost, IsAValue) {
  MmsHost host(field(), {});
  told(host, "moveForward\n");
  MmsHost other = host;
  told(other, "moveForward\n");
  EXPECT_EQ(words_of(host.pose()), "(1,3) north");
  EXPECT_EQ(words_of(other.pose()), "(1,5) north");
}

}  // namespace
}  // namespace labmouse::test
