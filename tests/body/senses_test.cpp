// What the sensors make of a motion: scales, biases, rounding, and the noise that they should have.
#include "labmouse/body/senses.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "labmouse/functions/whole.hpp"
#include "tests/body/plain_mouse.hpp"

namespace labmouse {
namespace {

/// The sensors of a mouse in a hall of 8 by 8 cells.
class Sensed {
 public:
  explicit Sensed(const Hardware& hardware, const ErrorScale& level = {}, std::uint64_t seed = 1)
      : hardware_(hardware),
        field_(maze_, test::cell),
        robot_sample_(hardware_, level, maze_.size(), seed),
        senses_(field_, hardware_, robot_sample_, seed) {
    motion.position = {350.0, 350.0};
  }

  const Sense& read() {
    senses_.read(motion, 1.0);
    return senses_.sense();
  }
  /// So many readings of a number in a row.
  std::vector<double> readings(int count, const std::function<double(const Sense&)>& number) {
    std::vector<double> all;
    for (int i = 0; i < count; ++i) all.push_back(number(read()));
    return all;
  }
  void calibrate() { senses_.calibrate(); }
  const RobotSample& robot_sample() const { return robot_sample_; }

  BodyMotion motion;

 private:
  Hardware hardware_;
  Maze maze_ = test::hall(8);
  Field field_;
  RobotSample robot_sample_;
  Senses senses_;
};

double mean_of(const std::vector<double>& numbers) {
  double sum = 0.0;
  for (const double number : numbers) sum += number;
  return sum / static_cast<double>(numbers.size());
}
double deviation_of(const std::vector<double>& numbers) {
  const double mean = mean_of(numbers);
  double squares = 0.0;
  for (const double number : numbers) squares += square(number - mean);
  return std::sqrt(squares / static_cast<double>(numbers.size()));
}
/// How much of one number's error is in the next.
double memory_of(const std::vector<double>& numbers) {
  const double mean = mean_of(numbers);
  double products = 0.0, squares = 0.0;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    products += (numbers[i] - mean) * (numbers[i - 1] - mean);
    squares += square(numbers[i] - mean);
  }
  return products / squares;
}

TEST(Encoders, CountTheTravelOfEachWheel) {
  Sensed mouse(test::plain_mouse());
  mouse.motion.speed = mouse.motion.rolling = 200.0;
  mouse.motion.yaw = 3.0;
  for (int tick = 1; tick <= 1000; ++tick) mouse.read();
  // Half a track of 16 mm: the left wheel is slower by 48 mm/s.
  const Sense& sense = mouse.read();
  EXPECT_NEAR(sense.counts[0] * 0.001, 1.001 * (200.0 - 48.0), 0.0011);
  EXPECT_NEAR(sense.counts[1] * 0.001, 1.001 * (200.0 + 48.0), 0.0011);
}

TEST(Encoders, CountBackwards) {
  Sensed mouse(test::plain_mouse());
  mouse.motion.speed = mouse.motion.rolling = -100.0;
  for (int tick = 0; tick < 100; ++tick) mouse.read();
  EXPECT_NEAR(mouse.read().counts[0] * 0.001, -10.1, 0.0011);
}

TEST(Encoders, OverstateByTheScaleThatTheContestDrew) {
  Sensed mouse(test::varied_mouse(), {}, 3);
  mouse.motion.speed = mouse.motion.rolling = 500.0;
  for (int tick = 0; tick < 2000; ++tick) mouse.read();
  const std::array<double, 2>& scale = mouse.robot_sample().encoder;
  EXPECT_GT(std::abs(scale[0] - scale[1]), 0.001);
  for (const std::size_t wheel : {std::size_t{0}, std::size_t{1}})
    EXPECT_NEAR(mouse.read().counts[wheel] * 0.001, 1000.7 * scale[wheel], 0.3 + 0.7) << wheel;
}

TEST(Encoders, AreOffByARippleOverATurnOfTheirMagnets) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.ripple = 0.1;
  hardware.noise.ripple_length = 12.5;
  Sensed mouse(hardware);
  mouse.motion.speed = mouse.motion.rolling = 125.0;
  // In ten turns, each of a hundred ticks: the part that goes with the turn.
  double sine = 0.0, cosine = 0.0;
  for (int tick = 1; tick <= 1000; ++tick) {
    const double off = mouse.read().counts[0] * 0.001 - tick * 0.125;
    sine += off * std::sin(2.0 * pi * tick / 100.0) / 500.0;
    cosine += off * std::cos(2.0 * pi * tick / 100.0) / 500.0;
  }
  EXPECT_NEAR(std::hypot(sine, cosine), 0.1, 0.001);
}

