#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/maze/problem_lines.hpp"
#include "tests/maze/random_maze.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using test::SaysAt;
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

TEST(Maz, HoldsOnlySquaresAndTheDefaultMarks) {
  EXPECT_THAT(maz_format.write(test::random_maze({8, 32}, 1, 4)).reason, Says("8x32", "squares"));
  EXPECT_THAT(maz_format.write(test::random_maze({16, 16}, 1, 4).with_start({0, 0}, Heading::east)).reason,
              Says("start", "(0,0) heading east", "(0,0) heading north"));
}

TEST(MazProblem, NeighboursDisagree) {
  std::string content = closed(16);
  set(content, 17, north | south | west);
  EXPECT_THAT(test::problems_of(maz_format, content),
              ElementsAre(SaysAt("0:18", "cell (1,1)", "east", "neighbour (2,1)", "west")));
}

TEST(MazProblem, OpenBorder) {
  std::string content = closed(32);
  for (const std::size_t byte : {31, 63, 95}) set(content, byte, east | south | west);
  EXPECT_THAT(test::problems_of(maz_format, content),
              ElementsAre(SaysAt("0:32", "(0,31)", "north", "border"), SaysAt("0:64", "(1,31)", "north", "border"),
                          SaysAt("0:96", "(2,31)", "north", "border")));
}

TEST(Maz, MayHaveBitsOfVisitedCells) {
  const Maze maze = test::random_maze({16, 16}, 1, 4);
  std::string content = maz_format.write(maze).content.value();
  for (std::size_t i = 0; i < content.size(); i += 3) content[i] = static_cast<char>(content[i] | 0xF0);
  EXPECT_EQ(read_maze(content).maze, maze);
}

TEST(MazProblem, Length) {
  EXPECT_THAT(test::problems_of(maz_format, std::string(4099, char{15})), ElementsAre(SaysAt("0:0", "4096", "4099")));
  EXPECT_THAT(test::problems_of(maz_format, std::string(131, char{15})), ElementsAre(SaysAt("0:0", "131", "no maze")));
}

TEST(MazProblem, IsOneWhereNothingIsRight) {
  for (const std::string& content : {std::string(256, '\0'), std::string(1024, 'x')})
    EXPECT_THAT(test::problems_of(maz_format, content),
                ElementsAre(SaysAt("0:1", "no order", "columns from the west", "cell (0,0)")));
}

TEST(MazProblem, EmptyFile) { EXPECT_THAT(test::problems_of(maz_format, ""), ElementsAre(SaysAt("0:0", "empty"))); }

}  // namespace
}  // namespace labmouse
