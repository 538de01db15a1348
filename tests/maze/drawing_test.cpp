#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/maze/problem_lines.hpp"

namespace labmouse {
namespace {

using test::content_of;
using test::Lines;
using testing::ElementsAre;
using testing::SizeIs;

Lines problems_of(std::string_view drawing) { return test::problems_of(drawing_format, content_of(drawing)); }
Maze read(std::string_view drawing) { return test::maze_of(drawing_format, drawing); }
std::string write(const Maze& maze) { return drawing_format.write(maze).content.value_or("(not written)"); }

constexpr std::string_view small = R"(
o---o---o---o
| G     |   |
o   o---o   o
|         S |
o---o---o---o
)";

TEST(Drawing, HasTheNorthOnTop) {
  const Maze maze = read(small);
  EXPECT_EQ(maze.size(), (Size{3, 2}));
  EXPECT_TRUE(maze.is_open({0, 0}, Heading::north));
  EXPECT_FALSE(maze.is_open({1, 0}, Heading::north));
  EXPECT_TRUE(maze.is_open({0, 0}, Heading::east));
  EXPECT_TRUE(maze.is_open({0, 1}, Heading::east));
  EXPECT_FALSE(maze.is_open({1, 1}, Heading::east));
}

TEST(Drawing, HoldsStartAndGoal) {
  const Maze maze = read(small);
  EXPECT_EQ(maze.start(), (Cell{2, 0}));
  EXPECT_EQ(maze.start_heading(), Heading::north);
  EXPECT_EQ(maze.goals().count(), 1);
  EXPECT_TRUE(maze.is_goal({0, 1}));
}

TEST(Drawing, IsWrittenAsItIsRead) { EXPECT_EQ(write(read(small)), content_of(small)); }

TEST(Drawing, WithoutMarksStartsInTheCornerAndEndsInTheCentre) {
  const Maze maze = read(R"(
o---o---o---o
|           |
o   o   o   o
|           |
o---o---o---o
)");
  EXPECT_EQ(maze.start(), (Cell{0, 0}));
  EXPECT_EQ(maze.goals(), centre_of({3, 2}));
}

TEST(Drawing, TakesPlusesForPosts) {
  EXPECT_EQ(read("+---+---o\n| S   G |\n+---o---+\n"), read("o---o---o\n| S   G |\no---o---o\n"));
}

TEST(Drawing, TakesAnyLineEndsAndBlanksBehindThem) {
  const Maze plain = read("o---o---o\n| S   G |\no---o---o\n");
  EXPECT_EQ(read("o---o---o\r\n| S   G |\r\no---o---o\r\n"), plain);
  EXPECT_EQ(read("\xEF\xBB\xBFo---o---o\n| S   G |\no---o---o\n"), plain);
  EXPECT_EQ(read("o---o---o\n| S   G |\no---o---o"), plain);
  EXPECT_EQ(read("o---o---o  \n| S   G |\t\no---o---o\n\n \r\n\n"), plain);
}

TEST(Drawing, OfOneCellHasItsGoalUnderTheStart) {
  const Maze maze = read("o---o\n|   |\no---o\n");
  EXPECT_TRUE(maze.is_goal(maze.start()));
  EXPECT_EQ(write(maze), "o---o\n| G |\no---o\n");
  EXPECT_EQ(read(write(maze)), maze);
}

TEST(Drawing, LeavesOutTheGoalsUnderAStartInTheCentre) {
  const Maze maze = read("o---o---o---o\n|   | G |   |\no---o---o---o\n").with_start({1, 0}, Heading::north);
  EXPECT_EQ(write(maze), "o---o---o---o\n|   | S |   |\no---o---o---o\n");
  EXPECT_EQ(read(write(maze)), maze);
}

TEST(Drawing, CannotHoldAnotherHeading) {
  EXPECT_EQ(drawing_format.write(read(small).with_start({0, 0}, Heading::east)).reason,
            "the start heading is east; in a drawing it is always north");
}

TEST(Drawing, CannotHoldTwoLettersInACell) {
  EXPECT_EQ(drawing_format.write(read(small).with_start({0, 1}, Heading::north)).reason,
            "the start is also a goal; a drawing has room for one letter in a cell");
}

TEST(DrawingProblem, OpenBorderOnEachSide) {
  EXPECT_THAT(problems_of(R"(
o---o   o---o
|            
o   o   o   o
            |
o---o---o   o
)"),
              ElementsAre("1:6: cell (1,1) is open to the north but the border of a maze is closed",
                          "2:13: cell (2,1) is open to the east but the border of a maze is closed",
                          "4:1: cell (0,0) is open to the west but the border of a maze is closed",
                          "5:10: cell (2,0) is open to the south but the border of a maze is closed"));
}

TEST(DrawingProblem, UnknownLettersInCells) {
  EXPECT_THAT(problems_of("o---o---o\n| X  S  |\no---o---o\n"),
              ElementsAre("2:3: cell (0,0) may hold only S or G in its middle, found 'X'",
                          "2:6: cell (1,0) may hold only S or G in its middle, found 'S'"));
  EXPECT_THAT(problems_of("o---o---o\n|G g    |\no---o---o\n"),
              ElementsAre("2:2: cell (0,0) may hold only S or G in its middle, found 'G'",
                          "2:4: cell (0,0) may hold only S or G in its middle, found 'g'"));
  EXPECT_THAT(problems_of(std::string_view("o---o\n| \0 |\no---o\n", 18)),
              ElementsAre("2:3: cell (0,0) may hold only S or G in its middle, found '\\x00'"));
}

TEST(DrawingProblem, SecondStart) {
  EXPECT_THAT(problems_of("o---o---o\n| S   S |\no---o---o\n"),
              ElementsAre("2:7: cell (1,0) is a second start; the first is (0,0)"));
}

TEST(DrawingProblem, BrokenWallsAndPosts) {
  EXPECT_THAT(
      problems_of(R"(
o---o---o
|   I   |
o- -o --x
|       |
o---o---o
)"),
      ElementsAre("2:5: expected a wall (|) or a blank, found 'I'",
                  "3:3: expected a wall (---) or three blanks, found ' '",
                  "3:7: expected a wall (---) or three blanks, found '-'", "3:9: expected a post (o or +), found 'x'"));
  EXPECT_THAT(problems_of("o===o\n|   |\no--~o\n"),
              ElementsAre("1:2: expected a wall (---) or three blanks, found '='",
                          "3:4: expected a wall (---) or three blanks, found '~'"));
}

TEST(DrawingProblem, LinesTooShortOrTooLong) {
  EXPECT_THAT(problems_of("o---o---o\n|       |x\no---o\n|       |\no---o---o\n"),
              ElementsAre("2:10: the line is longer than the top line",
                          "3:6: the line is shorter than the top line; a post is missing"));
}

TEST(DrawingProblem, Size) {
  EXPECT_THAT(problems_of("o---o--\n|   |\no---o\n"),
              ElementsAre("1:8: the top line has 7 characters; it has 4 for each cell and 1 more, for 1 to 64 cells"));
  EXPECT_THAT(problems_of("o---o\n|   |\n"),
              ElementsAre("3:1: the drawing has 2 lines; it has 2 for each row of cells and 1 more"));
  EXPECT_THAT(problems_of("o"),
              ElementsAre("1:2: the top line has 1 characters; it has 4 for each cell and 1 more, for 1 to 64 cells",
                          "2:1: the drawing has 1 line; it has 2 for each row of cells and 1 more"));
}

TEST(DrawingProblem, TooLarge) {
  std::string wide = "o";
  for (int x = 0; x < 65; ++x) wide += "---o";
  EXPECT_THAT(
      problems_of(wide + "\n|\n" + wide),
      ElementsAre("1:262: the top line has 261 characters; it has 4 for each cell and 1 more, for 1 to 64 cells"));
  std::string high = "o---o\n";
  for (int y = 0; y < 100'000; ++y) high += "|   |\no---o\n";
  EXPECT_THAT(problems_of(high), ElementsAre("130:1: a drawing has at most 129 lines, for 64 rows of cells"));
}

TEST(DrawingProblem, AtMostTenAreListed) {
  EXPECT_THAT(problems_of("o---o---o---o---o\n|xxx|xxx|xxx|xxx|\no---o---o---o---o\n"), SizeIs(10));
}

TEST(DrawingProblem, EmptyFile) { EXPECT_THAT(problems_of("\r\n \n"), ElementsAre("0:0: the file is empty")); }

}  // namespace
}  // namespace labmouse
