#include "labmouse/mouse/distance.hpp"

#include <gtest/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/bench/plain_distance.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

constexpr DistanceField::Path both_paths[] = {DistanceField::Path::widest, DistanceField::Path::portable};

CellSet one(Cell cell) {
  CellSet cells;
  cells.insert(cell);
  return cells;
}

/// The distances as a person draws them: the northernmost row first, two columns a cell, `--` where none leads.
std::string drawing_of(const DistanceField& field) {
  std::string text;
  for (int y = field.size().height - 1; y >= 0; --y) {
    for (int x = 0; x < field.size().width; ++x) {
      const std::string number = field.reaches({x, y}) ? std::to_string(field.at({x, y})) : "--";
      text += std::string(x > 0 ? 3 - number.size() : 2 - number.size(), ' ') + number;
    }
    text += '\n';
  }
  return text;
}

std::string flooded(Size size, const WallSet& passages, const CellSet& from, const Motion& motion) {
  DistanceField field(size, motion);
  field.fill(passages, from);
  return drawing_of(field);
}

/// The distances in cells over the walls of a maze that all goals belong to.
std::string flood(const Maze& maze) { return flooded(maze.size(), maze.open_walls(), maze.goals(), strides(1)); }

TEST(PrintedDistances, TheFirstFloodOfAnEmptyMapOfTwelve) {
  // As printed: a line for each column of the maze, from the west; in it the cells from the south. Goal at (5,6).
  constexpr int printed[12][12] = {{11, 10, 9, 8, 7, 6, 5, 6, 7, 8, 9, 10}, {10, 9, 8, 7, 6, 5, 4, 5, 6, 7, 8, 9},
                                   {9, 8, 7, 6, 5, 4, 3, 4, 5, 6, 7, 8},    {8, 7, 6, 5, 4, 3, 2, 3, 4, 5, 6, 7},
                                   {7, 6, 5, 4, 3, 2, 1, 2, 3, 4, 5, 6},    {6, 5, 4, 3, 2, 1, 0, 1, 2, 3, 4, 5},
                                   {7, 6, 5, 4, 3, 2, 1, 2, 3, 4, 5, 6},    {8, 7, 6, 5, 4, 3, 2, 3, 4, 5, 6, 7},
                                   {9, 8, 7, 6, 5, 4, 3, 4, 5, 6, 7, 8},    {10, 9, 8, 7, 6, 5, 4, 5, 6, 7, 8, 9},
                                   {11, 10, 9, 8, 7, 6, 5, 6, 7, 8, 9, 10}, {12, 11, 10, 9, 8, 7, 6, 7, 8, 9, 10, 11}};
  DistanceField field({12, 12}, strides(1));
  field.fill(WallSet::all({12, 12}), one({5, 6}));
  for (int x = 0; x < 12; ++x)
    for (int y = 0; y < 12; ++y) EXPECT_EQ(field.at({x, y}), printed[x][y]) << x << ',' << y;
}

TEST(PrintedDistances, AMapOfFourOnceItIsKnown) {
  EXPECT_EQ(flood(test::drawn(R"(
    o---o---o---o---o
    |               |
    o   o   o   o   o
    |   |           |
    o   o---o   o   o
    |       | G     |
    o   o---o   o   o
    | S |           |
    o---o---o---o---o
  )")),
            " 4  3  2  3\n"
            " 5  2  1  2\n"
            " 6  7  0  1\n"
            " 7  2  1  2\n");
}

TEST(PrintedDistances, AMapOfFourWithWhatWasNotVisitedBlockedOut) {
  EXPECT_EQ(flood(test::drawn(R"(
    o---o---o---o---o
    |           |   |
    o   o---o   o---o
    |   |   |   |   |
    o   o---o   o---o
    |   |   | G |   |
    o   o---o---o---o
    | S |   |   |   |
    o---o---o---o---o
  )")),
            " 4  3  2 --\n"
            " 5 --  1 --\n"
            " 6 --  0 --\n"
            " 7 -- -- --\n");
}

TEST(Distance, AStrideCoversThreeCellsOfACorridor) {
  const Maze maze = test::drawn(R"(
    o---o---o---o---o---o---o---o---o
    | G                             |
    o---o---o---o---o---o---o---o---o
  )");
  EXPECT_EQ(flooded(maze.size(), maze.open_walls(), maze.goals(), strides(3)), " 0  1  1  1  2  2  2  3\n");
}

TEST(Distance, AStrideMayEndWithinASlowerOnesWay) {
  const Maze maze = test::drawn(R"(
    o---o---o---o---o
    |               |
    o   o---o---o   o
    | G |       |   |
    o---o   o   o---o
    |               |
    o---o---o---o---o
  )");
  EXPECT_EQ(flooded(maze.size(), maze.open_walls(), maze.goals(), strides(3)),
            " 1  2  2  2\n"
            " 0 -- --  3\n"
            "-- -- -- --\n");
}

TEST(Distance, DearMovesAreWeighed) {
  // One cell costs 2, two cost 3: three cells are one of each.
  Motion motion;
  motion.longest = 2;
  motion.cost = {0, 2, 3};
  EXPECT_EQ(flooded({6, 1}, WallSet::all({6, 1}), one({0, 0}), motion), " 0  2  3  5  6  8\n");
}

TEST(Distance, NothingIsReachedFromNowhere) {
  for (const auto path : both_paths) {
    DistanceField field({7, 7}, strides(3), path);
    field.fill(WallSet::all({7, 7}), CellSet());
    for (int index = 0; index < 49; ++index) EXPECT_FALSE(field.reaches(Size{7, 7}.cell_at(index)));
  }
}

TEST(Distance, CellsOutsideAreUnreachable) {
  DistanceField field({7, 5}, strides(3));
  field.fill(WallSet::all({7, 5}), CellSet::all({7, 5}));
  for (const Cell outside : {Cell{-1, 0}, Cell{0, -1}, Cell{7, 0}, Cell{0, 5}})
    EXPECT_EQ(field.at(outside), unreachable);
}

TEST(Distance, TheLongestWayThatFitsIsCounted) {
  // A snake through all cells of 64×64: 4095 moves of one cell.
  MazeDraft draft({64, 64}, MazeDraft::Inside::closed);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 63; ++x) draft.open({x, y}, Heading::east);
    if (y < 63) draft.open({y % 2 == 0 ? 63 : 0, y}, Heading::north);
  }
  for (const auto path : both_paths)
    for (const int cost : {1, Motion::max_cost}) {
      Motion motion = strides(1);
      motion.cost[1] = static_cast<std::uint8_t>(cost);
      DistanceField field({64, 64}, motion, path);
      field.fill(draft.open_walls(), one({0, 0}));
      EXPECT_EQ(field.at({0, 63}), 4095 * cost);
    }
}