TEST(Encoders, CountWheelsThatSpin) {
  Sensed mouse(test::plain_mouse());
  mouse.motion.speed = 100.0;
  mouse.motion.rolling = 300.0;
  mouse.readings(1000, [](const Sense& sense) { return double(sense.counts[0]); });
  EXPECT_NEAR(mouse.read().counts[0] * 0.001, 300.3, 0.01);
}

TEST(Encoders, TrembleByTheirNoise) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.encoder = 0.02;
  Sensed mouse(hardware);
  EXPECT_NEAR(deviation_of(mouse.readings(10'000, [](const Sense& sense) { return sense.counts[0] * 0.001; })), 0.02,
              0.001);
}

TEST(Gyro, ShowsTheYawRateInItsUnits) {
  Sensed mouse(test::plain_mouse());
  for (const double yaw : {0.0, 0.0004, 0.0006, 3.1416, -12.3456, 29.9994}) {
    mouse.motion.yaw = yaw;
    EXPECT_EQ(mouse.read().gyro, std::lround(yaw / 0.001)) << yaw;
  }
}

TEST(Gyro, IsCutWhereItCanShowNoMore) {
  Sensed mouse(test::plain_mouse());
  mouse.motion.yaw = 31.0;
  EXPECT_EQ(mouse.read().gyro, 30'000);
  mouse.motion.yaw = -310.0;
  EXPECT_EQ(mouse.read().gyro, -30'000);
}

TEST(Gyro, OverstatesByTheScaleThatTheContestDrew) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.gyro_scale = 0.01;
  Sensed mouse(hardware, {}, 2);
  ASSERT_GT(std::abs(mouse.robot_sample().gyro - 1.0), 0.002);
  mouse.motion.yaw = 20.0;
  EXPECT_NEAR(mouse.read().gyro * 0.001, 20.0 * mouse.robot_sample().gyro, 0.0006);
}

TEST(Gyro, HasABiasOfItsOwnAfterEachCalibration) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.gyro_bias = 0.05;
  Sensed mouse(hardware);
  EXPECT_EQ(mouse.read().gyro, 0) << "before it there is none";
  const auto biases = [&] {
    std::vector<double> all;
    for (int i = 0; i < 2000; ++i) {
      mouse.calibrate();
      all.push_back(mouse.read().gyro * 0.001);
      EXPECT_EQ(mouse.read().gyro * 0.001, all.back()) << "it stays";
    }
    return all;
  }();
  EXPECT_NEAR(deviation_of(biases), 0.05, 0.003);
  EXPECT_NEAR(mean_of(biases), 0.0, 0.004);
}

TEST(Gyro, WandersByTheRootOfTime) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.gyro_walk = 0.05;
  std::vector<double> ends;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Sensed mouse(hardware, {}, seed);
    ends.push_back(mouse.readings(400, [](const Sense& sense) { return sense.gyro * 0.001; }).back());
  }
  EXPECT_NEAR(deviation_of(ends), 0.05 * std::sqrt(0.4), 0.003);
}

