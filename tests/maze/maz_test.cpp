#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/maze/problem_lines.hpp"
#include "tests/maze/random_maze.hpp"

namespace labmouse {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr unsigned north = 1;
constexpr unsigned east = 2;
constexpr unsigned south = 4;
constexpr unsigned west = 8;

// A maz file of that side in which all walls stand.
std::string closed(int side) { return std::string(static_cast<std::size_t>(side * side), char{15}); }

void set(std::string& content, std::size_t position, unsigned walls) { content[position] = static_cast<char>(walls); }

TEST(Maz, HasOneByteOfWallsForEachCellColumnByColumn) {
  std::string content = closed(16);
  set(content, 0, east | south | west);    // (0,0), open to the north
  set(content, 1, north | west);           // (0,1), open to the east and the south
  set(content, 17, north | east | south);  // (1,1), open to the west
  const Maze maze = test::maze_of(maz_format, content);

  MazeDraft draft({16, 16}, MazeDraft::Inside::closed);
  draft.open({0, 0}, Heading::north);
  draft.open({0, 1}, Heading::east);
  EXPECT_EQ(maze, Maze(draft));
  EXPECT_EQ(maz_format.write(maze).content, content);
}

TEST(Maz, TakesItsSizeFromTheLength) {
  EXPECT_EQ(test::maze_of(maz_format, closed(16)).size(), (Size{16, 16}));
  EXPECT_EQ(test::maze_of(maz_format, closed(32)).size(), (Size{32, 32}));
}

TEST(Maz, HoldsOnlyTwoSizesAndTheDefaultMarks) {
  EXPECT_EQ(maz_format.write(test::maze_by_dice({8, 32}, 1, 4)).reason,
            "the maze has 8x32 cells; the maz format has only 16x16 and 32x32");
  EXPECT_EQ(maz_format.write(test::maze_by_dice({16, 16}, 1, 4).with_start({0, 0}, Heading::east)).reason,
            "the start is (0,0) heading east; this format has only (0,0) heading north");
}

TEST(MazProblem, NeighboursDisagree) {
  std::string content = closed(16);
  set(content, 17, north | south | west);
  EXPECT_THAT(test::problems_of(maz_format, content),
              ElementsAre("0:18: cell (1,1) is open to the east but its neighbour (2,1) is closed to the west"));
}

TEST(MazProblem, OpenBorder) {
  std::string content = closed(32);
  set(content, 31, east | south | west);
  EXPECT_THAT(test::problems_of(maz_format, content),
              ElementsAre("0:32: cell (0,31) is open to the north but the border of a maze is closed"));
}

TEST(MazProblem, HighBits) {
  std::string content = closed(16);
  set(content, 2, 16);
  set(content, 255, 255);
  EXPECT_THAT(test::problems_of(maz_format, content), ElementsAre("0:3: expected a byte from 0 to 15, found 16",
                                                                  "0:256: expected a byte from 0 to 15, found 255"));
}

TEST(MazProblem, Length) {
  EXPECT_THAT(test::problems_of(maz_format, closed(15)),
              ElementsAre("0:0: expected 256 bytes (16x16) or 1024 bytes (32x32), found 225"));
}

TEST(MazProblem, AtMostTenAreListed) {
  EXPECT_THAT(test::problems_of(maz_format, std::string(256, '\0')), SizeIs(10));
  EXPECT_THAT(test::problems_of(maz_format, std::string(1024, 'x')), SizeIs(10));
}

TEST(MazProblem, EmptyFile) { EXPECT_THAT(test::problems_of(maz_format, ""), ElementsAre("0:0: the file is empty")); }

}  // namespace
}  // namespace labmouse
