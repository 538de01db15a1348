#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "labmouse/maze/contest_rules.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/maze/routes.hpp"
#include "tests/maze/problem_lines.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

constexpr std::array perfect_generators = {&depth_first_generator, &prim_generator, &kruskal_generator,
                                           &wilson_generator, &division_generator};
constexpr std::array<Size, 9> sizes = {Size{1, 1}, {1, 2},   {1, 64},  {64, 1}, {2, 2},
                                       {3, 7},     {12, 12}, {33, 20}, {64, 64}};

std::string drawing_of(const Maze& maze) { return drawing_format.write(maze).content.value_or("(not drawn)"); }

// FNV-1a over the drawing.
std::uint64_t hash_of(const Maze& maze) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char letter : drawing_of(maze)) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001B3U;
  return hash;
}

TEST(Generators, AreFoundByTheirNames) {
  std::vector<std::string_view> names;
  for (const Generator* generator : all_generators()) {
    names.push_back(generator->name);
    EXPECT_EQ(find_generator(generator->name), generator);
    EXPECT_FALSE(generator->summary.empty());
  }
  EXPECT_THAT(names, testing::ElementsAre("depth-first", "prim", "kruskal", "wilson", "division", "empty", "contest"));
  EXPECT_EQ(find_generator("maze"), nullptr);
}

TEST(Generators, RefuseWhatIsOutOfRange) {
  for (const Generator* generator : all_generators()) {
    EXPECT_NE(generator->refuses({{0, 16}, 1, 0}), "") << generator->name;
    EXPECT_NE(generator->refuses({{16, 65}, 1, 0}), "") << generator->name;
    EXPECT_NE(generator->refuses({{16, 16}, 1, -1}), "") << generator->name;
    EXPECT_NE(generator->refuses({{16, 16}, 1, 1001}), "") << generator->name;
    EXPECT_EQ(generator->refuses({{16, 16}, 1, 1000}), "") << generator->name;
  }
}

TEST(Generators, MakePerfectMazesOfEverySize) {
  for (const Generator* generator : perfect_generators)
    for (const Size size : sizes)
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        ASSERT_EQ(generator->refuses({size, seed, 0}), "");
        const Maze maze = generator->make({size, seed, 0});
        EXPECT_EQ(maze.size(), size);
        EXPECT_EQ(maze.open_walls().count(), size.area() - 1) << generator->name << " " << seed;
        EXPECT_EQ(reachable_cells(maze).count(), size.area()) << generator->name << " " << seed;
      }
}

TEST(Generators, DependOnTheSeed) {
  for (const Generator* generator : perfect_generators) {
    EXPECT_EQ(generator->make({{16, 16}, 5, 30}), generator->make({{16, 16}, 5, 30}));
    EXPECT_NE(generator->make({{16, 16}, 5, 30}), generator->make({{16, 16}, 6, 30}));
  }
  EXPECT_NE(contest_generator.make({{16, 16}, 5, 0}), contest_generator.make({{16, 16}, 6, 0}));
}

TEST(Generators, OpenTheShareOfWallsThatIsAskedFor) {
  const int inner = WallSet::all({20, 10}).count();
  for (const Generator* generator : perfect_generators) {
    const auto open = [&](int loops) { return generator->make({{20, 10}, 3, loops}).open_walls().count(); };
    const int standing = inner - open(0);
    EXPECT_EQ(standing, 171);
    EXPECT_EQ(open(3) - open(0), 1);  // 0.513 is nearest to one wall
    EXPECT_EQ(open(500) - open(0), 86);
    EXPECT_EQ(open(1000), inner);
  }
}

TEST(Generators, ALargerShareOpensTheSameWallsAndMore) {
  for (const Generator* generator : all_generators()) {
    WallSet few = generator->make({{16, 16}, 9, 50}).open_walls();
    few -= generator->make({{16, 16}, 9, 100}).open_walls();
    EXPECT_TRUE(few.empty()) << generator->name;
  }
}

TEST(Generators, EmptyHasNoInnerWall) {
  for (const Size size : sizes) EXPECT_EQ(empty_generator.make({size, 1, 0}).open_walls(), WallSet::all(size));
}

// On 2×2 cells there are four perfect mazes; Wilson makes each as often as the others.
TEST(Generators, WilsonMakesEveryMazeEquallyOften) {
  constexpr int mazes = 4000;
  std::array<int, 4> closed{};
  for (std::uint64_t seed = 0; seed < mazes; ++seed) {
    const Maze maze = wilson_generator.make({{2, 2}, seed, 0});
    const std::array sides = {maze.is_open({0, 0}, Heading::north), maze.is_open({0, 0}, Heading::east),
                              maze.is_open({1, 1}, Heading::south), maze.is_open({1, 1}, Heading::west)};
    for (std::size_t side = 0; side < sides.size(); ++side) closed[side] += sides[side] ? 0 : 1;
  }
  for (const int times : closed) EXPECT_NEAR(times, mazes / 4, 110);  // four standard deviations
}