TEST(Gyro, HasWhiteNoise) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.gyro = 0.05;
  Sensed mouse(hardware);
  const auto readings = mouse.readings(20'000, [](const Sense& sense) { return sense.gyro * 0.001; });
  EXPECT_NEAR(deviation_of(readings), 0.05, 0.001);
  EXPECT_NEAR(memory_of(readings), 0.0, 0.03);
}

TEST(Accelerometer, ShowsBothAxesInItsUnits) {
  Sensed mouse(test::plain_mouse());
  mouse.motion.speeding = 2512.0;
  mouse.motion.sideways = -777.0;
  EXPECT_EQ(mouse.read().acceleration[0], 502);
  EXPECT_EQ(mouse.read().acceleration[1], -155);
}

TEST(Accelerometer, HasWhiteNoise) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.acceleration = 400.0;
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    Sensed mouse(hardware);
    const auto readings = mouse.readings(20'000, [&](const Sense& sense) { return sense.acceleration[axis] * 5.0; });
    EXPECT_NEAR(deviation_of(readings), 400.0, 10.0);
    EXPECT_NEAR(memory_of(readings), 0.0, 0.03);
  }
}

TEST(Accelerometer, HasTheOffsetsThatTheContestDrew) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.acceleration_bias = 300.0;
  Sensed mouse(hardware, {}, 4);
  mouse.motion.speeding = 1000.0;
  mouse.motion.sideways = -500.0;
  const auto& offsets = mouse.robot_sample().acceleration;
  ASSERT_GT(std::abs(offsets[0] - offsets[1]), 50.0);
  EXPECT_NEAR(mouse.read().acceleration[0] * 5.0, 1000.0 + offsets[0], 2.6);
  EXPECT_NEAR(mouse.read().acceleration[1] * 5.0, -500.0 + offsets[1], 2.6);
}

/// At rest with its nose up it feels what holds it there: an acceleration ahead.
TEST(Accelerometer, FeelsWhatHoldsItOnASlope) {
  Sensed mouse(test::plain_mouse());
  mouse.motion.pull = {-98.1, 49.05};
  EXPECT_NEAR(mouse.read().acceleration[0] * 5.0, 98.1, 2.6);
  EXPECT_NEAR(mouse.read().acceleration[1] * 5.0, -49.05, 2.6);
}

/// Far from all walls, an infrared sensor reads the light of the room.
TEST(Infrared, ReadsTheLightOfTheRoom) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.ambient = 30.0;
  Sensed mouse(hardware, {}, 4);
  for (std::size_t beam = 0; beam < hardware.sensors.infrared.size(); ++beam)
    EXPECT_NEAR(mouse.read().infrared[beam], mouse.robot_sample().ambient[beam], 0.51) << beam;
}

/// A random walk: over t seconds its deviation is the drift times the square root of t.
TEST(Infrared, ReadsThatLightChange) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.ambient = 2000.0;
  hardware.variation.ambient_drift = 50.0;
  double squares = 0.0;
  int count = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Sensed mouse(hardware, {}, seed);
    const std::vector<double> levels =
        mouse.readings(1001, [](const Sense& sense) { return double(sense.infrared[1]); });
    // Not where it is dark, or beyond the range of the sensor.
    if (levels.front() < 300.0 || levels.front() > 3300.0) continue;
    squares += square(levels.back() - levels.front());
    ++count;
  }
  ASSERT_GT(count, 60);
  EXPECT_NEAR(std::sqrt(squares / count), 50.0, 12.0);
}

TEST(Infrared, HasNoiseThatGrowsWithTheLevelAndRemembers) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.infrared = 30.0;
  hardware.noise.infrared_share = 0.1;
  hardware.noise.infrared_memory = 0.4;
  Sensed mouse(hardware);
  mouse.motion.position = {50.0, 350.0};
  mouse.motion.ahead = {1.0, 0.0};  // the west wall is to its left
  const auto readings = mouse.readings(20'000, [](const Sense& sense) { return double(sense.infrared[2]); });
  EXPECT_NEAR(mean_of(readings), 700.0, 10.0);
  EXPECT_NEAR(deviation_of(readings), 30.0 + 0.1 * 700.0, 3.0);
  EXPECT_NEAR(memory_of(readings), 0.4, 0.03);
}

