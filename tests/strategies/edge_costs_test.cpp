#include "labmouse/strategies/ariadne/edge_costs.hpp"

#include <gtest/gtest.h>

#include "labmouse/mouse/priors.hpp"
#include "tests/mouse/plain_priced_field.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/one_contest.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using ariadne::EdgeCosts;
using ariadne::Outlook;
using ariadne::PriceTable;
using ariadne::step_price;

/// The price of an unseen wall, alike for all.
PriceTable all_at(int price) {
  PriceTable table;
  table.fill(static_cast<std::uint8_t>(price));
  return table;
}

Briefing corridor_of(int cells, int goal, const Motion& motion) {
  Briefing briefing;
  briefing.size = {cells, 1};
  briefing.start = {{0, 0}, Heading::east};
  briefing.goals.insert({goal, 0});
  briefing.motion = motion;
  return briefing;
}

TEST(EdgeCosts, AreThoseOfTheCheapestRunThroughAWall) {
  const Briefing briefing = corridor_of(5, 4, strides(1));
  const PriceTable ten = all_at(10);
  Outlook outlook(briefing, nullptr);
  outlook.price(ten);
  EdgeCosts costs(briefing);
  costs.plan(outlook.prices(), 256);
  for (int x = 0; x < 4; ++x) EXPECT_EQ(costs.through(wall_at({x, 0}, Heading::east)), 160);
}

TEST(EdgeCosts, LeadThroughAWallBehindTheStartAndBack) {
  const Briefing briefing = [] {
    Briefing from_the_middle = corridor_of(5, 4, strides(1));
    from_the_middle.start.cell = {2, 0};
    return from_the_middle;
  }();
  const PriceTable free = all_at(0);
  Outlook outlook(briefing, nullptr);
  outlook.price(free);
  EdgeCosts costs(briefing);
  costs.plan(outlook.prices(), 256);
  // One cell west, and then three east.
  EXPECT_EQ(costs.through(wall_at({1, 0}, Heading::east)), 120);
  EXPECT_EQ(costs.through(wall_at({0, 0}, Heading::east)), 180);
}

TEST(EdgeCosts, RoundTheWeightedWayDown) {
  const Briefing briefing = corridor_of(5, 4, strides(1));
  const PriceTable free = all_at(0);
  Outlook outlook(briefing, nullptr);
  outlook.price(free);
  EdgeCosts costs(briefing);
  costs.plan(outlook.prices(), 33);
  // The ways of 0, 30, 60 and 90 weigh 0, 3.9, 7.7 and 11.6; or backwards through the wall, from the far side.
  EXPECT_EQ(costs.through(wall_at({0, 0}, Heading::east)), 120);
  EXPECT_EQ(costs.through(wall_at({1, 0}, Heading::east)), 90 + 3);
  EXPECT_EQ(costs.through(wall_at({2, 0}, Heading::east)), 60 + 7);
  EXPECT_EQ(costs.through(wall_at({3, 0}, Heading::east)), 30 + 11);
}

/// A mouse that learns a maze step by step, and what runs through unseen walls cost by the plain definition.
class Learner {
 public:
  Learner(const Maze& maze, const Motion& motion, Rng& rng)
      : briefing_(briefing(maze, motion)),
        prior_(any_prior(rng)),
        outlook_(briefing_, prior_),
        costs_(briefing_),
        knowledge_(maze.size()) {}

  void learn(const StepRecord& step) {
    ASSERT_TRUE(knowledge_.learn(step.pose, step.sighting));
    outlook_.learn(step.pose, step.sighting);
  }
  void price(const PriceTable& table) { outlook_.price(table); }

  void expect_plain_costs(int weight) {
    costs_.plan(outlook_.prices(), weight);
    const WallPrices& prices = outlook_.prices();
    const test::PricedWorld world = {briefing_.size, briefing_.motion, step_price,
                                     [&](Wall wall) { return prices.of(wall); }};
    const test::WallNumbers plain = test::plain_costs_through(world, briefing_.start.cell, briefing_.goals, weight);
    knowledge_.unknown().for_each([&](Wall wall) {
      if (!prices.passable(wall)) return;
      ASSERT_EQ(std::min(costs_.through(wall), unreachable), plain[wall])
          << (wall.side == Heading::north ? "north of " : "east of ") << int{wall.cell.x} << ',' << int{wall.cell.y};
    });
  }

