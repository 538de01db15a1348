// What a contest draws: one mouse on one day.
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

Hardware noisy_mouse() {
  Hardware hardware = test::plain_mouse();
  hardware.noise = test::plain_noise();
  return hardware;
}

struct Drawn {
  double mean = 0.0, deviation = 0.0;
};
/// Of a number of a thousand mice.
Drawn drawn(const std::function<double(const RobotSample&)>& number, const NoiseLevel& level = {}) {
  const Hardware hardware = noisy_mouse();
  std::vector<double> all;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) all.push_back(number(RobotSample(hardware, level, {2, 2}, seed)));
  Drawn drawn;
  for (const double one : all) drawn.mean += one / 1000.0;
  for (const double one : all) drawn.deviation += square(one - drawn.mean) / 1000.0;
  drawn.deviation = std::sqrt(drawn.deviation);
  return drawn;
}

TEST(RobotSample, DrawsFactorsAboutOneWithTheDeviationOfTheNoise) {
  const auto expect = [](double deviation, const std::function<double(const RobotSample&)>& number) {
    const Drawn found = drawn(number);
    EXPECT_NEAR(found.mean, 1.0 + square(deviation) / 2.0, deviation / 8.0);
    EXPECT_NEAR(found.deviation, deviation, deviation / 10.0);
  };
  expect(0.1, [](const RobotSample& it) { return it.motor[0]; });
  expect(0.1, [](const RobotSample& it) { return it.motor[1]; });
  expect(0.2, [](const RobotSample& it) { return it.stiffness; });
  expect(0.1, [](const RobotSample& it) { return it.grip; });
  expect(0.01, [](const RobotSample& it) { return it.encoder[0]; });
  expect(0.01, [](const RobotSample& it) { return it.encoder[1]; });
  expect(0.005, [](const RobotSample& it) { return it.gyro; });
  expect(0.05, [](const RobotSample& it) { return it.infrared[3]; });
  expect(0.05, [](const RobotSample& it) { return it.reflectance({1, 0}, Heading::south); });
}

TEST(RobotSample, HasStepsInTheFloorAsOftenAsTheNoiseSays) {
  const Hardware hardware = noisy_mouse();
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

TEST(RobotSample, IsTheMakersOwnWithoutNoise) {
  const Hardware hardware = noisy_mouse();
  NoiseLevel none;
  none.all = 0.0;
  const RobotSample robot_sample(hardware, none, {4, 4}, 3);
  EXPECT_EQ(robot_sample.motor[0], 1.0);
  EXPECT_EQ(robot_sample.stiffness, 1.0);
  EXPECT_EQ(robot_sample.grip, 1.0);
  EXPECT_EQ(robot_sample.encoder[1], 1.0);
  EXPECT_EQ(robot_sample.gyro, 1.0);
  EXPECT_EQ(robot_sample.infrared[2], 1.0);
  EXPECT_EQ(robot_sample.reflectance({1, 1}, Heading::west), 1.0);
  EXPECT_EQ(robot_sample.floor_step({{1, 1}, Heading::north}).turn, 0.0);
}

TEST(RobotSample, DrawsEachNumberWhateverElseIsSwitchedOff) {
  const Hardware hardware = noisy_mouse();
  const auto numbers = [&](const NoiseLevel& level, NoiseGroup group) {
    const RobotSample it(hardware, level, {4, 4}, 5);
    const FloorStep step = [&] {
      FloorStep largest;
      for (int index = 0; index < 16; ++index)
        if (const FloorStep at = it.floor_step({Size{4, 4}.cell_at(index), Heading::north});
            std::abs(at.turn) > std::abs(largest.turn))
          largest = at;
      return largest;
    }();
    switch (group) {
      case NoiseGroup::motors:
        return std::vector<double>{it.motor[0], it.motor[1]};
      case NoiseGroup::tyres:
        return std::vector<double>{it.stiffness, it.grip};
      case NoiseGroup::floor:
        return std::vector<double>{step.turn, step.shift};
      case NoiseGroup::encoders:
        return std::vector<double>{it.encoder[0], it.encoder[1]};
      case NoiseGroup::gyro:
        return std::vector<double>{it.gyro};
      case NoiseGroup::infrared:
        return std::vector<double>{it.infrared[0], it.reflectance({2, 2}, Heading::east)};
      default:
        return std::vector<double>{};
    }
  };
  for (std::size_t i = 0; i < noise_groups; ++i)
    for (std::size_t j = 0; j < noise_groups; ++j) {
      const auto off = static_cast<NoiseGroup>(i), read = static_cast<NoiseGroup>(j);
      const auto all = numbers({}, read);
      if (all.empty()) continue;
      EXPECT_EQ(numbers(test::all_but(off), read) == all, i != j) << name_of(read) << " without " << name_of(off);
    }
}

TEST(RobotSample, DrawsLogarithmsThatSpreadAsTheyAreTold) {
  NoiseLevel level;
  level.variation = 3.0;
  const Drawn logarithm = drawn([](const RobotSample& it) { return std::log(it.stiffness); }, level);
  EXPECT_NEAR(logarithm.mean, 0.0, 0.06);
  EXPECT_NEAR(logarithm.deviation, 0.6, 0.06);
  const Hardware hardware = noisy_mouse();
  const RobotSample far(hardware, level, {2, 2}, 4), plain(hardware, {}, {2, 2}, 4);
  for (const auto number : {&RobotSample::stiffness, &RobotSample::grip, &RobotSample::gyro})
    EXPECT_NEAR(std::log(far.*number), 3.0 * std::log(plain.*number), 1e-9);
  EXPECT_NEAR(std::log(far.motor[0]), 3.0 * std::log(plain.motor[0]), 1e-9);
  EXPECT_NEAR(std::log(far.infrared[2]), 3.0 * std::log(plain.infrared[2]), 1e-9);
  // How far the scales of encoders are apart was measured.
  EXPECT_NE(plain.encoder[0], 1.0);
  EXPECT_EQ(far.encoder, plain.encoder);
  // Walls and floor are the maze's, not the mouse's.
  EXPECT_EQ(far.reflectance({1, 1}, Heading::north), plain.reflectance({1, 1}, Heading::north));
  EXPECT_EQ(far.level(NoiseGroup::ranger), 1.0);
}

TEST(RobotSample, IsFrailWhereOneOfItsNumbersIsFarOff) {
  const Hardware hardware = noisy_mouse();
  NoiseLevel level, none;
  level.variation = 2.0;
  none.all = 0.0;
  EXPECT_EQ(RobotSample(hardware, none, {2, 2}, 4).severity(), 0.0);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const RobotSample it(hardware, level, {2, 2}, seed);
    double fourth = 0.0;
    const auto add = [&](double factor, double deviation) { fourth += square(square(std::log(factor) / deviation)); };
    const Noise& noise = hardware.noise;
    for (const double factor : it.motor) add(factor, noise.motor_gain);
    add(it.stiffness, noise.stiffness);
    add(it.grip, noise.grip);
    add(it.gyro, noise.gyro_scale);
    EXPECT_NEAR(it.severity(), std::sqrt(std::sqrt(fourth / 5.0)), 1e-6);
  }
}

