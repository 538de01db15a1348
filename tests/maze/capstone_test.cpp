#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/maze/problem_lines.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::content_of;
using test::Lines;
using test::Says;
using test::SaysAt;
using testing::ElementsAre;
using testing::SizeIs;

Lines problems_of(std::string_view content) { return test::problems_of(capstone_format, content_of(content)); }
Maze read(std::string_view content) { return test::maze_of(capstone_format, content); }
Maze drawing(std::string_view content) { return test::maze_of(drawing_format, content); }

// Test maze 1 of the capstone.
constexpr std::string_view maze_1 = R"(
12
1,5,7,5,5,5,7,5,7,5,5,6
3,5,14,3,7,5,15,4,9,5,7,12
11,6,10,10,9,7,13,6,3,5,13,4
10,9,13,12,3,13,5,12,9,5,7,6
9,5,6,3,15,5,5,7,7,4,10,10
3,5,15,14,10,3,6,10,11,6,10,10
9,7,12,11,12,9,14,9,14,11,13,14
3,13,5,12,2,3,13,6,9,14,3,14
11,4,1,7,15,13,7,13,6,9,14,10
11,5,6,10,9,7,13,5,15,7,14,8
11,5,12,10,2,9,5,6,10,8,9,6
9,5,5,13,13,5,5,12,9,5,5,12
)";

// The same maze as a person sees it.
constexpr std::string_view maze_1_drawn = R"(
o---o---o---o---o---o---o---o---o---o---o---o---o
|       |   |                           |       |
o   o   o   o   o---o---o   o   o---o---o   o   o
|   |       |               |               |   |
o   o   o   o   o---o---o   o---o   o   o---o   o
|   |   |   |   |   |               |       |   |
o   o   o   o   o   o   o---o   o---o   o---o   o
|       |       |               |               |
o   o---o---o---o   o---o   o---o   o   o---o---o
|   |   |       |           |       |   |       |
o   o   o   o   o   o---o---o   o   o   o   o   o
|           |   |   | G   G     |       |   |   |
o   o   o   o   o   o   o   o   o   o   o   o   o
|   |   |       |   | G   G |       |       |   |
o   o   o   o   o   o---o---o---o   o   o---o   o
|   |       |               |           |       |
o   o   o---o---o   o---o   o---o   o---o---o   o
|   |           |               |               |
o   o---o---o   o---o   o---o   o   o---o---o   o
|               |           |   |   |       |   |
o   o   o---o   o   o   o   o   o---o   o   o   o
|   |   |       |   |   |       |   |   |   |   |
o   o   o   o---o   o   o   o   o   o   o   o   o
| S |               |       |                   |
o---o---o---o---o---o---o---o---o---o---o---o---o
)";

TEST(Capstone, HasAColumnInEachLineFromTheSouth) {
  const Maze maze = read("2\n1,4\n1,4\n");
  EXPECT_EQ(maze, drawing("o---o---o\n|   |   |\no   o   o\n|   |   |\no---o---o\n"));
}

TEST(Capstone, AddsUpOpenSides) {
  const Maze maze = read("3\n0,2,0\n1,15,4\n0,8,0\n");
  EXPECT_EQ(maze, drawing(R"(
o---o---o---o
|   |   |   |
o---o   o---o
|           |
o---o   o---o
|   |   |   |
o---o---o---o
)"));
}

TEST(Capstone, ReadsAndWritesTestMaze1) {
  const Maze maze = read(maze_1);
  EXPECT_EQ(capstone_format.write(maze).content, content_of(maze_1));
  EXPECT_EQ(drawing_format.write(maze).content, content_of(maze_1_drawn));
}

TEST(Capstone, TakesAnyLineEndsAndBlanks) {
  const Maze plain = read("2\n1,4\n1,4\n");
  EXPECT_EQ(read("2\r\n1,4\r\n1,4\r\n"), plain);
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "2\n1,4\n1,4"),
            plain);
  EXPECT_EQ(read(" 2 \n 1 , 4 \n1,\t4\n\n\r\n"), plain);
}

