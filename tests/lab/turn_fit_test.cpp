// From turns back to limits.
#include "labmouse/lab/robots/turn_fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/fitted_robot.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::SaysAt;
using ::testing::ElementsAre;
using ::testing::SizeIs;

/// A table as its author published it (kerise-v4, 2021).
constexpr std::string_view published =
    "# turns of a half-size robot\n"
    "turn  speed    x        y    before\n"
    "S90   265.749  44       44   1\n"
    "45    411.636  72.426   30   2.574\n"
    "90    422.783  70       70   20\n"
    "135   353.609  33.137   80   21.863\n"
    "180   412.228  0        90   24\n"
    "V90   289.908  48       48   15.640\n"
    "K90   754.969  125      125  2.279\n";

TEST(TurnTable, IsReadByTheNamesOfItsColumns) {
  const TurnTable table = read_turn_table("turn,ms,speed\r\n\n45,257,-\r\n K90 286.038\t754.969\n");
  ASSERT_THAT(table.problems, SizeIs(0));
  ASSERT_THAT(table.turns, SizeIs(2));
  EXPECT_EQ(table.turns[0].turn, Turn::f45);
  EXPECT_EQ(table.turns[0].milliseconds, 257.0);
  EXPECT_EQ(table.turns[0].speed, 0.0);
  EXPECT_TRUE(table.turns[1].wide);
  EXPECT_EQ(table.turns[1].speed, 754.969);
}

TEST(TurnTable, SaysWhereItIsWrong) {
  const auto complaints = [](std::string_view text) {
    std::vector<std::string> all;
    for (const Problem& problem : read_turn_table(text).problems) all.push_back(describe("t", problem));
    return all;
  };
  EXPECT_THAT(complaints(""), ElementsAre(SaysAt("t", "empty")));
  EXPECT_THAT(complaints("turn ms\n"), ElementsAre(SaysAt("t", "no turns")));
  EXPECT_THAT(complaints("turn time\n"), ElementsAre(SaysAt("t:1:6", "'time'", "ms")));
  EXPECT_THAT(complaints("ms turn\n"), ElementsAre(SaysAt("t:1:1", "'turn'")));
  EXPECT_THAT(complaints("turn ms ms\n"), ElementsAre(SaysAt("t:1:9", "'ms'", "twice")));
  EXPECT_THAT(complaints("turn ms\n46 3\n"), ElementsAre(SaysAt("t:2:1", "'46'", "S90")));
  EXPECT_THAT(complaints("turn ms\n45 fast\n45 3 4\n"),
              ElementsAre(SaysAt("t:2:4", "'fast'", "number"), SaysAt("t:3:1", "3 columns")));
  for (const char* odd : {"1e-320", "1e-300", "0.0001", "1e309", "1e7", "-1", "0x10", "inf"})
    EXPECT_THAT(complaints(std::string("turn ms\n45 ") + odd + "\n"), ElementsAre(SaysAt("t:2:4", odd, "number")));
  EXPECT_THAT(complaints("turn speed\n45 300\n"), ElementsAre(SaysAt("t:2:1", "'ms'", "'y'")));
}

TEST(TurnFit, HasNothingToSayOfTurnsThatNoLimitsExplain) {
  // No table has such turns, but it must not fall over them.
  KnownTurn turn;
  turn.turn = Turn::s90;
  turn.speed = 1e-320;
  turn.aside = 44.0;
  EXPECT_EQ(fit_turns(std::vector{turn}, 90.0).numbers, 0);
  const FittedRobot fitted = fitted_robot({turn}, find_robot("kerise").robot, 90.0);
  EXPECT_EQ(fitted.text, "");
  EXPECT_NE(fitted.error, "");
}

TEST(TurnFit, FindsThePublishedLimitsOfPublishedTurns) {
  const TurnTable table = read_turn_table(published);
  ASSERT_THAT(table.problems, SizeIs(0));
  const TurnFit fit = fit_turns(table.turns, 90.0);
  EXPECT_NEAR(fit.limits.yaw_acceleration, 113.097, 0.5);
  EXPECT_NEAR(fit.limits.yaw_speed, 9.42478, 0.05);
  EXPECT_NEAR(fit.limits.yaw_jerk, 3769.91, 50.0);
  EXPECT_FALSE(fit.reaches_lateral);
  EXPECT_TRUE(fit.reaches_acceleration && fit.reaches_speed && fit.reaches_jerk);
  EXPECT_EQ(fit.figures, 7);
  for (const double error : fit.errors) EXPECT_LT(error, 5e-4);
}

TEST(TurnFit, FindsTheLimitsOfARobotInItsTimes) {
  const FoundRobot classic = find_robot("classic");
  std::vector<KnownTurn> turns;
  for (std::size_t i = 0; i < classic.model.shapes.size(); ++i) {
    const DrivenTurn& turn = classic.model.tables.turns[i];
    const bool repeats = !turns.empty() && turns.back().turn == turn.turn;  // the same path more slowly
    if (repeats || (begins_diagonal(turn.turn) && !ends_diagonal(turn.turn))) continue;
    const TurnShape& shape = classic.model.shapes[i];
    turns.push_back({turn.turn, false, turn.speed, shape.whole() / turn.speed * 1e3, 0.0, shape.lead_in});
  }
  ASSERT_THAT(turns, SizeIs(6));
  const TurnFit fit = fit_turns(turns, 180.0);
  EXPECT_NEAR(fit.limits.lateral_acceleration, 10'000.0, 50.0);
  EXPECT_NEAR(fit.limits.yaw_acceleration, 300.0, 1.5);
  EXPECT_EQ(fit.limits.yaw_speed, 0.0);
  EXPECT_EQ(fit.limits.yaw_jerk, 0.0);
  EXPECT_TRUE(fit.reaches_lateral && fit.reaches_acceleration);
}

TEST(TurnFit, KnowsNothingOfTurnsWithoutASpeed) {
  const TurnTable table = read_turn_table("turn ms\n45 257\n");
  EXPECT_EQ(fit_turns(table.turns, 90.0).figures, 0);
}

}  // namespace
}  // namespace labmouse
