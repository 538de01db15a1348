#include "labmouse/mouse/wall_contexts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/grid/wall_set.hpp"
#include "labmouse/maze/symmetry.hpp"

namespace labmouse {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAreArray;

constexpr Wall north_of(int x, int y) { return {{x, y}, Heading::north}; }
constexpr Wall east_of(int x, int y) { return {{x, y}, Heading::east}; }

/// A context from its digits, that of neighbour 0 first.
int context(std::string_view digits) {
  int number = 0;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) number = 3 * number + (*digit - '0');
  return number;
}

//              o   7   o
//              2       5
//          0   o-------o   3
//              1       4
//              o   6   o
TEST(NeighboursOfAWall, AreThoseOfThePicture) {
  EXPECT_THAT(neighbours_of(north_of(5, 5)), ElementsAre(north_of(4, 5), east_of(4, 5), east_of(4, 6), north_of(6, 5),
                                                         east_of(5, 5), east_of(5, 6), north_of(5, 4), north_of(5, 6)));
}

TEST(NeighboursOfAWall, ThatRunsUpwardsAreThoseWithXAndYExchanged) {
  EXPECT_THAT(neighbours_of(east_of(5, 5)), ElementsAre(east_of(5, 4), north_of(5, 4), north_of(6, 4), east_of(5, 6),
                                                        north_of(5, 5), north_of(6, 5), east_of(4, 5), east_of(6, 5)));
}

TEST(FoldedContext, IsTheSameOfMirrorImages) {
  const int one = context("10200012");
  for (const char* image : {"00010212", "12000021", "00012021"})
    EXPECT_EQ(folded_context(context(image)), folded_context(one)) << image;
  EXPECT_NE(folded_context(context("10200021")), folded_context(one));
  EXPECT_NE(folded_context(context("01200012")), folded_context(one));
}

TEST(FoldedContext, IsOneOfTheClassOfFour) {
  std::map<int, int> sizes;
  for (int number = 0; number < wall_contexts; ++number) {
    const int folded = folded_context(number);
    EXPECT_LE(folded, number);
    EXPECT_EQ(folded_context(folded), folded);
    ++sizes[folded];
  }
  // As many as Burnside's lemma counts: the four mirrors leave 3^8, 3^5, 3^5 and 3^4 contexts as they are.
  EXPECT_EQ(sizes.size(), (6561U + 243U + 243U + 81U) / 4U);
  for (const auto& [folded, size] : sizes) EXPECT_TRUE(size == 1 || size == 2 || size == 4) << folded;
}

/// What is known of walls, written to be read: the context of any of them from scratch.
struct Known {
  Size size;
  std::map<Wall, int> digits;  ///< of the inner walls that are known

  int digit(Wall wall) const {
    const bool inner = size.contains(wall.cell) && size.contains(neighbour(wall.cell, wall.side));
    if (!inner) return 2;
    const auto found = digits.find(wall);
    return found == digits.end() ? 0 : found->second;
  }
  int context(Wall wall) const {
    int number = 0, weight = 1;
    for (const Wall other : neighbours_of(wall)) {
      number += weight * digit(other);
      weight *= 3;
    }
    return number;
  }
};

std::vector<Wall> inner_walls(Size size) {
  std::vector<Wall> walls;
  WallSet::all(size).for_each([&](Wall wall) { walls.push_back(wall); });
  return walls;
}

void expect_agreement(const WallContexts& contexts, const Known& known) {
  for (const Wall wall : inner_walls(known.size))
    ASSERT_EQ(contexts.of(wall), known.context(wall)) << wall.cell.x << ',' << wall.cell.y << name_of(wall.side);
}

class Contexts : public testing::TestWithParam<Size> {};

TEST_P(Contexts, KeepUpWithWhatBecomesKnown) {
  const Size size = GetParam();
  Rng rng(7);
  WallContexts contexts(size);
  Known known{size, {}};
  expect_agreement(contexts, known);
  std::vector<Wall> unknown = inner_walls(size);
  const std::size_t some = std::max<std::size_t>(1, unknown.size() / 8);
  while (!unknown.empty()) {
    std::swap(unknown.back(), unknown[static_cast<std::size_t>(rng.below(static_cast<int>(unknown.size())))]);
    const bool open = rng.chance(1, 2);
    contexts.learn(unknown.back(), open, [](Wall) {});
    known.digits[unknown.back()] = open ? 1 : 2;
    unknown.pop_back();
    if (unknown.size() % some == 0) expect_agreement(contexts, known);
  }
}

TEST_P(Contexts, TellWhichChange) {
  const Size size = GetParam();
  WallContexts contexts(size);
  for (const Wall wall : inner_walls(size)) {
    std::vector<Wall> told, inner;
    contexts.learn(wall, true, [&](Wall other) { told.push_back(other); });
    for (const Wall other : neighbours_of(wall))
      if (!on_border(other, size)) inner.push_back(other);
    ASSERT_THAT(told, UnorderedElementsAreArray(inner));
  }
}

TEST_P(Contexts, AreTheSameFromEverySide) {
  const Size size = GetParam();
  for (const Symmetry symmetry : all_symmetries) {
    Rng rng(11);
    const Size other_size = transformed(size, symmetry);
    const auto image = [&](Wall wall) {
      return wall_at(transformed(wall.cell, size, symmetry), transformed(wall.side, symmetry));
    };
    WallContexts contexts(size), images(other_size);
    for (const Wall wall : inner_walls(size)) {
      if (rng.chance(1, 2)) continue;
      const bool open = rng.chance(1, 2);
      contexts.learn(wall, open, [](Wall) {});
      images.learn(image(wall), open, [](Wall) {});
    }
    for (const Wall wall : inner_walls(size))
      ASSERT_EQ(folded_context(contexts.of(wall)), folded_context(images.of(image(wall))));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Contexts,
                         testing::Values(Size{1, 1}, Size{1, 7}, Size{7, 1}, Size{2, 2}, Size{3, 5}, Size{16, 16},
                                         Size{1, 64}, Size{64, 1}, Size{64, 64}),
                         [](const auto& tested) {
                           return std::to_string(tested.param.width) + "x" + std::to_string(tested.param.height);
                         });

TEST(ContextsAtTheBorder, HaveItClosedFromTheBeginning) {
  // North of (0,0) in two rows of three cells: on its left, and below and above it, is nothing but border.
  EXPECT_EQ(WallContexts({3, 2}).of(north_of(0, 0)), context("22200022"));
  // In a row of cells both parallel walls are inner ones, and all six at the posts are not.
  EXPECT_EQ(WallContexts({4, 1}).of(east_of(1, 0)), context("22222200"));
  EXPECT_EQ(WallContexts({4, 1}).of(east_of(0, 0)), context("22222220"));
}

TEST(WallContexts, AreThoseOfKnowledge) {
  const Size size = {6, 5};
  Rng rng(1);
  Knowledge knowledge(size, 1);
  WallContexts contexts(size);
  WallSet::all(size).for_each([&](Wall wall) {
    if (rng.chance(1, 2)) return;
    const bool open = rng.chance(1, 2);
    knowledge.learn(wall, open);
    contexts.learn(wall, open, [](Wall) {});
  });
  WallSet::all(size).for_each([&](Wall wall) { EXPECT_EQ(context_of(wall, knowledge), contexts.of(wall)); });
}

}  // namespace
}  // namespace labmouse
