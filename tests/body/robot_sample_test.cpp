// What a contest draws: one mouse in one maze on one day.
#include "labmouse/body/robot_sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "labmouse/functions/whole.hpp"
#include "tests/body/plain_mouse.hpp"

namespace labmouse {
namespace {

struct Drawn {
  double mean = 0.0, deviation = 0.0;
};
/// Of a number of a thousand mice.
Drawn drawn(const std::function<double(const RobotSample&)>& number, const ErrorScale& scale = {}) {
  const Hardware hardware = test::varied_mouse();
  std::vector<double> all;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) all.push_back(number(RobotSample(hardware, scale, {2, 2}, seed)));
  Drawn drawn;
  for (const double one : all) drawn.mean += one / 1000.0;
  for (const double one : all) drawn.deviation += square(one - drawn.mean) / 1000.0;
  drawn.deviation = std::sqrt(drawn.deviation);
  return drawn;
}

TEST(RobotSample, DrawsFactorsAboutOneWithTheDeviationOfTheVariation) {
  const auto expect = [](double deviation, const std::function<double(const RobotSample&)>& number) {
    const Drawn found = drawn(number);
    EXPECT_NEAR(found.mean, 1.0 + square(deviation) / 2.0, deviation / 8.0);
    EXPECT_NEAR(found.deviation, deviation, deviation / 10.0);
  };
  expect(0.05, [](const RobotSample& it) { return it.motor[0]; });
  expect(0.05, [](const RobotSample& it) { return it.motor[1]; });
  expect(0.2, [](const RobotSample& it) { return it.stiffness; });
  expect(0.1, [](const RobotSample& it) { return it.grip; });
  expect(0.01, [](const RobotSample& it) { return it.encoder[0]; });
  expect(0.01, [](const RobotSample& it) { return it.encoder[1]; });
  expect(0.005, [](const RobotSample& it) { return it.gyro; });
  expect(0.05, [](const RobotSample& it) { return it.infrared[3]; });
  // Of the wall and of the maze.
  expect(std::sqrt(square(0.05) + square(0.1)), [](const RobotSample& it) {
    return it.reflectance({1, 0}, Heading::south);
  });
  const Drawn offset = drawn([](const RobotSample& it) { return it.acceleration[1]; });
  EXPECT_NEAR(offset.mean, 0.0, 30.0);
  EXPECT_NEAR(offset.deviation, 300.0, 30.0);
  const Drawn slope = drawn([](const RobotSample& it) { return it.floor({1, 1}).slope.x; });
  EXPECT_NEAR(slope.deviation, 0.01, 0.001);
}

/// The mean of the absolute value of a normal number is 0.798 of its deviation.
TEST(RobotSample, DrawsWhatOnlyTakesAwayOrOnlyAdds) {
  const auto battery = [](const RobotSample& it) { return it.battery; };
  const auto dust = [](const RobotSample& it) { return std::log(it.floor({0, 1}).grip); };
  const auto light = [](const RobotSample& it) { return it.ambient[2]; };
  EXPECT_NEAR(drawn(battery).mean, 1.0 - 0.05 * 0.798, 0.003);
  EXPECT_NEAR(drawn(dust).mean, -0.1 * 0.798, 0.006);
  EXPECT_NEAR(drawn(light).mean, 30.0 * 0.798, 2.0);
  const Hardware hardware = test::varied_mouse();
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const RobotSample it(hardware, {.variation = 5.0}, {2, 2}, seed);
    EXPECT_LE(it.battery, 1.0);
    EXPECT_GE(it.battery, 0.0);
    EXPECT_LE(it.floor({1, 0}).grip, 1.0);
    EXPECT_GE(it.ambient[0], 0.0);
  }
}

TEST(RobotSample, HasNoMotorThatABuilderWouldReplace) {
  const Hardware hardware = test::varied_mouse();
  double least = 1.0, most = 1.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    for (const double factor : RobotSample(hardware, {.variation = 10.0}, {2, 2}, seed).motor) {
      least = std::min(least, factor);
      most = std::max(most, factor);
    }
  EXPECT_EQ(least, 0.8);
  EXPECT_EQ(most, 1.2);
}

