#include "labmouse/lab/races/never_started.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/mms/mms_fixture.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A race of one external mouse with a contest for each of these, in which it started or did not.
Race race_of(const std::vector<bool>& contests) {
  Race race;
  race.mice.emplace_back().name = "program:mouse";
  for (const bool started : contests) {
    ContestResult& result = race.results.emplace_back();
    result.done = true;
    if (!started) result.never_started = "it ended with exit code 2";
  }
  return race;
}

TEST(NeverStarted, IsAExternalThatStartedInNoContest) {
  EXPECT_THAT(never_started_lines(race_of({false, false})), Says("program:mouse ", "start", "exit code 2\n"));
  EXPECT_EQ(never_started_lines(race_of({false, true})), "");
  EXPECT_EQ(never_started_lines(race_of({true})), "");
}

TEST(NeverStarted, CountsJustTheContestsThatWereHeld) {
  Race stopped = race_of({false, true});
  stopped.results.back().done = false;
  EXPECT_THAT(never_started_lines(stopped), Says("program:mouse ", "start"));
  stopped.results.front().done = false;
  EXPECT_EQ(never_started_lines(stopped), "");
}

TEST(NeverStarted, IsNoBuiltinMouse) {
  RaceOrder order;
  order.world = first_world();
  EXPECT_EQ(never_started_lines(hold_race(test::mice("flood"), {test::loop(), test::without_route()}, order)), "");
}

TEST(NeverStarted, IsAProgramForMmsWithoutALine) {
  RaceOrder order;
  order.world = default_world("mms");
  const Race race = hold_race({test::mms_mouse("mute", {"exit:2"}), test::mms_mouse("talker", {"ask:mazeWidth"}),
                               test::mms_mouse("idle", {"exit:0"})},
                              {test::plank(), test::loop()}, order);
  EXPECT_THAT(never_started_lines(race), AllOf(Says("mms:mute ", "start", "exit code 2\n"), Not(HasSubstr("idle"))));
}

}  // namespace
}  // namespace labmouse