TEST(Contest, RefusesOtherSizes) {
  EXPECT_THAT(std::string(contest_generator.refuses({{13, 13}, 1, 0})), testing::HasSubstr("12x12 to 62x62"));
  EXPECT_NE(contest_generator.refuses({{10, 10}, 1, 0}), "");
  EXPECT_NE(contest_generator.refuses({{64, 64}, 1, 0}), "");
  EXPECT_NE(contest_generator.refuses({{16, 32}, 1, 0}), "");
  EXPECT_EQ(contest_generator.refuses({{32, 32}, 1, 0}), "");
}

void expect_contest_mazes(Size size, int seeds, int loops) {
  for (int seed = 0; seed < seeds; ++seed) {
    const Maze maze = contest_generator.make({size, static_cast<std::uint64_t>(seed), loops});
    const bool official = size.width == 16 || size.width == 32;
    for (const RuleFinding& rule : check_contest_rules(maze))
      EXPECT_TRUE(rule.passed || (rule.name == "size" && !official))
          << "seed " << seed << ": " << rule.name << ": " << rule.reason;
    EXPECT_EQ(reachable_cells(maze).count(), size.area()) << "seed " << seed;
    EXPECT_EQ(maze.start(), Cell(0, 0));
    EXPECT_TRUE(maze.is_open({0, 0}, Heading::north));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Contest, KeepsTheRulesOn16) { expect_contest_mazes({16, 16}, test::tenth(200), 0); }
TEST(Contest, KeepsTheRulesOn32) { expect_contest_mazes({32, 32}, test::tenth(60), 0); }
TEST(Contest, KeepsAllRulesButTheSizeOnOtherSquares) {
  LABMOUSE_SKIP_SANITIZED();
  for (int side = 12; side <= 30; side += 2)
    expect_contest_mazes({side, side}, test::some_of(40), side % 4 == 0 ? 0 : 50);
  expect_contest_mazes({62, 62}, 2, 0);
}
TEST(Contest, KeepsTheRulesWithMoreLoops) {
  expect_contest_mazes({16, 16}, test::tenth(40), 100);
  expect_contest_mazes({16, 16}, test::tenth(20), 1000);
}

TEST(Golden, Drawings) {
  EXPECT_EQ(drawing_of(depth_first_generator.make({{6, 4}, 1, 0})), test::content_of(R"(
o---o---o---o---o---o---o
|           |           |
o---o   o---o   o   o---o
|       | G   G |       |
o   o---o   o---o---o   o
|         G | G     |   |
o---o---o---o   o   o   o
| S             |       |
o---o---o---o---o---o---o
)"));
  EXPECT_EQ(drawing_of(prim_generator.make({{6, 4}, 1, 0})), test::content_of(R"(
o---o---o---o---o---o---o
|       |   |           |
o---o   o   o   o---o---o
|         G   G         |
o---o---o---o   o---o---o
|   |     G | G         |
o   o---o   o   o---o   o
| S                 |   |
o---o---o---o---o---o---o
)"));
  EXPECT_EQ(drawing_of(kruskal_generator.make({{6, 4}, 1, 0})), test::content_of(R"(
o---o---o---o---o---o---o
|                   |   |
o---o   o---o   o   o   o
|       | G   G |   |   |
o---o---o   o---o   o   o
|         G   G |       |
o---o   o---o   o---o   o
| S     |           |   |
o---o---o---o---o---o---o
)"));
  EXPECT_EQ(drawing_of(wilson_generator.make({{6, 4}, 1, 0})), test::content_of(R"(
o---o---o---o---o---o---o
|   |                   |
o   o   o---o---o   o   o
|       | G | G     |   |
o---o   o   o   o---o   o
|   |   | G | G     |   |
o   o   o   o---o   o   o
| S         |       |   |
o---o---o---o---o---o---o
)"));
  EXPECT_EQ(drawing_of(division_generator.make({{6, 4}, 1, 0})), test::content_of(R"(
o---o---o---o---o---o---o
|   |       |           |
o   o---o   o---o   o---o
|         G   G         |
o---o   o---o   o---o   o
|   |   | G | G     |   |
o   o   o   o---o   o   o
| S         |       |   |
o---o---o---o---o---o---o
)"));
}

// The same bits on every compiler and platform; a change here changes every generated maze.
TEST(Golden, Hashes) {
  EXPECT_EQ(hash_of(depth_first_generator.make({{32, 32}, 7, 50})), 0x14CF644AE25B959BU);
  EXPECT_EQ(hash_of(prim_generator.make({{32, 32}, 7, 50})), 0xF9FA716A2BD3AE42U);
  EXPECT_EQ(hash_of(kruskal_generator.make({{32, 32}, 7, 50})), 0x3B8FE20A68A3E1B2U);
  EXPECT_EQ(hash_of(wilson_generator.make({{32, 32}, 7, 50})), 0x306D09FD54E44C4AU);
  EXPECT_EQ(hash_of(division_generator.make({{32, 32}, 7, 50})), 0xEE3CB2DD84E01E23U);
  EXPECT_EQ(hash_of(empty_generator.make({{32, 32}, 7, 50})), 0xFAFE0E4C26DABD87U);
  EXPECT_EQ(hash_of(contest_generator.make({{32, 32}, 7, 50})), 0x9FC67C38621E3796U);
}

}  // namespace
}  // namespace labmouse