/// Sizes about the widths of rows, and others.
Size random_size(Rng& rng) {
  constexpr int sides[] = {1, 2, 7, 8, 15, 16, 17, 31, 32, 33, 63, 64};
  const auto side = [&] { return rng.chance(1, 2) ? sides[rng.below(std::size(sides))] : 1 + rng.below(64); };
  const int width = side();
  return {width, side()};
}

WallSet random_passages(Size size, Rng& rng) {
  if (rng.chance(1, 3)) return depth_first_generator.make({size, rng.bits(), rng.below(300)}).open_walls();
  WallSet passages;
  const int share = rng.below(9);
  WallSet::all(size).for_each([&](Wall wall) {
    if (rng.chance(share, 8)) passages.insert(wall);
  });
  return passages;
}

CellSet random_cells(Size size, Rng& rng) {
  CellSet cells;
  for (int count = rng.chance(1, 10) ? 0 : 1 + rng.below(5); count > 0; --count)
    cells.insert(size.cell_at(rng.below(size.area())));
  return cells;
}

/// Costs that do not fall; sometimes dear.
Motion random_costs(Rng& rng) {
  Motion motion;
  motion.longest = 1 + rng.below(Motion::max_longest);
  int cost = 1 + rng.below(5);
  for (std::size_t cells = 1; cells <= static_cast<std::size_t>(motion.longest); ++cells) {
    motion.cost[cells] = static_cast<std::uint8_t>(cost);
    cost = std::min(Motion::max_cost, cost + rng.below(rng.chance(1, 4) ? 20 : 4));
  }
  return motion;
}

/// A few thousand fields in all against the queue; one object of each path is filled several times.
void agree_with_the_queue(Rng& rng, const Motion& motion, int rounds) {
  const Size size = random_size(rng);
  DistanceField wide(size, motion), portable(size, motion, DistanceField::Path::portable);
  for (int round = 0; round < rounds; ++round) {
    const WallSet passages = random_passages(size, rng);
    const CellSet from = random_cells(size, rng);
    const std::vector<int> plain = plain_distances(size, motion, passages, from);
    std::vector<int> distances(plain.size());
    for (DistanceField* field : {&wide, &portable}) {
      field->fill(passages, from);
      field->copy_to(distances);
      ASSERT_EQ(distances, plain) << size.width << "x" << size.height << ", longest " << motion.longest;
      for (int index = 0; index < size.area(); ++index)
        ASSERT_EQ(field->at(size.cell_at(index)), plain[static_cast<std::size_t>(index)]);
    }
  }
}

class DistanceInStrides : public testing::TestWithParam<int> {};

TEST_P(DistanceInStrides, AgreesWithAPlainQueue) {
  Rng rng(seed_for(1, "strides", static_cast<std::uint64_t>(GetParam())));
  for (int i = 0; i < test::tenth(80); ++i) ASSERT_NO_FATAL_FAILURE(agree_with_the_queue(rng, strides(GetParam()), 3));
}

INSTANTIATE_TEST_SUITE_P(OfEachLength, DistanceInStrides, testing::Range(1, Motion::max_longest + 1));

TEST(Distance, AgreesWithAPlainQueueForAnyCosts) {
  Rng rng(17);
  for (int i = 0; i < test::tenth(250); ++i) ASSERT_NO_FATAL_FAILURE(agree_with_the_queue(rng, random_costs(rng), 3));
}

TEST(Distance, TheRingThatSpeedIsMeasuredAgainstAgreesToo) {
  Rng rng(23);
  for (int i = 0; i < 100; ++i) {
    const Size size = random_size(rng);
    const int longest = 1 + rng.below(4);
    const WallSet passages = random_passages(size, rng);
    const CellSet from = random_cells(size, rng);
    ASSERT_EQ(RingSearch(size, longest, passages).fill(from), plain_distances(size, strides(longest), passages, from));
  }
}

}  // namespace
}  // namespace labmouse