TEST(Infrared, IsNeverBelowNothing) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.infrared = 30.0;
  Sensed mouse(hardware);
  for (int i = 0; i < 1000; ++i)
    for (const std::int16_t reading : mouse.read().infrared) ASSERT_GE(reading, 0);
}

TEST(Ranger, ReadsAnewOncePerPeriod) {
  Sensed mouse(test::plain_mouse());
  int news = 0;
  for (int tick = 0; tick < 1000; ++tick) news += mouse.read().ranges[0].is_new ? 1 : 0;
  EXPECT_EQ(news, 100);
}

TEST(Ranger, IsLessSureWhereTheMouseMoves) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.ranger_rest = 2.0;
  hardware.noise.ranger = 6.0;
  hardware.sensors.rangers[0].period = 1.0;
  for (const double speed : {0.0, 300.0}) {
    Sensed mouse(hardware);
    mouse.motion.position = {700.0, 350.0};
    mouse.motion.speed = mouse.motion.rolling = speed;
    const auto readings = mouse.readings(5000, [](const Sense& sense) { return double(sense.ranges[0].distance); });
    // The face of the east wall, less where the ranger sits.
    EXPECT_NEAR(mean_of(readings), 800.0 - test::cell / 30.0 - 720.0, 0.3);
    EXPECT_NEAR(deviation_of(readings), speed > 0.0 ? 6.0 : 2.0, 0.2);
  }
}

TEST(Ranger, SeesNothingBeyondItsReach) {
  Sensed mouse(test::plain_mouse());
  mouse.motion.position = {500.0, 350.0};
  EXPECT_EQ(mouse.read().ranges[0].distance, 0);
}

TEST(Encoders, WrapAsWideAsTheirCountersAre) {
  Hardware hardware = test::plain_mouse();
  hardware.sensors.count_bits = 16.0;
  Sensed mouse(hardware), wide(test::plain_mouse());
  mouse.motion.speed = mouse.motion.rolling = wide.motion.speed = wide.motion.rolling = 200.0;
  for (int tick = 0; tick < 500; ++tick)
    EXPECT_EQ(mouse.read().counts[0], static_cast<std::int16_t>(wide.read().counts[0])) << tick;
  EXPECT_GT(wide.read().counts[0], 40'000);
}

TEST(Senses, OfSensorsThatItLacksAreNothing) {
  Hardware hardware = test::varied_mouse();
  hardware.sensors.gyro_step = hardware.sensors.acceleration_step = 0.0;
  hardware.sensors.infrared.pop_back();
  hardware.sensors.rangers.clear();
  Sensed mouse(hardware);
  mouse.motion.yaw = 3.0;
  mouse.motion.sideways = 1000.0;
  const Sense sense = mouse.read();
  EXPECT_EQ(sense.gyro, 0);
  EXPECT_EQ(sense.acceleration, (std::array<std::int16_t, 2>{}));
  EXPECT_EQ(sense.all_infrared().size(), 3U);
  EXPECT_TRUE(sense.all_ranges().empty());
}

/// Of two groups, each is read every second millisecond.
TEST(Infrared, IsReadGroupByGroup) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.infrared = 50.0;
  for (const std::size_t left : {2U, 3U}) hardware.sensors.infrared[left].group = 1.0;
  Sensed mouse(hardware);
  mouse.motion.position = {50.0, 350.0};
  Sense last = mouse.read();
  std::array<int, 4> news{};
  for (int i = 0; i < 100; ++i) {
    const Sense now = mouse.read();
    for (const std::size_t sensor : {0U, 1U, 2U, 3U}) {
      const bool lit = now.tick % 2 == (sensor < 2 ? 0U : 1U);
      if (!lit) {
        EXPECT_EQ(now.infrared[sensor], last.infrared[sensor]) << now.tick;
      }
      news[sensor] += now.infrared[sensor] != last.infrared[sensor] ? 1 : 0;
    }
    last = now;
  }
  EXPECT_GT(news[0], 30);
  EXPECT_GT(news[2], 30);
}