TEST(RobotSample, IsAsWeakAsTheWorseOfItsMotors) {
  const Hardware hardware = noisy_mouse();
  NoiseLevel level;
  level.variation = 3.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RobotSample it(hardware, level, {2, 2}, seed);
    EXPECT_EQ(it.weaker_motor(), std::min(it.motor[0], it.motor[1]));
    double squares = 0.0;
    for (const double factor : it.infrared) squares += square(std::log(factor));
    EXPECT_NEAR(it.infrared_deviation(), std::sqrt(squares / beam_count), 1e-9);
  }
}

/// As its controller is told.
TEST(RobotSample, IsSpreadByTheSameNumbersThatItsControllerIsTold) {
  const Noise book = test::plain_noise(), told = varied_by(book, 3.0);
  Hardware as_told = noisy_mouse();
  as_told.noise = told;
  NoiseLevel level;
  level.variation = 3.0;
  const Hardware hardware = noisy_mouse();
  const RobotSample far(hardware, level, {2, 2}, 4), plain(as_told, {}, {2, 2}, 4);
  EXPECT_EQ(told.encoder_scale, book.encoder_scale);
  EXPECT_EQ(told.motor_gain, 3.0 * book.motor_gain);
  for (const auto number : {&RobotSample::stiffness, &RobotSample::grip, &RobotSample::gyro})
    EXPECT_NEAR(far.*number, plain.*number, 1e-9);
  for (std::size_t wheel : {0U, 1U}) {
    EXPECT_NEAR(far.motor[wheel], plain.motor[wheel], 1e-9);
    EXPECT_NEAR(far.encoder[wheel], plain.encoder[wheel], 1e-9);
  }
  EXPECT_NEAR(far.infrared[1], plain.infrared[1], 1e-9);
}

TEST(RobotSample, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const Hardware hardware = noisy_mouse();
  const RobotSample a(hardware, {}, {4, 4}, 1), b(hardware, {}, {4, 4}, 1), c(hardware, {}, {4, 4}, 2);
  EXPECT_EQ(a.motor, b.motor);
  EXPECT_EQ(a.reflectance({3, 3}, Heading::north), b.reflectance({3, 3}, Heading::north));
  EXPECT_NE(a.motor, c.motor);
}

TEST(RobotSample, NeverIsBeyondATenthOrTenTimes) {
  Hardware hardware = noisy_mouse();
  NoiseLevel level;
  level.all = 1000.0;
  level.variation = 10.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const RobotSample it(hardware, level, {2, 2}, seed);
    for (const double factor : {it.motor[0], it.stiffness, it.grip, it.encoder[0], it.gyro, it.infrared[1]}) {
      ASSERT_GE(factor, 0.0999);
      ASSERT_LE(factor, 10.001);
    }
  }
}

}  // namespace
}  // namespace labmouse
