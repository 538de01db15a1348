// What a chassis touches, against a plain look at each of its points.
#include "labmouse/body/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "labmouse/chance/rng.hpp"
#include "tests/body/boxes.hpp"
#include "tests/body/plain_mouse.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

/// Whether a point of the chassis, looked at each half mm, lies in a box; `grown` makes it larger all round, or cuts
/// its sides off.
bool overlaps(const test::Boxes& boxes, const Chassis& chassis, const Position& at, double angle, double grown) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double front = chassis.front + grown, back = chassis.back + grown, side = chassis.half_width + grown;
  const test::Boxes some = boxes.near(at, front + back + side);
  const auto steps = [](double length) { return static_cast<int>(std::ceil(length / 0.5)); };
  const int along = steps(front + back), across = steps(2.0 * side);
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j) {
      const double x = -back + (front + back) * i / along, y = -side + 2.0 * side * j / across;
      const double radius = chassis.rounding + std::max(0.0, grown);
      const double beyond_x = std::max({0.0, x - front + radius, radius - back - x});
      const double beyond_y = std::max(0.0, std::abs(y) - side + radius);
      if (beyond_x * beyond_x + beyond_y * beyond_y > radius * radius) continue;
      if (some.inside({at.x + x * c - y * s, at.y + x * s + y * c})) return true;
    }
  return false;
}

Position out_of(const Contact& contact) {
  constexpr Position ways[] = {{0.0, 1.0}, {1.0, 0.0}, {0.0, -1.0}, {-1.0, 0.0}};
  return ways[static_cast<unsigned>(contact.out)];
}

class AContact : public ::testing::TestWithParam<double> {};

TEST_P(AContact, IsWhereAPointOfTheChassisLiesInAWallOrAPost) {
  Chassis chassis = test::plain_mouse().chassis;
  chassis.rounding = GetParam();
  Rng rng(3);
  const auto share = [&] { return rng.below(1 << 20) / static_cast<double>(1 << 20); };
  int touching = 0, free = 0;
  for (int i = 0; i < 4; ++i) {
    const Maze maze = test::some_maze(static_cast<std::uint64_t>(i));
    const Field field(maze, test::cell);
    const test::Boxes boxes(maze);
    for (int j = 0; j < 500; ++j) {
      const Position at = {(0.3 + 7.4 * share()) * test::cell, (0.3 + 7.4 * share()) * test::cell};
      const double angle = 2.0 * pi * share();
      // No deeper than a tick leads.
      if (overlaps(boxes, chassis, at, angle, -4.0)) continue;
      const bool touches = contact_of(field, chassis, at, direction_of(angle)).has_value();
      // Looked at each half mm, boxes that come less far into the chassis may be missed.
      if (overlaps(boxes, chassis, at, angle, -0.4)) {
        ASSERT_TRUE(touches) << at.x << " " << at.y << " " << angle;
        ++touching;
      } else if (!overlaps(boxes, chassis, at, angle, 0.4)) {
        ASSERT_FALSE(touches) << at.x << " " << at.y << " " << angle;
        ++free;
      }
    }
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(free, 400);
}

INSTANTIATE_TEST_SUITE_P(WithCornersOf, AContact, ::testing::Values(0.0, 6.0, 18.0));

TEST(Contact, LiesAsDeepAsItIsToGoOut) {
  const Chassis chassis = test::plain_mouse().chassis;
  const Maze maze = test::hall(4);
  const Field field(maze, test::cell);
  for (const double deep : {0.1, 1.0, 2.5}) {
    // Its front 25 mm ahead, against each of the border's walls.
    const double face = test::half_wall + 25.0 - deep;
    struct Against {
      Position at;
      double angle;
      Heading out;
    };
    for (const Against& it :
         {Against{{face, 150.0}, pi, Heading::east}, Against{{150.0, face}, -pi / 2.0, Heading::north},
          Against{{400.0 - face, 150.0}, 0.0, Heading::west},
          Against{{150.0, 400.0 - face}, pi / 2.0, Heading::south}}) {
      const auto contact = contact_of(field, chassis, it.at, direction_of(it.angle));
      ASSERT_TRUE(contact);
      EXPECT_EQ(contact->out, it.out);
      EXPECT_NEAR(contact->depth, deep, 1e-9);
      ASSERT_TRUE(contact->wall);
      EXPECT_TRUE(on_border(*contact->wall, maze.size()));
      const Position out = out_of(*contact);
      const Position clear = {it.at.x + (deep + 1e-9) * out.x, it.at.y + (deep + 1e-9) * out.y};
      EXPECT_FALSE(contact_of(field, chassis, clear, direction_of(it.angle)));
    }
  }
}

TEST(Contact, OfARoundMouseIsAsDeepAsItsCircle) {
  Chassis chassis = test::plain_mouse().chassis;
  chassis.front = chassis.back = chassis.half_width = chassis.rounding = 20.0;
  const Maze maze = test::hall(4);
  const Field field(maze, test::cell);
  const Position corner = Position{200.0, 200.0} + Position{test::half_wall, test::half_wall};
  for (int turn = 0; turn < 24; ++turn) {
    const Direction ahead = direction_of(turn * pi / 12.0);
    for (const double deep : {-1.0, -1e-6, 1e-6, 1.0}) {
      const double away = (20.0 - deep) / std::sqrt(2.0);
      const auto contact = contact_of(field, chassis, corner + Position{away, away}, ahead);
      ASSERT_EQ(contact.has_value(), deep > 0.0) << turn << " " << deep;
      if (!contact) continue;
      EXPECT_NEAR(contact->depth, deep, 1e-9);
      EXPECT_FALSE(contact->wall);
    }
    const double face = test::half_wall + 20.0;
    EXPECT_FALSE(contact_of(field, chassis, {face + 1e-6, 150.0}, ahead));
    EXPECT_NEAR(contact_of(field, chassis, {face - 1.0, 150.0}, ahead)->depth, 1.0, 1e-9);
  }
}

TEST(Contact, NamesTheWall) {
  const Maze maze = test::drawn(R"(
    o---o---o
    |       |
    o   o---o
    | S | G |
    o---o---o
  )");
  const Field field(maze, test::cell);
  const Chassis chassis = test::plain_mouse().chassis;
  const auto wall = [&](const Position& at) { return contact_of(field, chassis, at, {1.0, 0.0})->wall; };
  EXPECT_EQ(wall({80.0, 45.0}), wall_at({0, 0}, Heading::east));
  EXPECT_EQ(wall({120.0, 45.0}), wall_at({0, 0}, Heading::east));
  EXPECT_EQ(wall({150.0, 73.0}), wall_at({1, 0}, Heading::north));
  EXPECT_EQ(wall({150.0, 116.0}), wall_at({1, 0}, Heading::north));
}

TEST(Contact, WithALonePostHasNoWall) {
  const Maze maze = test::hall(4);
  const Field field(maze, test::cell);
  const auto contact = contact_of(field, test::plain_mouse().chassis, {180.5, 195.0}, {1.0, 0.0});
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->wall, std::nullopt);
  EXPECT_EQ(contact->out, Heading::west);
}

