// The inner loop of programs that ask for speeds, with the body of the physical world.
#include "labmouse/controller/speed_control.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/body/body_in_a_maze.hpp"
#include "tests/controller/robots.hpp"

namespace labmouse {
namespace {

class ASpeedControl : public testing::TestWithParam<std::string> {
 protected:
  ASpeedControl() { body_.put({1, 1}, Heading::north); }

  /// Drives at that speed for so many ms.
  void drive(double speed, double turning, int ticks) {
    for (int i = 0; i < ticks; ++i)
      ASSERT_NE(body_.step(control_.control(speed, turning, body_.sense())), Touch::crash);
  }

  static Maze without_walls() { return Maze(MazeDraft({16, 16}, MazeDraft::Inside::open)); }

  const DriveModel model_ = test::model_of(GetParam());
  const double cell_ = model_.tables.cell;
  test::BodyInAMaze body_{without_walls(), cell_, *model_.robot.hardware, no_errors};
  SpeedControl control_{*model_.robot.hardware, cell_};
};

TEST_P(ASpeedControl, ReachesTheSpeedAndTheTurnRate) {
  drive(4.0 * cell_, 0.0, 300);
  EXPECT_NEAR(body_.motion().speed, 4.0 * cell_, 0.02 * 4.0 * cell_);
  EXPECT_NEAR(body_.motion().turning, 0.0, 0.02);
  drive(2.0 * cell_, 2.0, 300);
  EXPECT_NEAR(body_.motion().speed, 2.0 * cell_, 0.05 * 2.0 * cell_);
  EXPECT_NEAR(body_.motion().turning, 2.0, 0.1);
  drive(0.0, -3.0, 300);
  EXPECT_NEAR(body_.motion().turning, -3.0, 0.15);
}

TEST_P(ASpeedControl, BeginsAnewWhereTheMouseWasPutDown) {
  drive(4.0 * cell_, 0.0, 300);
  body_.put({1, 1}, Heading::north);
  control_.rest();
  drive(0.0, 0.0, 200);
  EXPECT_NEAR(body_.motion().position.y, 1.5 * cell_, 0.01 * cell_);
}

INSTANTIATE_TEST_SUITE_P(OfRobots, ASpeedControl, testing::Values("kerise", "classic", "beginner"),
                         [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace labmouse