TEST(RobotSample, HasStepsInTheFloorAsOftenAsTheVariationSays) {
  const Hardware hardware = test::varied_mouse();
  const RobotSample robot_sample(hardware, {}, {32, 32}, 3);
  int steps = 0;
  double turns = 0.0, shifts = 0.0;
  for (int index = 0; index < 32 * 32; ++index)
    for (const Heading side : {Heading::north, Heading::east}) {
      const FloorStep step = robot_sample.floor_step({Size{32, 32}.cell_at(index), side});
      steps += step.turn != 0.0 ? 1 : 0;
      turns += square(step.turn);
      shifts += square(step.shift);
    }
  EXPECT_NEAR(steps / 2048.0, 0.2, 0.03);
  EXPECT_NEAR(std::sqrt(turns / steps), 0.01, 0.001);
  EXPECT_NEAR(std::sqrt(shifts / steps), 0.5, 0.05);
}

TEST(RobotSample, HasPostsBesideTheirPlaces) {
  const Hardware hardware = test::varied_mouse();
  const RobotSample sample(hardware, {}, {32, 32}, 3);
  ASSERT_EQ(sample.post_shifts().size(), 33U * 33U);
  double squares = 0.0, most = 0.0;
  for (const Position& post : sample.post_shifts()) {
    squares += (square(post.x) + square(post.y)) / 2.0;
    most = std::max({most, std::abs(post.x), std::abs(post.y)});
  }
  // A normal number that is cut at 4/3 of its deviation has a deviation of 0.845 of it.
  EXPECT_NEAR(std::sqrt(squares / (33.0 * 33.0)), 0.845, 0.05);
  EXPECT_NEAR(most, 4.0 / 3.0, 1e-9);
}

TEST(RobotSample, IsNominalWithoutVariation) {
  const Hardware hardware = test::varied_mouse();
  const RobotSample robot_sample(hardware, {.variation = 0.0}, {4, 4}, 3);
  EXPECT_EQ(robot_sample.motor[0], 1.0);
  EXPECT_EQ(robot_sample.battery, 1.0);
  EXPECT_EQ(robot_sample.stiffness, 1.0);
  EXPECT_EQ(robot_sample.grip, 1.0);
  EXPECT_EQ(robot_sample.encoder[1], 1.0);
  EXPECT_EQ(robot_sample.gyro, 1.0);
  EXPECT_EQ(robot_sample.acceleration[0], 0.0);
  EXPECT_EQ(robot_sample.infrared[2], 1.0);
  EXPECT_EQ(robot_sample.ambient[2], 0.0);
  EXPECT_EQ(robot_sample.reflectance({1, 1}, Heading::west), 1.0);
  EXPECT_EQ(robot_sample.floor_step({{1, 1}, Heading::north}).turn, 0.0);
  EXPECT_EQ(robot_sample.floor({1, 1}).grip, 1.0);
  EXPECT_TRUE(robot_sample.post_shifts().empty());
  EXPECT_EQ(robot_sample.severity(), 0.0);
  EXPECT_EQ(robot_sample.brightness(), 1.0);
}

/// What a cause draws.
std::vector<double> numbers_of(const RobotSample& it, ErrorCause cause) {
  FloorStep step;
  for (int index = 0; index < 16; ++index)
    if (const FloorStep at = it.floor_step({Size{4, 4}.cell_at(index), Heading::north});
        std::abs(at.turn) > std::abs(step.turn))
      step = at;
  const Floor floor = it.floor({1, 2});
  switch (cause) {
    case ErrorCause::motors:
      return {it.motor[0], it.motor[1], it.battery};
    case ErrorCause::tyres:
      return {it.stiffness, it.grip, floor.grip};
    case ErrorCause::floor:
      return {step.turn, step.shift, floor.slope.x, floor.slope.y};
    case ErrorCause::posts:
      return it.post_shifts().empty() ? std::vector{0.0} : std::vector{it.post_shifts()[3].x, it.post_shifts()[7].y};
    case ErrorCause::encoders:
      return {it.encoder[0], it.encoder[1]};
    case ErrorCause::gyro:
      return {it.gyro};
    case ErrorCause::accelerometer:
      return {it.acceleration[0], it.acceleration[1]};
    case ErrorCause::infrared:
      return {it.infrared[0], it.infrared[3]};
    case ErrorCause::reflectance:
      return {it.reflectance({2, 2}, Heading::east)};
    case ErrorCause::ambient:
      return {it.ambient[0], it.ambient[3]};
    default:
      return {};
  }
}

TEST(RobotSample, DrawsEachNumberWhateverElseIsSwitchedOff) {
  const Hardware hardware = test::varied_mouse();
  const auto numbers = [&](const ErrorScale& scale, ErrorCause cause) {
    return numbers_of(RobotSample(hardware, scale, {4, 4}, 5), cause);
  };
  for (std::size_t i = 0; i < error_causes; ++i)
    for (std::size_t j = 0; j < error_causes; ++j) {
      const auto off = static_cast<ErrorCause>(i), read = static_cast<ErrorCause>(j);
      const auto all = numbers({}, read);
      if (all.empty()) continue;
      EXPECT_EQ(numbers(test::all_but(off), read) == all, i != j) << name_of(read) << " without " << name_of(off);
    }
}