/// A chassis that is longer than a cell is touched by every wall and post that it covers, not by the nearest alone.
TEST(Contact, IsFoundForLongMiceToo) {
  Chassis chassis = test::plain_mouse().chassis;
  chassis.front = chassis.back = 90.0;
  const Maze maze = test::hall(4);
  const Field field(maze, test::cell);
  EXPECT_TRUE(contact_of(field, chassis, {92.0, 150.0}, {0.0, 1.0}));
  EXPECT_FALSE(contact_of(field, chassis, {150.0, 150.0}, {0.0, 1.0}));
  EXPECT_TRUE(contact_of(field, chassis, {220.0, 180.0}, {0.0, 1.0})) << "posts at 200 and 300, 200";
}

/// Posts that are all off by as much are a maze that is moved.
TEST(Contact, IsWithWallsAndPostsWhereTheyStand) {
  const Chassis chassis = test::plain_mouse().chassis;
  const Position shift = {1.5, -1.0};
  const Maze maze = test::some_maze(5);
  const Field field(maze, test::cell), moved(maze, test::cell, std::vector<Position>(9 * 9, shift));
  Rng rng(6);
  int touching = 0, same = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto share = [&] { return rng.below(1 << 20) / static_cast<double>(1 << 20); };
    const Position at = {(0.3 + 7.4 * share()) * test::cell, (0.3 + 7.4 * share()) * test::cell};
    const Direction ahead = direction_of(2.0 * pi * share());
    const auto usual = contact_of(field, chassis, at, ahead), there = contact_of(moved, chassis, at + shift, ahead);
    if (!usual && !there) continue;
    ++touching;
    // A corner may lie beside another wall of its line than before.
    same += usual && there && usual->out == there->out && std::abs(usual->depth - there->depth) < 1e-6 ? 1 : 0;
  }
  EXPECT_GT(touching, 300);
  EXPECT_GT(same, 0.95 * touching);
}

}  // namespace
}  // namespace labmouse
