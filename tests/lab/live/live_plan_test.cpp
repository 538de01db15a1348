// The routes that a real robot knows and may hope for.
#include "labmouse/lab/live/live_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "labmouse/lab/robots/robot_files.hpp"

namespace labmouse {
namespace {

using testing::IsEmpty;
using testing::StartsWith;

/// Plans of a robot in a maze of 3x3 cells, whose goal is the cell in the centre.
class ALivePlanner : public testing::Test {
 protected:
  LivePlan after(const std::vector<std::string>& lines) const {
    LiveMap map(Size{3, 3});
    for (const std::string& line : lines) map.add(*read_live_line(line));
    return planner_.plan(map.map());
  }

  const DriveModel model_ = find_robot("classic").model;
  const LivePlanner planner_{model_};
};

TEST_F(ALivePlanner, HopesForOpenWallsAndTrustsSeenOnes) {
  const LivePlan begin = after({"0 0 N 101"});
  EXPECT_EQ(begin.known.time, no_time);
  EXPECT_LT(begin.hope, no_time);
  EXPECT_THAT(planner_.line_of(begin), IsEmpty());

  // A detour by the north is known; the wall between (0,1) and the goal was not seen.
  const LivePlan detour = after({"0 0 N 101", "0 1 N 10?", "0 2 E 100", "1 2 S 10?"});
  EXPECT_LT(detour.known.time, no_time);
  EXPECT_EQ(detour.hope, begin.hope);
  EXPECT_LT(detour.hope, detour.known.time);
  EXPECT_FALSE(detour.is_certain());
}

TEST_F(ALivePlanner, KnowsWhenNoUnseenWallCanHelp) {
  const LivePlan plan = after({"0 0 N 101", "0 1 N 110", "1 1 E 111"});
  EXPECT_TRUE(plan.is_certain());
  EXPECT_EQ(plan.known.time, plan.hope);
  const std::string line = planner_.line_of(plan);
  EXPECT_THAT(line, StartsWith("plan S1 RS90 S1 *"));
  unsigned sum = 0;
  for (const char letter : line.substr(0, line.find('*'))) sum ^= static_cast<unsigned char>(letter);
  EXPECT_EQ(std::stoul(line.substr(line.find('*') + 1), nullptr, 16), sum);
  EXPECT_EQ(line.back(), '\n');
}

TEST_F(ALivePlanner, SaysThatNoRouteIsPossible) {
  const LivePlan plan = after({"0 0 N 111"});
  EXPECT_EQ(plan.hope, no_time);
  EXPECT_THAT(planner_.line_of(plan), IsEmpty());
}

}  // namespace
}  // namespace labmouse
