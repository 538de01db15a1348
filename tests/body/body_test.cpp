// A whole body: hands that put it down, grazes and crashes, and that all of it comes from its seed.
#include "labmouse/body/body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "labmouse/functions/whole.hpp"
#include "tests/body/body_in_a_maze.hpp"
#include "tests/body/boxes.hpp"
#include "tests/body/plain_mouse.hpp"

namespace labmouse {
namespace {

using test::BodyInAMaze;

/// A mouse without noise in a hall of 8 by 8 cells, that drives towards the east wall at an angle and a speed, without
/// losing any.
class TowardsAWall {
 public:
  TowardsAWall(double degrees, double speed) : speed_(speed) {
    // 350 mm before its right front corner meets the wall: it comes to its speed on the way.
    const double angle = pi / 2.0 - degrees * pi / 180.0;
    const double corner = 25.0 * std::cos(angle) + 18.0 * std::sin(angle);
    const double face = 800.0 - test::half_wall;
    body_.put({face - corner - 350.0 * std::cos(angle), 400.0 - 350.0 * std::sin(angle)}, angle);
  }

  /// So many ticks, or until it has crashed: what it touched first.
  Touch drive(int ticks) {
    Touch first = Touch::none;
    for (int i = 0; i < ticks && !body_.crashed(); ++i)
      if (const Touch touch = step(speed_); touch != Touch::none) {
        ++touches_;
        if (first == Touch::none) first = touch;
      }
    return first;
  }
  const Body& body() const { return body_; }
  int touches() const { return touches_; }

 private:
  Touch step(double speed) {
    const double more = std::clamp(0.02 * (speed - body_.motion().speed), -0.3, 0.3);
    const auto duty = static_cast<float>(speed / 3000.0 + 0.05 + more);
    return body_.step({duty, duty});
  }