TEST(RobotSample, DrawsLogarithmsInProportionToTheScale) {
  const ErrorScale scale = {.variation = 3.0};
  const Drawn logarithm = drawn([](const RobotSample& it) { return std::log(it.stiffness); }, scale);
  EXPECT_NEAR(logarithm.mean, 0.0, 0.06);
  EXPECT_NEAR(logarithm.deviation, 0.6, 0.06);
  const Hardware hardware = test::varied_mouse();
  const RobotSample far(hardware, scale, {2, 2}, 4), plain(hardware, {}, {2, 2}, 4);
  const auto expect = [](double of_far, double of_plain) {
    EXPECT_NEAR(std::log(of_far), 3.0 * std::log(of_plain), 1e-6);
  };
  for (const auto number : {&RobotSample::stiffness, &RobotSample::grip, &RobotSample::gyro})
    expect(far.*number, plain.*number);
  expect(far.infrared[2], plain.infrared[2]);
  expect(far.encoder[0], plain.encoder[0]);
  expect(far.reflectance({1, 1}, Heading::north), plain.reflectance({1, 1}, Heading::north));
  // The noise of each moment has a scale of its own.
  EXPECT_EQ(far.noise_of(ErrorCause::ranger), 1.0);
  EXPECT_EQ(RobotSample(hardware, {.noise = 3.0}, {2, 2}, 4).motor, plain.motor);
}

TEST(RobotSample, IsSevereWhereOneOfItsNumbersIsFarOff) {
  const Hardware hardware = test::varied_mouse();
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const RobotSample it(hardware, {.variation = 2.0}, {2, 2}, seed);
    double fourth = 0.0;
    const auto add = [&](double factor, double deviation) { fourth += square(square(std::log(factor) / deviation)); };
    const Variation& variation = hardware.variation;
    // Motors near the end of their range are cut.
    if (it.motor[0] <= 0.8 || it.motor[0] >= 1.2 || it.motor[1] <= 0.8 || it.motor[1] >= 1.2) continue;
    for (const double factor : it.motor) add(factor, variation.motor_gain);
    add(it.stiffness, variation.stiffness);
    add(it.grip, variation.grip);
    add(it.gyro, variation.gyro_scale);
    for (const double factor : it.infrared) add(factor, variation.infrared_gain);
    EXPECT_NEAR(it.severity(), std::sqrt(std::sqrt(fourth / 9.0)), 1e-6);
  }
}

TEST(RobotSample, SeesAWallAsBrightAsSensorAndWallAre) {
  const Hardware hardware = test::varied_mouse();
  const RobotSample it(hardware, {}, {3, 3}, 8),
      without_maze(hardware, test::all_but(ErrorCause::reflectance), {3, 3}, 8);
  const double maze = it.brightness() / without_maze.brightness();
  EXPECT_NE(maze, 1.0);
  const double ahead = (it.infrared[1] + it.infrared[3]) / 2.0;
  for (const auto& [looks, gain] : {std::pair{BeamSide::right, it.infrared[0]}, {BeamSide::ahead, ahead}}) {
    EXPECT_NEAR(it.brightness(looks, {1, 1}, Heading::west, true), gain * it.reflectance({1, 1}, Heading::west), 1e-9);
    EXPECT_NEAR(it.brightness(looks, {1, 1}, Heading::west, false), gain * maze, 1e-9);
  }
}

TEST(RobotSample, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const Hardware hardware = test::varied_mouse();
  const RobotSample a(hardware, {}, {4, 4}, 1), b(hardware, {}, {4, 4}, 1), c(hardware, {}, {4, 4}, 2);
  EXPECT_EQ(a.motor, b.motor);
  EXPECT_EQ(a.reflectance({3, 3}, Heading::north), b.reflectance({3, 3}, Heading::north));
  EXPECT_NE(a.motor, c.motor);
}

TEST(RobotSample, NeverIsBeyondATenthOrTenTimes) {
  const Hardware hardware = test::varied_mouse();
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const RobotSample it(hardware, {.variation = 10'000.0}, {2, 2}, seed);
    for (const double factor : {it.stiffness, it.grip, it.encoder[0], it.gyro, it.infrared[1]}) {
      ASSERT_GE(factor, 0.0999);
      ASSERT_LE(factor, 10.001);
    }
  }
}

}  // namespace
}  // namespace labmouse