  /// With a limit, what costs less than it is exact, and nothing else seems to cost less.
  void expect_plain_costs_below(int limit, int weight) {
    const WallPrices& prices = outlook_.prices();
    const test::PricedWorld world = {briefing_.size, briefing_.motion, step_price,
                                     [&](Wall wall) { return prices.of(wall); }};
    const auto expect = [&](const test::WallNumbers& plain, int exact_below) {
      knowledge_.unknown().for_each([&](Wall wall) {
        if (!prices.passable(wall)) return;
        const int cost = costs_.through(wall);
        if (plain[wall] < exact_below) {
          ASSERT_EQ(cost, plain[wall]);
        } else {
          ASSERT_GE(cost, std::min(exact_below, plain[wall]));
        }
      });
    };
    costs_.plan_below(limit, prices);
    ASSERT_NO_FATAL_FAILURE(
        expect(test::plain_costs_through(world, briefing_.start.cell, briefing_.goals, 256), limit));
    // Runs through cells that are left out cost at least the limit and a move.
    costs_.plan_near(limit, prices, weight);
    const int cheapest_move = step_price * briefing_.motion.cost[1];
    ASSERT_NO_FATAL_FAILURE(
        expect(test::plain_costs_through(world, briefing_.start.cell, briefing_.goals, weight), limit + cheapest_move));
  }

 private:
  static Briefing briefing(const Maze& maze, const Motion& motion) {
    Briefing briefing = brief(maze, {}, 1);
    briefing.motion = motion;
    return briefing;
  }
  static const WallPrior* any_prior(Rng& rng) {
    return rng.chance(1, 4) ? nullptr : rng.chance(1, 2) ? &contest_prior : &loop_free_prior;
  }

  Briefing briefing_;
  const WallPrior* prior_;
  Outlook outlook_;
  EdgeCosts costs_;
  Knowledge knowledge_;
};

/// Prices that rise with the reluctance, up to one from which a wall is taken for closed; sometimes none is.
PriceTable any_table(Rng& rng) {
  PriceTable table;
  const int base = rng.below(20), slope = rng.below(8), closed = rng.chance(1, 4) ? 256 : 1 + rng.below(200);
  for (int reluctance = 0; reluctance < 256; ++reluctance)
    table[static_cast<unsigned>(reluctance)] = static_cast<std::uint8_t>(
        reluctance >= closed ? WallPrices::closed : std::min(base + slope * reluctance / 4, WallPrices::highest));
  return table;
}

Motion any_motion(Rng& rng) {
  if (rng.chance(2, 3)) return strides(1 + rng.below(4));
  Motion motion = strides(2 + rng.below(4));
  int cost = 0;
  for (std::size_t cells = 1; cells <= static_cast<std::size_t>(motion.longest); ++cells)
    motion.cost[cells] = static_cast<std::uint8_t>(cost += cells == 1 ? 1 + rng.below(5) : rng.below(4));
  return motion;
}

void expect_plain_costs_while_learning(const Maze& maze, Rng& rng) {
  constexpr std::array mice = {&flood_return_mouse, &frontier_mouse, &random_move_mouse};
  constexpr std::array weights = {0, 33, 256};
  const RunRecord record = test::contest(*mice[static_cast<unsigned>(rng.below(3))], maze, {}, rng.bits());
  const PriceTable tables[] = {any_table(rng), any_table(rng)};
  Learner learner(maze, any_motion(rng), rng);
  learner.price(tables[0]);
  int weight = weights[static_cast<unsigned>(rng.below(3))];
  for (const StepRecord& step : record.steps) {
    if (step.step > 200) break;
    learner.learn(step);
    if (rng.chance(1, 10)) weight = weights[static_cast<unsigned>(rng.below(3))];
    if (rng.chance(1, 20)) learner.price(tables[rng.below(2)]);
    if (!rng.chance(1, 3)) continue;
    ASSERT_NO_FATAL_FAILURE(learner.expect_plain_costs(weight)) << "step " << step.step << test::drawing_of(maze);
    const int limit = 1 + rng.below(rng.chance(1, 2) ? 400 : 3000);
    ASSERT_NO_FATAL_FAILURE(learner.expect_plain_costs_below(limit, weight))
        << "step " << step.step << test::drawing_of(maze);
  }
}

TEST(EdgeCosts, AgreeWithThePlainDefinitionAsWallsBecomeKnown) {
  Rng rng(8);
  for (int i = 0; i < test::some_of(150); ++i)
    ASSERT_NO_FATAL_FAILURE(expect_plain_costs_while_learning(test::any_maze(rng, 14), rng)) << i;
}

TEST(EdgeCosts, AgreeInTheLargestMaze) {
  Rng rng(9);
  const Maze maze = kruskal_generator.make({{64, 64}, 1, 100});
  const RunRecord record = test::contest(flood_return_mouse, maze);
  Learner learner(maze, strides(3), rng);
  const PriceTable table = any_table(rng);
  learner.price(table);
  for (const StepRecord& step : record.steps) {
    learner.learn(step);
    if (step.step % 100 != 1) continue;
    ASSERT_NO_FATAL_FAILURE(learner.expect_plain_costs(step.step < 300 ? 0 : 256)) << step.step;
  }
}

}  // namespace
}  // namespace labmouse