  BodyInAMaze body_{test::hall(8), test::cell, test::plain_mouse()};
  double speed_;
  int touches_ = 0;
};

TEST(Touch, IsAGrazeAtASmallAngleAndASmallSpeedTowardsTheWall) {
  // 9 degrees at 300 mm/s are 47 mm/s towards the wall.
  TowardsAWall mouse(9.0, 300.0);
  EXPECT_EQ(mouse.drive(2000), Touch::graze);
  EXPECT_FALSE(mouse.body().crashed());
}

TEST(Touch, IsACrashAtALargeAngle) {
  TowardsAWall mouse(17.0, 150.0);
  EXPECT_EQ(mouse.drive(4000), Touch::crash) << "44 mm/s, but at 17 degrees";
}

TEST(Touch, IsACrashAtALargeSpeedTowardsTheWall) {
  TowardsAWall mouse(9.0, 400.0);
  EXPECT_EQ(mouse.drive(2500), Touch::crash) << "63 mm/s";
}

TEST(Graze, TurnsTheMouseAlongTheWallAndLetsItGoOn) {
  TowardsAWall mouse(9.0, 300.0);
  ASSERT_EQ(mouse.drive(2000), Touch::graze);
  const BodyMotion& motion = mouse.body().motion();
  // Parallel to the wall to within what a touch turns, its side at the wall, and as fast as before.
  EXPECT_NEAR(motion.angle, pi / 2.0, 0.02);
  EXPECT_NEAR(motion.position.x, 800.0 - test::half_wall - 18.0, 1.0);
  EXPECT_GT(motion.speed, 280.0);
  EXPECT_GE(mouse.touches(), 1);
  EXPECT_LT(mouse.touches(), 30) << "one touch counts once, however many ticks it lasts";
}

TEST(Graze, LeavesNoPartOfTheMouseInTheWall) {
  TowardsAWall mouse(9.0, 300.0);
  for (int i = 0; i < 2000; ++i) {
    mouse.drive(1);
    const BodyMotion& motion = mouse.body().motion();
    const double corner = 25.0 * std::max(0.0, motion.ahead.cosine) + 18.0 * motion.ahead.sine;
    ASSERT_LT(motion.position.x + corner, 800.0 - test::half_wall + 0.6) << i;
  }
}

TEST(Crash, StopsTheMouseUntilAHandPutsItSomewhere) {
  BodyInAMaze body(test::hall(4), test::cell, test::plain_mouse());
  body.put({250.0, 250.0}, 0.0);
  Touch touch = Touch::none;
  for (int i = 0; i < 3000 && touch != Touch::crash; ++i) touch = body.step({0.2F, 0.2F});
  ASSERT_EQ(touch, Touch::crash);
  EXPECT_EQ(body.contact().wall, wall_at({3, 2}, Heading::east));
  const Position at = body.motion().position;
  const auto counts = body.sense().counts;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(body.step({0.5F, 0.5F}), Touch::none);
  EXPECT_EQ(body.motion().position, at);
  EXPECT_EQ(body.motion().speed, 0.0);
  EXPECT_EQ(body.sense().counts, counts);
  EXPECT_TRUE(body.crashed());
  body.put({150.0, 150.0}, 0.0);
  EXPECT_FALSE(body.crashed());
  for (int i = 0; i < 100; ++i) body.step({0.2F, 0.2F});
  EXPECT_GT(body.motion().position.x, 151.0);
}

TEST(Body, KnowsWhetherItHasSlidLately) {
  BodyInAMaze body(test::hall(16), test::cell, test::plain_mouse());
  body.put({800.0, 800.0}, 0.0);
  EXPECT_FALSE(body.slid_within(1'000'000));
  for (int i = 0; i < 60; ++i) body.step({0.3F, 0.3F});
  EXPECT_FALSE(body.slid_within(1'000'000));
  for (int i = 0; i < 60; ++i) body.step({0.1F, 0.7F});
  ASSERT_TRUE(body.slid_within(60));
  for (int i = 0; i < 500; ++i) body.step({0.0F, 0.0F});
  EXPECT_FALSE(body.slid_within(50));
}

TEST(Hand, IsOffByThePlacementOfTheVariation) {
  BodyInAMaze body(test::hall(4), test::cell, test::varied_mouse());
  double x = 0.0, y = 0.0, angle = 0.0;
  constexpr int times = 2000;
  for (int i = 0; i < times; ++i) {
    body.put({150.0, 250.0}, 0.5);
    x += square(body.motion().position.x - 150.0) / times;
    y += square(body.motion().position.y - 250.0) / times;
    angle += square(body.motion().angle - 0.5) / times;
  }
  EXPECT_NEAR(std::sqrt(x), 1.0, 0.05);
  EXPECT_NEAR(std::sqrt(y), 1.0, 0.05);
  EXPECT_NEAR(std::sqrt(angle), 0.02, 0.001);
}

std::vector<Sense> driven(const Hardware& hardware, const ErrorScale& level, std::uint64_t seed) {
  BodyInAMaze body(test::some_maze(2), test::cell, hardware, level, seed);
  body.put({50.0, 50.0}, 1.5);
  std::vector<Sense> all;
  for (int i = 0; i < 400; ++i) {
    body.step({0.1F, 0.11F});
    all.push_back(body.sense());
  }
  return all;
}

TEST(Body, IsTheSameForTheSameSeedAndAnotherForAnother) {
  EXPECT_EQ(driven(test::varied_mouse(), {}, 1), driven(test::varied_mouse(), {}, 1));
  EXPECT_NE(driven(test::varied_mouse(), {}, 1), driven(test::varied_mouse(), {}, 2));
}

TEST(Body, HasNoChanceInItWithoutNoise) {
  EXPECT_EQ(driven(test::varied_mouse(), no_errors, 1), driven(test::varied_mouse(), no_errors, 2));
  EXPECT_EQ(driven(test::plain_mouse(), {}, 1), driven(test::varied_mouse(), no_errors, 2));
}

TEST(Body, ReadsOnceATick) {
  const std::vector<Sense> all = driven(test::plain_mouse(), {}, 1);
  for (std::size_t i = 1; i < all.size(); ++i) ASSERT_EQ(all[i].tick, all[i - 1].tick + 1);
}

}  // namespace
}  // namespace labmouse
