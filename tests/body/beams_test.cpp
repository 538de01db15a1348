// Infrared beams and the ranger against plain sums over walls and posts.
#include "labmouse/body/beams.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "tests/body/boxes.hpp"
#include "tests/body/plain_mouse.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

using test::Boxes;
using test::half_wall;

/// The length of a ray to the first box, and the cosine of its incidence there.
struct Hit {
  double distance = 1e9, cosine = 1.0;
};
Hit hit_of(const Boxes& boxes, const Position& from, double cosine, double sine) {
  Hit hit;
  for (const Boxes::Box& box : boxes.all()) {
    const double x = ((cosine > 0.0 ? box.west : box.east) - from.x) / cosine;
    const double y = ((sine > 0.0 ? box.south : box.north) - from.y) / sine;
    const double x_out = ((cosine > 0.0 ? box.east : box.west) - from.x) / cosine;
    const double y_out = ((sine > 0.0 ? box.north : box.south) - from.y) / sine;
    const double in = std::max(x, y);
    if (in < 0.0 || in > std::min(x_out, y_out) || in >= hit.distance) continue;
    hit = {in, std::abs(x > y ? cosine : sine)};
  }
  return hit;
}

/// As the method says: line after line, the spot that lies on it in shares, by a sum over its places.
double level_by_sums(const Boxes& boxes, const Maze& maze, const Infrared& infrared, const Position& from,
                     double cosine, double sine, double gain) {
  struct Crossing {
    double distance, incidence;
    int line;
    bool upright;
  };
  std::vector<Crossing> crossings;
  for (int line = 0; line <= maze.size().width; ++line)
    crossings.push_back({(line * test::cell + (cosine > 0.0 ? -half_wall : half_wall) - from.x) / cosine,
                         std::abs(cosine), line, true});
  for (int line = 0; line <= maze.size().height; ++line)
    crossings.push_back(
        {(line * test::cell + (sine > 0.0 ? -half_wall : half_wall) - from.y) / sine, std::abs(sine), line, false});
  std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  double level = 0.0, passing = 1.0;
  for (const Crossing& crossing : crossings) {
    if (crossing.distance < 0.0) continue;
    const double middle = crossing.upright ? from.y + crossing.distance * sine : from.x + crossing.distance * cosine;
    const double deviation = infrared.footprint / crossing.incidence;
    double share = 0.0, all = 0.0;
    for (int i = -2000; i <= 2000; ++i) {
      const double off = i * 0.0025;
      const double weight = std::exp(-off * off / 2.0);
      all += weight;
      if (boxes.covers(crossing.line, middle + off * deviation, crossing.upright)) share += weight;
    }
    share /= all;
    const double slant = crossing.incidence < 0.9 ? crossing.incidence / 0.9 : 1.0;
    level += passing * share * gain * std::exp(-crossing.distance / infrared.fall) * slant;
    passing *= 1.0 - share;
  }
  return std::min(level, infrared.most);
}

/// As light goes: many parallel rays, each to the first box that it meets.
double level_by_rays(const Boxes& boxes, const Infrared& infrared, const Position& from, double cosine, double sine,
                     double gain) {
  double level = 0.0, all = 0.0;
  for (int i = -100; i <= 100; ++i) {
    const double off = i * 0.04, weight = std::exp(-off * off / 2.0), aside = off * infrared.footprint;
    const Hit hit = hit_of(boxes, {from.x - aside * sine, from.y + aside * cosine}, cosine, sine);
    const double slant = hit.cosine < 0.9 ? hit.cosine / 0.9 : 1.0;
    all += weight;
    level += weight * gain * std::exp(-hit.distance / infrared.fall) * slant;
  }
  return std::min(level / all, infrared.most);
}

/// A beam of a mouse somewhere in a maze, and what a sensor there reads.
struct Look {
  Position from;
  double cosine, sine;
  double gain;  ///< at no distance
  double level;
};

