// The loop that a program for mms is in, found from its last commands.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/external/mms/loop.hpp"
#include "tests/external/mms_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::ElementsAre;

/// A program in the field that wrote these lines.
struct Written {
  MmsHost host{test::field(), {.most_seconds = 1'000'000}};
  MmsTrail trail;

  void write(std::string_view line) {
    std::string replies;
    host.obey(line, replies);
    if (!replies.empty()) trail.add(line, host.lines(), host.pose());
  }
  void write(std::initializer_list<std::string_view> lines, int times = 1) {
    for (; times > 0; --times)
      for (const std::string_view line : lines) write(line);
  }
  std::optional<MmsLoop> loop() const { return trail.loop(host.lines()); }
  std::string text() const { return loop_text(trail, host.lines()); }
};

TEST(MmsTrail, FindsWhatIsRepeatedAndWhereItBegins) {
  Written program;
  program.write({"mazeWidth", "turnRight", "moveForward 3"});
  program.write({"moveForward", "turnRight", "turnRight"}, 12);
  const auto loop = program.loop();
  ASSERT_TRUE(loop);
  EXPECT_EQ(loop->first_line, 4);
  EXPECT_FALSE(loop->began_earlier);
  // Two of the program's own rounds: after one the mouse is elsewhere.
  EXPECT_THAT(loop->commands,
              ElementsAre("moveForward", "turnRight", "turnRight", "moveForward", "turnRight", "turnRight"));
  EXPECT_THAT(loop->cells, ElementsAre(Cell(4, 0), Cell(3, 0)));
  EXPECT_THAT(program.text(), Says("from line 4 on", "same 6 commands", "(4,0) (3,0)"));
}

TEST(MmsTrail, FindsALoopThatBreaksOffInTheMiddleOfARound) {
  Written program;
  program.write({"moveForward", "turnRight", "wallFront", "turnLeft"}, 1);
  program.write({"wallLeft", "wallRight", "wallBack"}, 20);
  program.write("wallLeft");
  ASSERT_TRUE(program.loop());
  EXPECT_EQ(program.loop()->first_line, 5);
  EXPECT_THAT(program.loop()->commands, ElementsAre("wallLeft", "wallRight", "wallBack"));
  EXPECT_THAT(program.text(), Says("(0,1)", "'wallLeft', 'wallRight', 'wallBack'"));
}

TEST(MmsTrail, WhatIsDrawnMayDifferFromRoundToRound) {
  Written program;
  for (int round = 0; round < 40; ++round) {
    program.write("setText 0 0 " + std::to_string(round));
    program.write("turnLeft");
  }
  ASSERT_TRUE(program.loop());
  EXPECT_EQ(program.loop()->commands.size(), 4U);
  EXPECT_EQ(program.loop()->first_line, 2);
}

TEST(MmsTrail, FindsNoneWhereTheMouseGoesElsewhereOrThreeRoundsAreNotOver) {
  Written program;
  EXPECT_FALSE(program.loop());
  program.write({"wallFront", "moveForwardHalf"}, 30);
  EXPECT_FALSE(program.loop());
  program.write({"wallFront"}, 31);
  EXPECT_FALSE(program.loop());
  EXPECT_THAT(program.text(), Says("no loop", "91 commands"));
  program.write("wallFront");
  EXPECT_TRUE(program.loop());
}

TEST(MmsTrail, FindsNoneWhereTheProgramLeftItForLinesWithoutAReply) {
  Written program;
  program.write({"turnLeft"}, 100);
  EXPECT_TRUE(program.loop());
  program.write({"setColor 0 0 G"}, 2);
  EXPECT_FALSE(program.loop());
}

TEST(MmsTrail, KeepsTheLastCommandsAndSaysThatALoopMayBeOlder) {
  Written program;
  program.write({"moveForward"}, 3);
  program.write({"turnLeft"}, static_cast<int>(MmsTrail::most) + 10);
  EXPECT_EQ(program.trail.size(), MmsTrail::most);
  ASSERT_TRUE(program.loop());
  EXPECT_TRUE(program.loop()->began_earlier);
  EXPECT_EQ(program.loop()->first_line, 14);
  EXPECT_THAT(program.text(), Says("line 14", "latest"));
}

}  // namespace
}  // namespace labmouse
