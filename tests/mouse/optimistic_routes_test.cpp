#include "labmouse/mouse/optimistic_routes.hpp"

#include <gtest/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/mouse/plain_priced_field.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

Briefing three_by_two() {
  Briefing briefing;
  briefing.size = {3, 2};
  briefing.goals.insert({2, 1});
  return briefing;
}

TEST(OptimisticRoutes, TakeEveryWallForOpenThatIsNotKnownToBeClosed) {
  OptimisticRoutes routes(three_by_two());
  Knowledge knowledge({3, 2});
  routes.plan(knowledge);
  EXPECT_EQ(routes.length(), 2);
  // North and then two east, or two east and then north: all walls but the one in the middle.
  WallSet walls = WallSet::all({3, 2});
  walls.erase(wall_at({1, 0}, Heading::north));
  EXPECT_EQ(routes.unknown_walls(), walls);
}

TEST(OptimisticRoutes, LeaveOutWhatIsKnown) {
  OptimisticRoutes routes(three_by_two());
  Knowledge knowledge({3, 2});
  ASSERT_TRUE(knowledge.learn({{0, 0}, Heading::north}, {0, 1, 0}));
  routes.plan(knowledge);
  EXPECT_EQ(routes.length(), 2);
  WallSet walls;
  for (const Cell cell : {Cell{0, 1}, Cell{1, 1}}) walls.insert(wall_at(cell, Heading::east));
  EXPECT_EQ(routes.unknown_walls(), walls);
}

TEST(OptimisticRoutes, AreNoneWhereTheStartIsClosedIn) {
  OptimisticRoutes routes(three_by_two());
  Knowledge knowledge({3, 2});
  ASSERT_TRUE(knowledge.learn({{0, 0}, Heading::north}, {0, 0, 0}));
  routes.plan(knowledge);
  EXPECT_EQ(routes.length(), unreachable);
  EXPECT_TRUE(routes.unknown_walls().empty());
}

/// Routes by their definition: a move is on a shortest one where the ways before and after it and the move itself add
/// up.
struct PlainRoutes {
  int length = unreachable;
  WallSet unknown_walls;

  PlainRoutes(const Briefing& briefing, const Knowledge& knowledge) {
    const test::PricedWorld world = {briefing.size, briefing.motion, 1, [&](Wall wall) {
                                       return knowledge.state(wall) == WallState::closed ? int{WallPrices::closed} : 0;
                                     }};
    const std::vector<int> from_start = test::plain_costs(world, CellSet::of(briefing.start.cell));
    const std::vector<int> to_goal = test::plain_costs(world, briefing.goals);
    length = to_goal[static_cast<std::size_t>(briefing.size.index(briefing.start.cell))];
    if (length == unreachable) return;
    for (int s = 0; s < briefing.size.area(); ++s)
      test::for_each_move(world, briefing.size.cell_at(s), [&](Cell to, int cost, const std::vector<Wall>& walls) {
        const int rest = to_goal[static_cast<std::size_t>(briefing.size.index(to))];
        if (from_start[static_cast<std::size_t>(s)] + cost + rest != length) return;
        for (const Wall wall : walls)
          if (knowledge.state(wall) == WallState::unknown) unknown_walls.insert(wall);
      });
  }
};

Motion any_motion(Rng& rng) {
  if (rng.chance(2, 3)) return strides(1 + rng.below(4));
  Motion motion = strides(1 + rng.below(5));
  int cost = 0;
  for (std::size_t cells = 1; cells <= static_cast<std::size_t>(motion.longest); ++cells)
    motion.cost[cells] = static_cast<std::uint8_t>(cost += cells == 1 ? 1 + rng.below(5) : rng.below(4));
  return motion;
}

/// Shows a mouse that can be anywhere some readings of a maze, and compares after each.
void agree_with_the_definition(Rng& rng) {
  const Size size = {1 + rng.below(20), 1 + rng.below(20)};
  const Generator& generator = rng.chance(1, 2) ? depth_first_generator : prim_generator;
  const Maze maze = generator.make({size, rng.bits(), rng.below(500)});
  const auto any_cell = [&] { return size.cell_at(rng.below(size.area())); };
  Briefing briefing = brief(maze, {}, 1);
  briefing.motion = any_motion(rng);
  briefing.start.cell = any_cell();
  if (rng.chance(1, 2)) briefing.goals = CellSet::of(any_cell());
  Knowledge knowledge(size);
  OptimisticRoutes routes(briefing);
  for (int reading = 0; reading < 20; ++reading) {
    const Pose pose = {any_cell(), all_headings[static_cast<std::size_t>(rng.below(4))]};
    ASSERT_TRUE(knowledge.learn(pose, look(maze, pose)));
    routes.plan(knowledge);
    const PlainRoutes plain(briefing, knowledge);
    ASSERT_EQ(routes.length(), plain.length);
    ASSERT_EQ(routes.unknown_walls(), plain.unknown_walls);
  }
}

TEST(OptimisticRoutes, AgreeWithTheirDefinition) {
  Rng rng(31);
  for (int i = 0; i < test::tenth(200); ++i) ASSERT_NO_FATAL_FAILURE(agree_with_the_definition(rng)) << i;
}

}  // namespace
}  // namespace labmouse