class InSomeMazes : public testing::Test {
 protected:
  template <class Visit>
  void for_each_look(int count, Visit visit) {
    const Hardware hardware = test::plain_mouse();
    Rng rng(5);
    const auto share = [&] { return rng.below(1 << 20) / static_cast<double>(1 << 20); };
    for (int i = 0; i < count; ++i) {
      const Maze maze = test::some_maze(static_cast<std::uint64_t>(i));
      const Field field(maze, test::cell);
      const RobotSample robot_sample(hardware, {}, maze.size(), 1);
      const Beams beams(field, hardware.sensors, robot_sample);
      const Boxes boxes(maze);
      for (int j = 0; j < 40; ++j) {
        // A mouse within 15 mm of the middle of a cell does not stand in walls.
        const Position at = {(rng.below(8) + 0.35 + 0.3 * share()) * test::cell,
                             (rng.below(8) + 0.35 + 0.3 * share()) * test::cell};
        const double angle = 2.0 * pi * share();
        const std::size_t beam = static_cast<std::size_t>(rng.below(4));
        const Infrared& infrared = hardware.sensors.infrared[beam];
        const Beam& mounted = infrared.beam;
        const double c = std::cos(angle), s = std::sin(angle);
        Look look;
        look.from = {at.x + mounted.ahead * c - mounted.aside * s, at.y + mounted.ahead * s + mounted.aside * c};
        if (boxes.inside(look.from)) continue;
        look.cosine = std::cos(angle + mounted.angle);
        look.sine = std::sin(angle + mounted.angle);
        // By the gain at the calibrated distance: to a side wall 50 mm from the middle, less half of it.
        const double out = std::abs(std::sin(mounted.angle)), on = std::cos(mounted.angle);
        const double calibrated = beam % 2 == 0 ? (test::cell / 2.0 - half_wall - std::abs(mounted.aside)) / out
                                                : (test::cell / 2.0 - half_wall - mounted.ahead) / on;
        look.gain = infrared.gain * std::exp(calibrated / infrared.fall);
        look.level = beams.level(beam, at, direction_of(angle));
        visit(maze, boxes, infrared, look);
      }
    }
  }
};

TEST_F(InSomeMazes, ABeamReadsTheSumOverWhatItsSpotLiesOn) {
  int read = 0;
  for_each_look(40, [&](const Maze& maze, const Boxes& boxes, const Infrared& infrared, const Look& look) {
    const double expected = level_by_sums(boxes, maze, infrared, look.from, look.cosine, look.sine, look.gain);
    // What a beam leaves out is below half a count or behind 98 % of it.
    ASSERT_NEAR(look.level, expected, 0.6 + 0.008 * expected)
        << "at " << look.from.x << " " << look.from.y << " towards " << look.cosine << " " << look.sine;
    read += look.level > 30.0 ? 1 : 0;
  });
  EXPECT_GT(read, 500);
}

/// A bundle of rays meets boxes, not lines: sides of posts, and walls at a slant nearer on one side of the spot.
TEST_F(InSomeMazes, ABeamReadsAboutWhatABundleOfRaysBringsBack) {
  std::vector<double> off;
  for_each_look(100, [&](const Maze&, const Boxes& boxes, const Infrared& infrared, const Look& look) {
    // Not where both agree that nothing is seen, nor where the sensor is blinded.
    const double expected = level_by_rays(boxes, infrared, look.from, look.cosine, look.sine, look.gain);
    if (expected > 30.0 && expected < 3000.0) off.push_back(std::abs(look.level / expected - 1.0));
  });
  ASSERT_GT(off.size(), 1000U);
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() / 2], 0.03);
  EXPECT_LT(off[off.size() * 8 / 10], 0.15);
}