TEST(Capstone, HoldsOnlySquaresWithTheDefaultMarks) {
  const Maze square = read("2\n1,4\n1,4\n");
  EXPECT_THAT(capstone_format.write(drawing("o---o---o\n|       |\no---o---o\n")).reason, Says("not square"));
  EXPECT_THAT(capstone_format.write(square.with_start({1, 0}, Heading::west)).reason,
              Says("start", "(1,0) heading west", "(0,0) heading north"));
  CellSet corner;
  corner.insert({1, 1});
  EXPECT_THAT(capstone_format.write(square.with_goals(corner)).reason, Says("goal", "centre"));
}

TEST(CapstoneProblem, NeighboursDisagree) {
  EXPECT_THAT(problems_of("2\n3,4\n1,4\n"),
              ElementsAre(SaysAt("2:1", "cell (0,0)", "east", "neighbour (1,0)", "west")));
  EXPECT_THAT(problems_of("2\n0, 4\n8,0\n"),
              ElementsAre(SaysAt("2:4", "cell (0,1)", "south", "neighbour (0,0)", "north"),
                          SaysAt("3:1", "cell (1,0)", "west", "neighbour (0,0)", "east")));
}

TEST(CapstoneProblem, OpenBorderOnEachSide) {
  EXPECT_THAT(problems_of("1\n15\n"),
              ElementsAre(SaysAt("2:1", "(0,0)", "north", "border"), SaysAt("2:1", "(0,0)", "east", "border"),
                          SaysAt("2:1", "(0,0)", "south", "border"), SaysAt("2:1", "(0,0)", "west", "border")));
}

TEST(CapstoneProblem, Size) {
  EXPECT_THAT(problems_of("0\n"), ElementsAre(SaysAt("1:1", "size", "1 to 64", "'0'")));
  EXPECT_THAT(problems_of(" 65\n"), ElementsAre(SaysAt("1:2", "size", "1 to 64", "'65'")));
  EXPECT_THAT(problems_of("99999999999999999999999\n0\n"),
              ElementsAre(SaysAt("1:1", "size", "1 to 64", "'99999999999999999999...'")));
  EXPECT_THAT(problems_of("1,5,7\n"), ElementsAre(SaysAt("1:1", "size", "1 to 64", "'1,5,7'")));
}

TEST(CapstoneProblem, WrongNumbers) {
  EXPECT_THAT(problems_of("2\n16,x\n-1,\n"),
              ElementsAre(SaysAt("2:1", "0 to 15", "'16'"), SaysAt("2:4", "0 to 15", "'x'"),
                          SaysAt("3:1", "0 to 15", "'-1'"), SaysAt("3:4", "0 to 15", "''")));
}

TEST(CapstoneProblem, WrongNumberOfNumbers) {
  EXPECT_THAT(problems_of("2\n1\n1,4,0,0\n"),
              ElementsAre(SaysAt("2:2", "x=0", "1 numbers", "2"), SaysAt("3:5", "x=1", "more than 2 numbers")));
}

TEST(CapstoneProblem, WrongNumberOfLines) {
  EXPECT_THAT(problems_of("2\n1,4\n"), ElementsAre(SaysAt("3:1", "2 lines", "1")));
  EXPECT_THAT(problems_of("64"), ElementsAre(SaysAt("2:1", "64 lines", "0")));
  EXPECT_THAT(problems_of("2\n1,4\n1,4\n\n1,4\n1,4"), ElementsAre(SaysAt("4:1", "2 lines", "more")));
}

TEST(CapstoneProblem, PlacesDoNotDependOnLineEndsOrMark) {
  EXPECT_THAT(problems_of("\xEF\xBB\xBF"
                          "2x\r\n"),
              ElementsAre(SaysAt("1:1", "size", "1 to 64", "'2x'")));
  EXPECT_THAT(problems_of("2\r\n1,4\r\n1,99\r\n"), ElementsAre(SaysAt("3:3", "0 to 15", "'99'")));
}

TEST(CapstoneProblem, AtMostTenAreListed) {
  EXPECT_THAT(problems_of("3\n15,15,15\n15,15,15\n15,15,15\n"), SizeIs(10));
  EXPECT_THAT(problems_of("12\nx,x,x,x,x,x,x,x,x,x,x,x\n"), SizeIs(10));
}

TEST(CapstoneProblem, EmptyFile) { EXPECT_THAT(problems_of(""), ElementsAre(SaysAt("0:0", "empty"))); }

}  // namespace
}  // namespace labmouse
