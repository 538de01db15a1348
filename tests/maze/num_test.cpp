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
  EXPECT_THAT(num_format.write(read(corner).with_start({0, 1}, Heading::south)).reason,
              Says("start", "(0,1) heading south", "(0,0) heading north"));
}

TEST(NumProblem, NeighboursDisagree) {
  EXPECT_THAT(problems_of("1 0 1 1 1 0\n0 0 1 1 1 1\n"),
              ElementsAre(SaysAt("1:1", "cell (1,0)", "west", "neighbour (0,0)", "east")));
}

TEST(NumProblem, OpenBorder) {
  EXPECT_THAT(problems_of("0 0 1 1 0 1\n"), ElementsAre(SaysAt("1:1", "(0,0)", "south", "border")));
}

TEST(NumProblem, SameCellTwice) {
  EXPECT_THAT(problems_of("0 0 1 1 1 1\n0 0 1 1 1 1\n"), ElementsAre(SaysAt("2:1", "(0,0)", "line 1")));
}

TEST(NumProblem, MissingCells) {
  EXPECT_THAT(problems_of("0 0 1 1 1 1\n1 2 1 1 1 1\n"),
              ElementsAre(SaysAt("0:0", "(1,0)", "missing", "2x3"), SaysAt("0:0", "(0,1)", "missing", "2x3"),
                          SaysAt("0:0", "(1,1)", "missing", "2x3"), SaysAt("0:0", "(0,2)", "missing", "2x3")));
  EXPECT_THAT(problems_of("63 63 1 1 1 1\n"), SizeIs(10));
}

TEST(NumProblem, WrongNumbers) {
  EXPECT_THAT(
      problems_of("0 64 1 1 1 1\n-1 0 1 1 2 1\n2147483648 a 1 1 1 1\n"),
      ElementsAre(SaysAt("1:3", "0 to 63", "'64'"), SaysAt("2:1", "0 to 63", "'-1'"), SaysAt("2:10", "0 to 1", "'2'"),
                  SaysAt("3:1", "0 to 63", "'2147483648'"), SaysAt("3:12", "0 to 63", "'a'")));
}

TEST(NumProblem, SignsAreNoDigits) {
  EXPECT_THAT(problems_of("-0 +0 1 1 1 1\n"),
              ElementsAre(SaysAt("1:1", "0 to 63", "'-0'"), SaysAt("1:4", "0 to 63", "'+0'")));
}

TEST(NumProblem, WrongNumberOfNumbers) {
  EXPECT_THAT(problems_of("0 0 1 1 1\n\n0 0 1 1 1 1 0 0\n"),
              ElementsAre(SaysAt("1:10", "six numbers", "5"), SaysAt("2:1", "six numbers", "0"),
                          SaysAt("3:13", "six numbers", "more")));
}

TEST(NumProblem, AtMostTenAreListed) {
  std::string content;
  for (int i = 0; i < 100'000; ++i) content += "0 0 1 1 1 1\n";
  EXPECT_THAT(problems_of(content), SizeIs(10));
}

TEST(NumProblem, EmptyFile) { EXPECT_THAT(problems_of("\xEF\xBB\xBF\n"), ElementsAre(SaysAt("0:0", "empty"))); }

}  // namespace
}  // namespace labmouse