TEST(Beams, ReadTheirGainInTheMiddleOfACorridor) {
  const Maze maze = test::drawn(R"(
    o---o---o
    |       |
    o   o   o
    | S   G |
    o---o---o
  )");
  Hardware hardware = test::plain_mouse();
  for (Infrared& sensor : hardware.sensors.infrared) sensor.footprint = 0.5;  // all of it on the wall
  const Field field(maze, test::cell);
  const RobotSample robot_sample(hardware, {}, maze.size(), 1);
  const Beams beams(field, hardware.sensors, robot_sample);
  const Position middle = {50.0, 50.0};
  const Direction north{1.0, 0.0}, south{-1.0, 0.0}, west{0.0, -1.0};
  // Towards the west wall, by the left sensor of a mouse that drives north, and the right one of one that drives south.
  EXPECT_NEAR(beams.level(2, middle, north), 700.0, 0.1);
  EXPECT_NEAR(beams.level(0, middle, south), 700.0, 0.1);
  EXPECT_NEAR(beams.level(1, middle, west), 700.0, 0.1);
  EXPECT_NEAR(beams.level(3, middle, west), 700.0, 0.1);
  // 13 mm nearer at a right angle a wall reads e times as much.
  const double across = std::sin(1.15);
  EXPECT_NEAR(beams.level(2, {50.0 - 13.0 * across, 50.0}, north), 700.0 * std::exp(1.0), 1.0);
}

TEST(Beams, ReadNoMoreThanTheirMost) {
  const Maze maze = test::hall(2);
  const Hardware hardware = test::plain_mouse();
  const Field field(maze, test::cell);
  const RobotSample robot_sample(hardware, {}, maze.size(), 1);
  const Beams beams(field, hardware.sensors, robot_sample);
  EXPECT_EQ(beams.level(1, {28.0, 50.0}, {0.0, -1.0}), 3600.0);
}

TEST(Beams, ReadWallsAsTheirSidesReflect) {
  Hardware hardware = test::plain_mouse();
  hardware.variation.reflectance = 0.3;
  hardware.variation.infrared_gain = 0.2;
  for (Infrared& sensor : hardware.sensors.infrared) sensor.footprint = 0.5;
  const Maze maze = test::hall(4);
  const Field field(maze, test::cell);
  const RobotSample robot_sample(hardware, {}, maze.size(), 7);
  const Beams beams(field, hardware.sensors, robot_sample);
  for (int y = 0; y < 4; ++y) {
    const double expected = 700.0 * robot_sample.infrared[2] * robot_sample.reflectance({0, y}, Heading::west);
    EXPECT_NEAR(beams.level(2, {50.0, y * test::cell + 50.0}, {1.0, 0.0}), expected, 0.1) << y;
  }
}

