#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/maze/problem_lines.hpp"

namespace labmouse {
namespace {

using test::content_of;
using test::Lines;
using testing::ElementsAre;
using testing::SizeIs;

Lines problems_of(std::string_view content) { return test::problems_of(num_format, content_of(content)); }
Maze read(std::string_view content) { return test::maze_of(num_format, content); }

constexpr std::string_view corner = R"(
0 0 0 1 1 1
0 1 1 0 0 1
1 0 1 1 1 1
1 1 1 1 1 0
)";

constexpr std::string_view corner_drawn = R"(
o---o---o
|       |
o   o---o
|   |   |
o---o---o
)";

TEST(Num, HasOneForAWall) { EXPECT_EQ(read(corner), test::maze_of(drawing_format, corner_drawn)); }

TEST(Num, IsWrittenColumnByColumn) { EXPECT_EQ(num_format.write(read(corner)).content, content_of(corner)); }

TEST(Num, TakesCellsInAnyOrder) {
  EXPECT_EQ(read("1 1 1 1 1 0\n0 0 0 1 1 1\n1 0 1 1 1 1\n0 1 1 0 0 1\n"), read(corner));
}

TEST(Num, TakesAnyLineEndsAndBlanks) {
  EXPECT_EQ(read("\xEF\xBB\xBF 0  0 0\t1 1 1 \r\n0 1 1 0 0 1\r\n1 0 1 1 1 1\r\n1 1 1 1 1 0\r\n\r\n\n"), read(corner));
  EXPECT_EQ(read("0 0 1 1 1 1"), read("0 0 1 1 1 1\n"));
}

TEST(Num, MayBeARectangle) { EXPECT_EQ(read("0 0 1 0 1 1\n1 0 1 1 1 0\n").size(), (Size{2, 1})); }

TEST(Num, HoldsOnlyTheDefaultMarks) {
  EXPECT_EQ(num_format.write(read(corner).with_start({0, 1}, Heading::south)).reason,
            "the start is (0,1) heading south; this format has only (0,0) heading north");
}

TEST(NumProblem, NeighboursDisagree) {
  EXPECT_THAT(problems_of("1 0 1 1 1 0\n0 0 1 1 1 1\n"),
              ElementsAre("1:1: cell (1,0) is open to the west but its neighbour (0,0) is closed to the east"));
}

TEST(NumProblem, OpenBorder) {
  EXPECT_THAT(problems_of("0 0 1 1 0 1\n"),
              ElementsAre("1:1: cell (0,0) is open to the south but the border of a maze is closed"));
}

TEST(NumProblem, SameCellTwice) {
  EXPECT_THAT(problems_of("0 0 1 1 1 1\n0 0 1 1 1 1\n"), ElementsAre("2:1: cell (0,0) is already on line 1"));
}

TEST(NumProblem, MissingCells) {
  EXPECT_THAT(problems_of("0 0 1 1 1 1\n1 2 1 1 1 1\n"),
              ElementsAre("0:0: cell (1,0) is missing in a maze of 2x3 cells",
                          "0:0: cell (0,1) is missing in a maze of 2x3 cells",
                          "0:0: cell (1,1) is missing in a maze of 2x3 cells",
                          "0:0: cell (0,2) is missing in a maze of 2x3 cells"));
  EXPECT_THAT(problems_of("63 63 1 1 1 1\n"), SizeIs(10));
}

TEST(NumProblem, WrongNumbers) {
  EXPECT_THAT(
      problems_of("0 64 1 1 1 1\n-1 0 1 1 2 1\n2147483648 a 1 1 1 1\n"),
      ElementsAre("1:3: expected a number from 0 to 63, found '64'", "2:1: expected a number from 0 to 63, found '-1'",
                  "2:10: expected a number from 0 to 1, found '2'",
                  "3:1: expected a number from 0 to 63, found '2147483648'",
                  "3:12: expected a number from 0 to 63, found 'a'"));
}

TEST(NumProblem, SignsAreNoDigits) {
  EXPECT_THAT(problems_of("-0 +0 1 1 1 1\n"), ElementsAre("1:1: expected a number from 0 to 63, found '-0'",
                                                          "1:4: expected a number from 0 to 63, found '+0'"));
}

TEST(NumProblem, WrongNumberOfNumbers) {
  EXPECT_THAT(problems_of("0 0 1 1 1\n\n0 0 1 1 1 1 0 0\n"),
              ElementsAre("1:10: expected six numbers (x y n e s w), found 5",
                          "2:1: expected six numbers (x y n e s w), found 0",
                          "3:13: expected only six numbers (x y n e s w), found more"));
}

TEST(NumProblem, AtMostTenAreListed) {
  std::string content;
  for (int i = 0; i < 100'000; ++i) content += "0 0 1 1 1 1\n";
  EXPECT_THAT(problems_of(content), SizeIs(10));
}

TEST(NumProblem, EmptyFile) { EXPECT_THAT(problems_of("\xEF\xBB\xBF\n"), ElementsAre("0:0: the file is empty")); }

}  // namespace
}  // namespace labmouse
