// Directions and sines of our own against those of the standard library.
#include "labmouse/functions/angles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "labmouse/functions/whole.hpp"

namespace labmouse {
namespace {

TEST(Angles, AreThoseOfTheStandardLibraryButForTheLastBits) {
  for (double angle = -20.0; angle < 20.0; angle += 0.001) {
    const Direction direction = direction_of(angle);
    ASSERT_NEAR(direction.sine, std::sin(angle), 4e-16) << angle;
    ASSERT_NEAR(direction.cosine, std::cos(angle), 4e-16) << angle;
  }
  static_assert(direction_of(0.0).sine == 0.0 && direction_of(0.0).cosine == 1.0);
}

TEST(TurnedBy, TurnsToTheLeftByTheAngle) {
  for (double from = -3.0; from < 3.0; from += 0.31)
    for (double angle = -0.33; angle <= 0.33; angle += 0.0071) {
      const Direction turned = turned_by(direction_of(from), angle);
      ASSERT_NEAR(turned.sine, std::sin(from + angle), 2e-9) << from << " and " << angle;
      ASSERT_NEAR(turned.cosine, std::cos(from + angle), 2e-9) << from << " and " << angle;
    }
}

TEST(TurnedBy, IsStillADirectionAfterManyTurns) {
  Direction direction;
  for (int i = 0; i < 1'000'000; ++i) direction = turned_by(direction, 0.01 * (i % 13 - 6));
  EXPECT_NEAR(std::hypot(direction.sine, direction.cosine), 1.0, 1e-12);
}

TEST(TurnedBy, LosesNothingOverAThousandTurnsOfATick) {
  Direction direction;
  for (int i = 0; i < 1000; ++i) direction = turned_by(direction, 0.012);
  EXPECT_NEAR(std::remainder(std::atan2(direction.sine, direction.cosine) - 12.0, 2.0 * pi), 0.0, 1e-9);
}

TEST(SineOfTurns, IsTheSineToAHundredThousandth) {
  for (double turns = -3.0; turns < 3.0; turns += 0.00013)
    ASSERT_NEAR(sine_of_turns(turns), std::sin(2.0 * pi * turns), 1e-5) << turns;
  EXPECT_NEAR(sine_of_turns(1e6 + 0.25), 1.0, 1e-5);
}

TEST(WholeBelow, IsTheFloor) {
  for (double number = -5.0; number <= 5.0; number += 0.125) {
    ASSERT_EQ(whole_below(number), static_cast<int>(std::floor(number))) << number;
    ASSERT_EQ(whole_below(number * 1e8), static_cast<int>(std::floor(number * 1e8))) << number;
  }
  EXPECT_EQ(whole_below(-1e-300), -1);
}

}  // namespace
}  // namespace labmouse