TEST(Ranger, ReadsTheDistanceToTheFirstBoxAhead) {
  const Hardware hardware = test::plain_mouse();
  Rng rng(9);
  int seen = 0;
  for (int i = 0; i < 40; ++i) {
    const Maze maze = test::some_maze(static_cast<std::uint64_t>(i));
    const Field field(maze, test::cell);
    const RobotSample robot_sample(hardware, {}, maze.size(), 1);
    const Beams beams(field, hardware.sensors, robot_sample);
    const Boxes boxes(maze);
    for (int j = 0; j < 40; ++j) {
      const Position at = {(rng.below(8) + 0.4 + 0.002 * rng.below(100)) * test::cell,
                           (rng.below(8) + 0.4 + 0.002 * rng.below(100)) * test::cell};
      const double angle = 0.001 + 0.006 * rng.below(1000);
      const double c = std::cos(angle), s = std::sin(angle);
      const Position from = {at.x + 20.0 * c, at.y + 20.0 * s};
      if (boxes.inside(from)) continue;
      const double expected = hit_of(boxes, from, c, s).distance;
      ASSERT_NEAR(beams.range(0, at, direction_of(angle)), expected > 250.0 ? 0.0 : expected, 1e-6)
          << "at " << at.x << " " << at.y << " towards " << angle;
      seen += expected <= 250.0 ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 1000);
}

TEST(Ranger, LooksInItsDirection) {
  Hardware hardware = test::plain_mouse();
  hardware.sensors.rangers.push_back({{5.0, 10.0, pi / 2.0}, 250.0, 10.0});
  const Maze maze = test::hall(2);
  const Field field(maze, test::cell);
  const RobotSample robot_sample(hardware, {}, maze.size(), 1);
  const Beams beams(field, hardware.sensors, robot_sample);
  // North of it are 200 mm less half a wall; so far is the sensor on its left side.
  EXPECT_NEAR(beams.range(1, {90.0, 60.0}, {0.0, 1.0}), 200.0 - half_wall - 60.0 - 10.0, 1e-9);
}

/// Of a wall twice as far away, a quarter of the light comes back.
TEST(Infrared, MayFallWithTheSquareOfTheDistance) {
  Hardware hardware = test::plain_mouse();
  const Beam left = {0.0, 10.0, pi / 2.0};
  hardware.sensors.infrared = {{left, 400.0, 0.0, 30000.0, 0.5}};
  const Maze maze = test::hall(4);
  const Field field(maze, test::cell);
  const RobotSample robot_sample(hardware, {}, maze.size(), 1);
  const Beams beams(field, hardware.sensors, robot_sample);
  const double usual = test::cell / 2.0 - half_wall - 10.0;
  for (const double distance : {usual / 2.0, usual, 2.0 * usual, 3.0 * usual})
    EXPECT_NEAR(beams.level(0, {150.0, 400.0 - half_wall - 10.0 - distance}, {0.0, 1.0}),
                400.0 * square(usual / distance), 1e-6);
}

/// Posts that are all off by as much are a maze that is moved.
TEST(Shifts, MoveWallsAndPosts) {
  const Hardware hardware = test::plain_mouse();
  const Maze maze = test::some_maze(3);
  const Position shift = {1.5, -1.0};
  const Field field(maze, test::cell), moved(maze, test::cell, std::vector<Position>(9 * 9, shift));
  const RobotSample robot_sample(hardware, {}, maze.size(), 1);
  const Beams beams(field, hardware.sensors, robot_sample), moved_beams(moved, hardware.sensors, robot_sample);
  Rng rng(4);
  int near = 0;
  constexpr int times = 500, sensors = 4;
  for (int i = 0; i < times; ++i) {
    const Position at = {(rng.below(8) + 0.4 + 0.002 * rng.below(100)) * test::cell,
                         (rng.below(8) + 0.4 + 0.002 * rng.below(100)) * test::cell};
    const Direction ahead = direction_of(pi / 2.0 * rng.below(4) + 0.002 * rng.below(100));
    near += std::abs(moved_beams.range(0, at + shift, ahead) - beams.range(0, at, ahead)) < 0.4 ? 1 : 0;
    for (std::size_t beam = 0; beam < std::size_t{sensors}; ++beam) {
      // Where the ray is oblique, the place on the line is that of the wall that is not moved.
      const double level = moved_beams.level(beam, at + shift, ahead), usual = beams.level(beam, at, ahead);
      near += std::abs(level - usual) < 5.0 + 0.1 * usual ? 1 : 0;
    }
  }
  EXPECT_GT(near, 0.95 * times * (sensors + 1));
}

/// A wall stands between its posts, so in its middle it is off by their mean.
TEST(Shifts, OfAWallAreThoseBetweenItsPosts) {
  const Hardware hardware = test::plain_mouse();
  const Maze maze = test::hall(2);
  std::vector<Position> shifts(9);
  shifts[0] = {2.0, 0.0};  // the south-western post
  const Field field(maze, test::cell, shifts);
  const RobotSample robot_sample(hardware, {}, maze.size(), 1);
  const Beams beams(field, hardware.sensors, robot_sample);
  const Direction west = {0.0, -1.0};
  const double usual = 90.0 - 20.0 - half_wall_of(test::cell);
  EXPECT_NEAR(beams.range(0, {90.0, 50.0}, west), usual - 1.0, 1e-9);
  EXPECT_NEAR(beams.range(0, {90.0, 25.0}, west), usual - 1.5, 1e-9);
  EXPECT_NEAR(beams.range(0, {90.0, 150.0}, west), usual, 1e-9);
}

}  // namespace
}  // namespace labmouse
