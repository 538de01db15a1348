#include "labmouse/mouse/priced_field.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "tests/mouse/plain_priced_field.hpp"

namespace labmouse {
namespace {

using test::plain_costs;
using test::PricedWorld;

constexpr int step_price = 30;

/// All walls of a maze at one price.
WallPrices all_at(Size size, int price) {
  WallPrices prices(size);
  WallSet::all(size).for_each([&](Wall wall) { prices.set(wall, price); });
  return prices;
}

std::vector<int> costs_of(const PricedField& field, Size size) {
  std::vector<int> costs;
  for (int index = 0; index < size.area(); ++index) costs.push_back(field.at(size.cell_at(index)));
  return costs;
}

TEST(PricedField, CountsStepsWhereNothingHasAPrice) {
  PricedField field({7, 1}, strides(3), step_price);
  field.fill(all_at({7, 1}, 0), CellSet::of({0, 0}));
  EXPECT_EQ(costs_of(field, {7, 1}), (std::vector{0, 30, 30, 30, 60, 60, 60}));
}

TEST(PricedField, AddsThePriceOfEachWallThatAMoveCrosses) {
  PricedField field({5, 1}, strides(3), step_price);
  WallPrices prices = all_at({5, 1}, 0);
  prices.set(wall_at({1, 0}, Heading::east), 7);
  prices.set(wall_at({2, 0}, Heading::east), 100);
  field.fill(prices, CellSet::of({0, 0}));
  EXPECT_EQ(costs_of(field, {5, 1}), (std::vector{0, 30, 37, 137, 167}));
}

TEST(PricedField, GoesRoundADearWallAndNeverThroughAClosedOne) {
  //   4  5  6
  //   0 |1| 2      | closed, the walls between the rows are free
  PricedField field({3, 2}, strides(1), step_price);
  WallPrices prices = all_at({3, 2}, 0);
  prices.set(wall_at({0, 0}, Heading::east), WallPrices::closed);
  prices.set(wall_at({1, 0}, Heading::east), 61);
  field.fill(prices, CellSet::of({0, 0}));
  EXPECT_EQ(costs_of(field, {3, 2}), (std::vector{0, 90, 120, 30, 60, 90}));
}

TEST(PricedField, AClosedWallOfAllIsUnreachable) {
  PricedField field({4, 3}, strides(3), step_price);
  field.fill(WallPrices({4, 3}), CellSet::of({1, 1}));
  for (int index = 0; index < 12; ++index) EXPECT_EQ(field.at_index(index), index == 5 ? 0 : unreachable);
}

TEST(PricedField, HoldsTheDearestSnakeThatFits) {
  const Size size = {64, 64};
  WallPrices prices(size);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 63; ++x) prices.set({{x, y}, Heading::east}, WallPrices::highest);
    if (y < 63) prices.set({{y % 2 == 0 ? 63 : 0, y}, Heading::north}, WallPrices::highest);
  }
  Motion motion = strides(1);
  motion.cost[1] = Motion::max_cost;
  PricedField field(size, motion, step_price);
  field.fill(prices, CellSet::of({0, 0}));
  EXPECT_EQ(field.at({0, 63}), 4095 * (Motion::max_cost * step_price + WallPrices::highest));
}

TEST(PricedField, ReachesNothingAtTheLimit) {
  PricedField field({7, 1}, strides(3), step_price);
  field.fill_below(60, all_at({7, 1}, 0), CellSet::of({0, 0}));
  EXPECT_EQ(costs_of(field, {7, 1}), (std::vector{0, 30, 30, 30, unreachable, unreachable, unreachable}));
}

/// A random world, and how it changes.
class RandomWorld {
 public:
  RandomWorld(Size size, std::uint64_t seed) : size_(size), rng_(seed), motion_(throw_motion()), prices_(size) {
    closed_ = rng_.below(9);
    dearest_ = pick({0, 1, 40, WallPrices::highest});
    WallSet::all(size_).for_each([&](Wall wall) { prices_.set(wall, any_price()); });
    for (int count = pick({0, 1, 1, 1, 2, 5}); count > 0; --count)
      from_.insert(size_.cell_at(rng_.below(size_.area())));
  }

  Size size() const { return size_; }
  const Motion& motion() const { return motion_; }
  const WallPrices& prices() const { return prices_; }
  const CellSet& from() const { return from_; }
  std::vector<int> plain() const {
    return plain_costs({size_, motion_, step_price, [&](Wall wall) { return prices_.of(wall); }}, from_);
  }

  int below(int count) { return rng_.below(count); }

 private:
  int pick(std::initializer_list<int> of) { return of.begin()[rng_.below(static_cast<int>(of.size()))]; }

  Motion throw_motion() {
    if (rng_.chance(1, 2)) return strides(pick({1, 3}));
    Motion motion;
    motion.longest = 1 + rng_.below(Motion::max_longest);
    int cost = 1 + rng_.below(5);
    for (std::size_t cells = 1; cells <= static_cast<std::size_t>(motion.longest); ++cells) {
      motion.cost[cells] = static_cast<std::uint8_t>(cost);
      cost = std::min(Motion::max_cost, cost + rng_.below(pick({4, 20})));
    }
    return motion;
  }

  int any_price() { return rng_.chance(closed_, 8) ? WallPrices::closed : rng_.below(dearest_ + 1); }

  Size size_;
  Rng rng_;
  Motion motion_;
  WallPrices prices_;
  CellSet from_;
  int closed_ = 0, dearest_ = 0;
};

/// Both sides 1 to 64; small ones as often as all others.
RandomWorld any_world() {
  const auto side = rc::gen::resize(
      rc::kNominalSize, rc::gen::weightedOneOf<int>({{1, rc::gen::inRange(1, 9)}, {1, rc::gen::inRange(1, 65)}}));
  const int width = *side, height = *side;
  return RandomWorld({width, height}, *rc::gen::arbitrary<std::uint64_t>());
}

RC_GTEST_PROP(PricedField, AgreesWithAPlainQueue, ()) {
  const RandomWorld world = any_world();
  PricedField field(world.size(), world.motion(), step_price);
  field.fill(world.prices(), world.from());
  RC_ASSERT(costs_of(field, world.size()) == world.plain());
}

RC_GTEST_PROP(PricedField, AgreesBelowALimit, ()) {
  RandomWorld world = any_world();
  const int limit = 1 + world.below(4000);
  PricedField field(world.size(), world.motion(), step_price);
  field.fill_below(limit, world.prices(), world.from());
  const std::vector<int> costs = costs_of(field, world.size()), plain = world.plain();
  for (std::size_t i = 0; i < plain.size(); ++i) RC_ASSERT(costs[i] == (plain[i] < limit ? plain[i] : unreachable));
}

RC_GTEST_PROP(PricedField, AgreesWhereTheRestStaysBelowALimit, ()) {
  RandomWorld world = any_world();
  const int limit = 1 + world.below(4000);
  const CellSet start = CellSet::of(world.size().cell_at(world.below(world.size().area())));
  PricedField rest(world.size(), world.motion(), step_price), field = rest.sibling(), whole = rest.sibling();
  rest.fill(world.prices(), world.from());
  whole.fill(world.prices(), start);
  field.fill_below(limit, rest, world.prices(), start);
  for (int i = 0; i < world.size().area(); ++i) {
    const bool within = whole.at_index(i) + rest.at_index(i) < limit;
    if (within) RC_ASSERT(field.at_index(i) == whole.at_index(i));
    if (!within) RC_ASSERT(field.at_index(i) >= whole.at_index(i));
  }
}

}  // namespace
}  // namespace labmouse
