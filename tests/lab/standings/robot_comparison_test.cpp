#include "labmouse/lab/standings/robot_comparison.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/finish_curves/finish_curves.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

std::vector<Race> races(std::string_view world, const WorldSettings& settings) {
  const EntriesResult entered = enter(test::mice("flood,certify"), world, settings);
  EXPECT_EQ(entered.error, "");
  std::vector<Race> all;
  for (const Entry& entry : entered.entries) {
    RaceOrder order;
    order.world = entry.world;
    order.runs = 2;
    all.push_back(hold_race(entry.mice, {test::loop(), test::corridor()}, order));
  }
  return all;
}

double mean_of(const Race& race, std::size_t mouse) {
  for (const Standing& standing : standings_of(race))
    if (standing.mouse == mouse) return standing.mean_at_limit.value();
  return 0.0;
}

TEST(RobotComparison, SubtractsTheFirstRobotFromEachOther) {
  const std::vector<Race> all = races("seconds", {{"robot", "classic,half,mm2021"}});
  ASSERT_THAT(all, SizeIs(3));
  const std::string text = compare_robots(all);
  for (std::size_t mouse : {0U, 1U}) {
    EXPECT_THAT(text, Says(all[0].mice[mouse].name, "classic", fmt::format("{:.3f}", mean_of(all[0], mouse))));
    for (std::size_t robot : {1U, 2U}) {
      const double mean = mean_of(all[robot], mouse), difference = mean - mean_of(all[0], mouse);
      EXPECT_NE(difference, 0.0);
      EXPECT_THAT(text, Says(fmt::format(" {:.3f} ", mean), fmt::format(" {:+.3f} ", difference)));
    }
  }
  EXPECT_THAT(text, Says("too few mazes", "4 comparisons"));
}

TEST(RobotComparison, ComparesOnlyRacesThatDifferInTheRobotAlone) {
  EXPECT_THAT(compare_robots(races("seconds", {{"robot", "classic"}})), IsEmpty());
  EXPECT_THAT(compare_robots(races("failures", {{"variation", "0,1"}})), IsEmpty());
  EXPECT_THAT(compare_robots(races("steps", {})), IsEmpty());
  const std::vector<Race> all = races("physical", {{"robot", "kerise,classic"}, {"noise", "0,1"}});
  ASSERT_THAT(all, SizeIs(4));
  const std::string text = compare_robots(all);
  EXPECT_THAT(text, Says("noise 0", "noise 1"));
  for (const Race& race : all)
    for (std::size_t mouse : {0U, 1U}) EXPECT_THAT(text, HasSubstr(fmt::format(" {:.3f}", mean_of(race, mouse))));
  EXPECT_THAT(text, HasSubstr(fmt::format(" {:+.3f} ", mean_of(all[3], 0) - mean_of(all[1], 0))));
}

TEST(FinishCurves, AreOfOneRobot) {
  const std::vector<Race> all = races("physical", {{"robot", "kerise,classic"}, {"noise", "0,1"}});
  EXPECT_THAT(finish_curves(all).curves, IsEmpty());
  EXPECT_THAT(finish_curves(std::span(all).first(2)).curves, Not(IsEmpty()));
}

}  // namespace
}  // namespace labmouse
