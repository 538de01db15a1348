// Straights driven in small steps of time, from a robot's limits alone: that its tables say the same of them.
//
// Nothing is shared with the code under test but the values of the robot and its tables. Lengths are mm, times seconds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "labmouse/mouse/robot/drive_model.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/mouse/robot_parameters.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::builtin;
using test::PrintRobot;

/// A mouse that speeds up on its way towards another one.
struct Runner {
  double speed = 0.0;
  double acceleration = 0.0;
  double top = 0.0;
  double way = 0.0;

  /// For some time, but not farther than `most`; says how long it took.
  double drive(double time, double most) {
    const double after = std::min(top, speed + acceleration * time);
    const double middle = (speed + after) / 2.0;
    const double spent = middle * time <= most ? time : most / middle;
    speed += (after - speed) * spent / time;
    way += middle * spent;
    return spent;
  }
};

struct Straight {
  double length = 0.0;
  double from = 0.0, to = 0.0;  ///< speeds
  double top = 0.0, acceleration = 0.0, braking = 0.0;
  double counted = length;  ///< of its length, from its beginning: the time of this part
};

/// The least time, or nothing where there is none. One mouse speeds up from the beginning and another one, back in
/// time, from the end. Whichever is slower drives on, until they meet at one speed: neither may be faster where it is.
std::optional<double> least_seconds(const Straight& straight) {
  constexpr double step = 1e-4, hair = 1e-9;
  Runner first{straight.from, straight.acceleration, straight.top, 0.0};
  Runner last{straight.to, straight.braking, straight.top, 0.0};
  double seconds = 0.0;
  const auto gap = [&] { return straight.length - first.way - last.way; };
  while (gap() > hair) {
    const bool on = first.speed <= last.speed;
    Runner& slower = on ? first : last;
    const double begin = slower.way;
    // At the top nothing changes any more.
    const double time = slower.speed >= straight.top ? gap() / straight.top * 2.0 : step;
    const double spent = slower.drive(time, gap());
    const double low = on ? begin : straight.length - slower.way, high = on ? slower.way : straight.length - begin;
    const double part = std::clamp(straight.counted - low, 0.0, high - low) / (high - low);
    seconds += spent * part;
  }
  // The last step may have been a little too long.
  const double most = std::max(straight.acceleration, straight.braking) * step;
  if (std::abs(first.speed - last.speed) > most) return std::nullopt;
  return seconds;
}

/// Whether the speeds at both ends are so far apart that a step more or less decides.
bool at_the_edge(const Straight& it) {
  constexpr double edge = 0.005;
  const double gained = it.to * it.to - it.from * it.from, largest = std::max(it.to, it.from);
  const double room = 2.0 * it.length * (gained > 0.0 ? it.acceleration : it.braking);
  return gained != 0.0 && std::abs(std::abs(gained) - room) < edge * largest * largest;
}

void expect_least(DriveTime time, const Straight& straight, double rounding = 0.0) {
  if (at_the_edge(straight)) return;
  const auto least = least_seconds(straight);
  ASSERT_EQ(time < no_time, least.has_value());
  if (!least) return;
  EXPECT_LE(time, *least * 1e6 + 1.0);
  EXPECT_GE(time, *least * 1e6 - 1.0 - rounding);
}

constexpr std::array sampled_units = {0, 1, 2, 3, 8, 21, 64};
/// So many-th of the pairs of lanes.
const std::size_t every = test::thorough ? 1 : 7;

class StraightsInSteps : public testing::TestWithParam<Robot> {
 protected:
  StraightsInSteps() : model_(make_drive_model(robot())) {}
  void SetUp() override { ASSERT_EQ(model_.error, ""); }

  static const Robot& robot() { return GetParam(); }
  const DriveTables& tables() const { return model_.tables; }

  static Straight along(double length, double from, double to) {
    return {length, from, to, robot().speed, robot().acceleration, robot().braking};
  }
  static Straight diagonal(double length, double from, double to) {
    return {length, from, to, robot().speed_diagonal, robot().acceleration_diagonal, robot().braking_diagonal};
  }

  /// A straight to the goal: all that the mouse may still drive until it stands, if it must stop, but only the time to
  /// the goal counts. Where it need not, it has all the way that it could need.
  static Straight to_goal(double length, double from, int room) {
    const double endless = robot().speed * robot().speed / robot().braking;
    Straight straight = along(length + (robot().stop == Stop::goal ? room * robot().cell : endless), from, 0.0);
    straight.counted = length;
    return straight;
  }

  DriveModel model_;
};

template <class Make>
void expect_least_between(const StraightTimes& straights, double unit, Make make) {
  for (const int units : sampled_units)
    for (std::size_t from = 0; from < straights.count(); ++from)
      for (std::size_t to = (from + static_cast<std::size_t>(units)) % every; to < straights.count(); to += every) {
        const Lane &before = straights.lanes[from], &after = straights.lanes[to];
        SCOPED_TRACE(testing::Message() << units << " units from lane " << from << " to " << to);
        // A straight may be made of many between turns that follow each other; then each of them was rounded.
        const bool split = from == to && before.lead == 0.0;
        expect_least(straights.at(units, from, to),
                     make(before.lead + units * unit + after.lead, before.speed, after.speed),
                     split ? units / 2.0 : 0.0);
      }
}

TEST_P(StraightsInSteps, TakeTheLeastTimeBetweenAllLanes) {
  LABMOUSE_SKIP_SANITIZED();
  expect_least_between(tables().along, robot().cell / 2.0, along);
}

TEST_P(StraightsInSteps, TakeTheLeastTimeBetweenAllDiagonalLanes) {
  LABMOUSE_SKIP_SANITIZED();
  expect_least_between(tables().diagonal, robot().cell / std::numbers::sqrt2, diagonal);
}

TEST_P(StraightsInSteps, BeginAtRestBehindTheMiddleOfTheStart) {
  LABMOUSE_SKIP_SANITIZED();
  if (robot().fixed) return;
  for (const int units : sampled_units)
    for (std::size_t lane = 0; lane < tables().along.count(); ++lane) {
      SCOPED_TRACE(testing::Message() << units << " units to lane " << lane);
      const auto [speed, lead] = tables().along.lanes[lane];
      expect_least(tables().start_to(units, lane),
                   along(robot().run_up + units * robot().cell / 2.0 + lead, 0.0, speed));
    }
}

TEST_P(StraightsInSteps, EndInTheGoalWithRoomToStop) {
  LABMOUSE_SKIP_SANITIZED();
  if (robot().fixed) return;
  for (int room = 0; room <= tables().rooms(); ++room)
    for (const int units : sampled_units) {
      const double length = units * robot().cell / 2.0;
      SCOPED_TRACE(testing::Message() << units << " units and " << room << " cells to stop in");
      expect_least(tables().whole_way(units, room), to_goal(robot().run_up + length, 0.0, room));
      for (std::size_t lane = 0; lane < tables().along.count(); ++lane) {
        const auto [speed, lead] = tables().along.lanes[lane];
        expect_least(tables().finish_from(units, lane, room), to_goal(lead + length, speed, room));
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Robots, StraightsInSteps,
                         testing::Values(builtin("beginner"), builtin("classic"), builtin("half"), builtin("kerise"),
                                         builtin("mm2021"), fan_robot(), weak_brakes(), jerk_robot(),
                                         large_jerk_robot(), small_grip_robot(), unstopped_robot(), square_robot(),
                                         slow_robot(), strong_robot(), robot_of_speeds<1>(), robot_of_speeds<8>()),
                         PrintRobot());

}  // namespace
}  // namespace labmouse
