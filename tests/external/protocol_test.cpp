#include "labmouse/external/protocol.hpp"

#include <gtest/gtest.h>

namespace labmouse {
namespace {

Briefing a_briefing() {
  Briefing briefing;
  briefing.size = {3, 2};
  briefing.start = {{1, 0}, Heading::east};
  briefing.goals.insert({2, 1});
  briefing.goals.insert({0, 1});
  briefing.motion = strides(3);
  briefing.budget = 50;
  briefing.seed = 12;
  return briefing;
}

TEST(LineProtocol, TellsTheBriefing) {
  EXPECT_EQ(briefing_text(a_briefing()),
            "labmouse 1\nsize 3 2\nstart 1 0 east\ngoal 0 1\ngoal 2 1\nstride 3\nbudget 50\nseed 12\nbegin\n");
}

TEST(LineProtocol, AsksWithTheReading) { EXPECT_EQ(question({0, 11, 3}), "sense 0 11 3\n"); }

TEST(LineProtocol, ReadsAnswers) {
  EXPECT_EQ(read_answer("move 0 3"), Action::step(0, 3));
  EXPECT_EQ(read_answer("move -90 -2"), Action::step(-90, -2));
  EXPECT_EQ(read_answer("move 90 0"), Action::step(90, 0));
  EXPECT_EQ(read_answer("move 45 7"), Action::step(45, 7)) << "the world deals with values it does not perform";
  EXPECT_EQ(read_answer("move 1000000 -1000000"), Action::step(1'000'000, -1'000'000));
  EXPECT_EQ(read_answer("reset"), Action::reset());
  EXPECT_EQ(read_answer("forfeit"), Action::forfeit(ForfeitReason::gave_up));
}

TEST(LineProtocol, ReadsNothingElse) {
  for (const char* line : {"",
                           " ",
                           "move",
                           "move ",
                           "move 0",
                           "move 0 ",
                           "move 0 1 ",
                           "move 0 1 2",
                           "move  0 1",
                           "move 0  1",
                           " move 0 1",
                           "Move 0 1",
                           "move0 1",
                           "move 0,1",
                           "move +0 1",
                           "move 0 1.0",
                           "move a b",
                           "move 0x1 1",
                           "move 1000001 0",
                           "move 0 -1000001",
                           "move 99999999999999999999 0",
                           "move\t0\t1",
                           "Reset",
                           "RESET",
                           "reset ",
                           " reset",
                           "reset now",
                           "forfeit: hung",
                           "quit",
                           "labmouse 1"})
    EXPECT_EQ(read_answer(line), std::nullopt) << line;
}

}  // namespace
}  // namespace labmouse
