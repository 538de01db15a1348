// What of a log becomes motion in ticks.
#include "labmouse/lab/logs/log_motion.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Hardware hardware_of(double count) {
  Hardware hardware;
  hardware.sensors.count = count;
  hardware.chassis.half_track = 20.0;
  hardware.motors.volts = 4.0;
  hardware.motors.sag = 0.1;
  return hardware;
}

LogMotion motion_in(std::string_view text, std::string_view columns, double count = 0.1) {
  const LogResult log = read_log(text, read_log_columns(columns, 0.0).columns);
  EXPECT_THAT(log.problems, IsEmpty());
  const LogMotionResult result = motion_of(log.log, hardware_of(count));
  EXPECT_EQ(result.error, "");
  return result.motion;
}

constexpr const char* all = "time=t,left=l,right=r,left_count=cl,right_count=cr,gyro=g";

TEST(LogMotion, GoesOnSteadilyBetweenRowsAndHoldsDuties) {
  const LogMotion motion = motion_in("t,l,r,cl,cr,g\n0,0.5,0.1,0,0,0\n4,0,0,40,80,2\n8,0,0,40,80,2\n", all);
  ASSERT_EQ(motion.ticks, 9U);
  EXPECT_NEAR(motion.way[2], 3.0, 1e-12);  // 30 counts in the mean
  EXPECT_NEAR(motion.way[8], 6.0, 1e-12);
  EXPECT_NEAR(motion.left[3], 0.5 * 0.97, 1e-12);  // the battery yields at 0.3 of full load
  EXPECT_EQ(motion.left[4], 0.0);
  EXPECT_NEAR(motion.angle[4], 0.001 * (0.5 + 1.0 + 1.5 + 2.0), 1e-12);
  EXPECT_TRUE(motion.by_gyro);
}

TEST(LogMotion, TakesTheBatteryAsItWas) {
  const LogMotion motion = motion_in("t,l,r,v\n0,0.5,0.5,3\n1,0,0,3\n2,0,0,4\n", "time=t,left=l,right=r,volts=v");
  EXPECT_NEAR(motion.left[0], 0.5 * 3.0 / 4.0, 1e-12);
  EXPECT_THAT(motion.way, IsEmpty());
}

TEST(LogMotion, TurnsByTheEncodersWithoutAGyro) {
  const LogMotion motion = motion_in("t,cl,cr\n0,0,0\n1,-20,20\n", "time=t,left_count=cl,right_count=cr");
  EXPECT_NEAR(motion.angle[1], 4.0 / 40.0, 1e-12);
  EXPECT_FALSE(motion.by_gyro);
}

TEST(LogMotion, KnowsRestsAndWhatTheGyroShowsThere) {
  std::string text = "t,l,r,cl,cr,g\n";
  for (int t = 0; t < 600; ++t) {
    const int moved = std::max(0, t - 300);
    text += fmt::format("{},{},{},{},{},{}\n", t, t < 300 ? 0.0 : 0.2, t < 300 ? 0.0 : 0.2, 2 * moved, 2 * moved,
                        0.02 + (moved > 0 ? 1.0 : 0.0));
  }
  const LogMotion motion = motion_in(text, all);
  ASSERT_THAT(motion.rests, SizeIs(1));
  EXPECT_GT(motion.rests[0].size(), 200U);
  EXPECT_LT(motion.rests[0].end, 300U);
  EXPECT_NEAR(motion.angle[290], 0.0, 1e-9);
  EXPECT_NEAR(motion.angle[599], 0.299, 0.002);
}

TEST(LogMotion, ACounterThatWrapsIsNoMotion) {
  const LogResult log =
      read_log("t,l,r\n0,65530,5\n1,2,9\n", read_log_columns("time=t,left_count=l,right_count=r", 0.0).columns);
  EXPECT_THAT(motion_of(log.log, hardware_of(0.1)).error, Says("left", "left_count=NAME%65536"));
}

}  // namespace
}  // namespace labmouse