TEST(Infrared, IsReadAsLateAsItsLatency) {
  Hardware hardware = test::plain_mouse(), late = hardware;
  for (Infrared& sensor : late.sensors.infrared) sensor.latency = 3.0;
  Sensed now(hardware), then(late);
  std::vector<std::int16_t> readings;
  for (int tick = 0; tick < 50; ++tick) {
    now.motion.position = then.motion.position = {40.0 + 0.3 * tick, 350.0};
    now.motion.ahead = then.motion.ahead = {1.0, 0.0};
    readings.push_back(now.read().infrared[2]);
    const std::int16_t read = then.read().infrared[2];
    if (tick >= 3) {
      EXPECT_EQ(read, readings[static_cast<std::size_t>(tick - 3)]) << tick;
    }
  }
  EXPECT_NE(readings.front(), readings.back());
}

/// Where a mouse was put down, its sensors have read for a while: late ones do not show where it was before.
TEST(Infrared, IsOfWhereTheMouseWasPutDown) {
  Hardware late = test::plain_mouse();
  for (Infrared& sensor : late.sensors.infrared) sensor.latency = 60.0;
  for (const std::size_t left : {2U, 3U}) late.sensors.infrared[left].group = 1.0;
  Sensed now(test::plain_mouse()), then(late);
  for (const double x : {350.0, 40.0}) {
    now.motion.position = then.motion.position = {x, 350.0};
    now.motion.ahead = then.motion.ahead = {1.0, 0.0};
    now.calibrate();
    then.calibrate();
    EXPECT_EQ(then.read().infrared, now.read().infrared) << x;
  }
  EXPECT_GT(now.read().infrared[2], 100);
}

TEST(Battery, IsReadInMillivolts) {
  const Maze maze = test::hall(4);
  const Hardware hardware = test::plain_mouse();
  const Field field(maze, test::cell);
  const RobotSample robot_sample(hardware, {}, maze.size(), 1);
  Senses senses(field, hardware, robot_sample, 1);
  BodyMotion motion;
  motion.position = {150.0, 150.0};
  senses.read(motion, 0.9);
  EXPECT_EQ(senses.sense().millivolts, 3600);
}

/// The noise of each source by itself, all from one seed: by its name, its values in a row.
std::vector<std::pair<std::string, std::vector<double>>> noise_by_source() {
  std::vector<std::pair<std::string, std::vector<double>>> sources;
  const auto add = [&](const std::string& name, const std::function<void(Noise&)>& make, const Direction& ahead,
                       const std::function<double(const Sense&)>& number) {
    Hardware hardware = test::plain_mouse();
    hardware.sensors.rangers[0].period = 1.0;
    make(hardware.noise);
    Sensed mouse(hardware, {}, 23);
    mouse.motion.position = {50.0, 350.0};
    mouse.motion.ahead = ahead;
    sources.emplace_back(name, mouse.readings(2000, number));
  };
  constexpr Direction north = {1.0, 0.0}, south = {-1.0, 0.0}, west = {0.0, -1.0};
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    add(
        "encoder", [](Noise& noise) { noise.encoder = 0.05; }, north,
        [i](const Sense& sense) { return double(sense.counts[i]); });
    add(
        "acceleration", [](Noise& noise) { noise.acceleration = 400.0; }, north,
        [i](const Sense& sense) { return double(sense.acceleration[i]); });
  }
  add(
      "gyro", [](Noise& noise) { noise.gyro = 0.1; }, north, [](const Sense& sense) { return double(sense.gyro); });
  double before = 0.0;
  add(
      "bias of the gyro", [](Noise& noise) { noise.gyro_walk = 3.0; }, north,
      [&](const Sense& sense) { return double(sense.gyro) - std::exchange(before, double(sense.gyro)); });
  // Each beam where it sees the west wall.
  const std::array<Direction, 4> ways = {south, west, north, west};
  for (std::size_t beam = 0; beam < ways.size(); ++beam)
    add(
        "infrared", [](Noise& noise) { noise.infrared = 30.0; }, ways[beam],
        [beam](const Sense& sense) { return double(sense.infrared[beam]); });
  add(
      "ranger", [](Noise& noise) { noise.ranger_rest = 5.0; }, west,
      [](const Sense& sense) { return double(sense.ranges[0].distance); });
  return sources;
}

