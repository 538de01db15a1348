// Ways driven with even acceleration, against the school's formulas.
#include "labmouse/controller/ramps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace labmouse {
namespace {

/// Sums its speed up over a fine grid, and looks at its limits on the way.
double driven(const Ramps& ramps, const RampLimits& limits) {
  constexpr int steps = 20'000;
  const double step = ramps.seconds() / steps;
  double length = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double from = ramps.speed_at(i * step), to = ramps.speed_at((i + 1) * step);
    EXPECT_LE(to, limits.speed * (1.0 + 1e-9));
    EXPECT_LE((to - from) / step, limits.acceleration * (1.0 + 1e-6));
    EXPECT_GE((to - from) / step, -limits.braking * (1.0 + 1e-6));
    length += (from + to) / 2.0 * step;
    EXPECT_NEAR(ramps.length_at((i + 1) * step), length, 1e-3);
  }
  return length;
}

struct Case {
  double length, from, to;
};

TEST(Ramps, DriveTheirLengthFromOneSpeedToTheOtherWithinTheLimits) {
  const RampLimits limits{800.0, 3000.0, 5000.0};
  for (const Case& it :
       {Case{500.0, 0.0, 0.0}, Case{500.0, 300.0, 200.0}, Case{50.0, 300.0, 300.0}, Case{30.0, 0.0, 300.0},
        Case{20.0, 400.0, 0.0}, Case{16.0, 400.0, 0.0}, Case{90.0, 800.0, 800.0}}) {
    const Ramps ramps(it.length, it.from, it.to, limits);
    EXPECT_EQ(ramps.speed_at(0.0), it.from);
    EXPECT_NEAR(ramps.speed_at(ramps.seconds()), it.to, 1e-9) << it.length;
    EXPECT_NEAR(ramps.length_at(ramps.seconds()), it.length, 1e-9) << it.length;
    EXPECT_NEAR(driven(ramps, limits), it.length, 1e-3);
  }
}

TEST(Ramps, AreAsFastAsTheLimitsAllow) {
  // 0.2 s up to 600 mm/s over 60 mm, 0.12 s down over 36, and the rest of 204 mm at 600.
  const Ramps ramps(300.0, 0.0, 0.0, {600.0, 3000.0, 5000.0});
  EXPECT_NEAR(ramps.seconds(), 0.2 + 0.34 + 0.12, 1e-12);
  // A way too short for that: up over 5/8 of it.
  const Ramps little(80.0, 0.0, 0.0, {600.0, 3000.0, 5000.0});
  const double top = std::sqrt(2.0 * 3000.0 * 50.0);
  EXPECT_NEAR(little.seconds(), top / 3000.0 + top / 5000.0, 1e-12);
}

TEST(Ramps, EndAtTheSpeedThatIsReachedWhereTheLimitsAllowNoMore) {
  const Ramps slow(10.0, 0.0, 900.0, {2000.0, 3000.0, 5000.0});
  EXPECT_NEAR(slow.speed_at(slow.seconds()), std::sqrt(2.0 * 3000.0 * 10.0), 1e-9);
  const Ramps fast(10.0, 900.0, 0.0, {2000.0, 3000.0, 5000.0});
  EXPECT_NEAR(fast.speed_at(fast.seconds()), std::sqrt(900.0 * 900.0 - 2.0 * 5000.0 * 10.0), 1e-9);
}

TEST(Ramps, AtOneSpeedTakeTheirLengthOverIt) {
  const Ramps ramps(90.0, 300.0);
  EXPECT_DOUBLE_EQ(ramps.seconds(), 0.3);
  EXPECT_DOUBLE_EQ(ramps.length_at(0.1), 30.0);
  EXPECT_EQ(ramps.speed_at(0.0), 300.0);
  EXPECT_EQ(ramps.speed_at(0.3), 300.0);
}

TEST(Ramps, OfNoLengthTakeNoTime) {
  EXPECT_EQ(Ramps(0.0, 0.0, 0.0, {600.0, 3000.0, 5000.0}).seconds(), 0.0);
  EXPECT_EQ(Ramps().seconds(), 0.0);
}

}  // namespace
}  // namespace labmouse
