#include "labmouse/lab/text/time_left.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace labmouse {
namespace {

TEST(TimeLeft, GoesOnAsFastAsBefore) {
  EXPECT_EQ(seconds_left(1, 4, 10.0), 30.0);
  EXPECT_EQ(seconds_left(4, 4, 10.0), 0.0);
  EXPECT_EQ(seconds_left(5, 4, 10.0), 0.0);
}

TEST(TimeLeft, IsUnknownAtTheBeginning) {
  EXPECT_EQ(seconds_left(0, 4, 10.0), std::nullopt);
  EXPECT_EQ(seconds_left(1, 4, 0.5), std::nullopt);
}

TEST(DurationText, HasTwoUnits) {
  EXPECT_EQ(duration_text(0.2), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1 min 00 s");
  EXPECT_EQ(duration_text(200.0), "3 min 20 s");
  EXPECT_EQ(duration_text(3600.0 - 1.0), "59 min 59 s");
  EXPECT_EQ(duration_text(2.0 * 3600.0 + 5.0 * 60.0), "2 h 05 min");
  EXPECT_EQ(duration_text(24.0 * 3600.0 - 10.0), "1 d 00 h");
  EXPECT_EQ(duration_text(76.0 * 3600.0), "3 d 04 h");
  EXPECT_EQ(duration_text(1e300), "1000 d 00 h");
}

}  // namespace
}  // namespace labmouse