double correlation_of(const std::vector<double>& a, const std::vector<double>& b) {
  const double mean_a = mean_of(a), mean_b = mean_of(b);
  double products = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) products += (a[i] - mean_a) * (b[i] - mean_b);
  return products / static_cast<double>(a.size()) / deviation_of(a) / deviation_of(b);
}

TEST(Noise, IsAnotherOfEachSource) {
  const auto sources = noise_by_source();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    EXPECT_GT(deviation_of(sources[i].second), 0.5) << sources[i].first << " has none";
    // Of two thousand numbers that have nothing to do with each other it is 0.022 in the mean.
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_LT(std::abs(correlation_of(sources[i].second, sources[j].second)), 0.1)
          << sources[i].first << " " << i << ", " << sources[j].first << " " << j;
  }
}

/// All that a mouse reads at rest before a wall, over some ticks, with a calibration.
std::vector<Sense> readings_with(const ErrorScale& level) {
  Sensed mouse(test::varied_mouse(), level, 17);
  mouse.motion.position = {50.0, 350.0};
  mouse.motion.ahead = {0.0, -1.0};
  mouse.motion.speed = mouse.motion.rolling = 100.0;
  mouse.motion.yaw = 0.5;
  mouse.motion.speeding = 300.0;
  mouse.calibrate();
  std::vector<Sense> all;
  for (int i = 0; i < 100; ++i) all.push_back(mouse.read());
  return all;
}

template <class Part>
bool same(const std::vector<Sense>& a, const std::vector<Sense>& b, Part part) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (part(a[i]) != part(b[i])) return false;
  return true;
}

TEST(Streams, OneSourceOffShiftsNoOther) {
  const std::vector<Sense> all = readings_with({});
  for (std::size_t i = 0; i < error_causes; ++i) {
    const auto group = static_cast<ErrorCause>(i);
    const std::vector<Sense> without = readings_with(test::all_but(group));
    const auto expect = [&](ErrorCause of, auto part) {
      const bool light = group == ErrorCause::reflectance || group == ErrorCause::ambient;
      const bool matters = of == group || (of == ErrorCause::infrared && light);
      EXPECT_EQ(same(all, without, part), !matters) << name_of(of) << " without " << name_of(group);
    };
    expect(ErrorCause::encoders, [](const Sense& sense) { return sense.counts; });
    expect(ErrorCause::gyro, [](const Sense& sense) { return sense.gyro; });
    expect(ErrorCause::accelerometer, [](const Sense& sense) { return sense.acceleration; });
    expect(ErrorCause::infrared, [](const Sense& sense) { return sense.infrared; });
    expect(ErrorCause::ranger, [](const Sense& sense) { return sense.ranges[0].distance; });
  }
}

TEST(Streams, NoiseIsAsStrongAsItsLevelSays) {
  Hardware hardware = test::plain_mouse();
  hardware.noise.gyro = 0.02;
  ErrorScale level;
  level.noise = 2.0;
  level.causes[static_cast<std::size_t>(ErrorCause::gyro)] = 3.0;
  Sensed mouse(hardware, level);
  EXPECT_NEAR(deviation_of(mouse.readings(20'000, [](const Sense& sense) { return sense.gyro * 0.001; })), 0.12, 0.003);
}

}  // namespace
}  // namespace labmouse
