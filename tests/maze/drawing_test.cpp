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
  EXPECT_THAT(drawing_format.write(read(small).with_start({0, 0}, Heading::east)).reason,
              Says("start heading", "east", "north"));
}

TEST(Drawing, CannotHoldTwoLettersInACell) {
  EXPECT_THAT(drawing_format.write(read(small).with_start({0, 1}, Heading::north)).reason,
              Says("start", "goal", "one letter"));
}

TEST(Drawing, ClosesGapsInItsBorderWithANote) {
  const ReadResult open = read_maze(content_of(R"(
o---o   o---o
|            
o   o   o   o
            |
o---o---o   o
)"));
  EXPECT_EQ(open.maze, read("o---o---o---o\n|           |\no   o   o   o\n|           |\no---o---o---o\n"));
  EXPECT_THAT(open.notes, ElementsAre(Says("north of (1,1)", "east of (2,1)", "west of (0,0)", "south of (2,0)")));
}

TEST(Drawing, MayHaveCellsOfAnyWidth) {
  const Maze plain = read(small);
  EXPECT_EQ(read("+-+-+-+\n|G  | |\n+ +-+ +\n|    S|\n+-+-+-+\n"), plain);
  EXPECT_EQ(read("o--o--o--o\n| G   |  |\no  o--o  o\n|      S |\no--o--o--o\n"), plain);
  EXPECT_EQ(read("o-----o-----o-----o\n|G          | 12  |\no     o-----o     o\n|               S |\n"
                 "o-----o-----o-----o\n"),
            plain);
  EXPECT_THAT(problems_of("o--o--o\n|     |\no--o- o\n"), ElementsAre(SaysAt("3:6", "(--)")));
  EXPECT_THAT(problems_of("o--o---o\n|      |\no--o---o\n"), ElementsAre(SaysAt("1:9", "8", "3")));
  EXPECT_THAT(problems_of("oo\n||\noo\n"), SizeIs(1));
}

TEST(Drawing, MayHaveNumbersAndArrowsInCells) {
  const Maze plain = read("o---o---o---o\n|         G |\no---o---o---o\n");
  EXPECT_EQ(read("+---+---+---+\n| >   12  @ |\n+---+---+---+\n"), plain);
  EXPECT_EQ(read("o---o---o---o\n|  9 v ^  * |\no---o---o---o\n"), plain);
}

TEST(DrawingProblem, UnknownLettersInCells) {
  EXPECT_THAT(problems_of("o---o---o\n| X  S  |\no---o---o\n"),
              ElementsAre(SaysAt("2:3", "(0,0)", "S or G", "'X'"), SaysAt("2:6", "(1,0)", "S or G", "'S'")));
  EXPECT_THAT(problems_of("o---o---o\n|G g    |\no---o---o\n"),
              ElementsAre(SaysAt("2:2", "(0,0)", "S or G", "'G'"), SaysAt("2:4", "(0,0)", "S or G", "'g'")));
  EXPECT_THAT(problems_of(std::string_view("o---o\n| \0 |\no---o\n", 18)),
              ElementsAre(SaysAt("2:3", "(0,0)", "S or G", "'\\x00'")));
}

TEST(DrawingProblem, SecondStart) {
  EXPECT_THAT(problems_of("o---o---o\n| S   S |\no---o---o\n"),
              ElementsAre(SaysAt("2:7", "(1,0)", "second start", "(0,0)")));
}

TEST(DrawingProblem, BrokenWallsAndPosts) {
  EXPECT_THAT(problems_of(R"(
o---o---o
|   I   |
o- -o --x
|       |
o---o---o
)"),
              ElementsAre(SaysAt("2:5", "(|)", "'I'"), SaysAt("3:3", "(---)", "' '"), SaysAt("3:7", "(---)", "'-'"),
                          SaysAt("3:9", "post", "'x'")));
  EXPECT_THAT(problems_of("o===o\n|   |\no--~o\n"),
              ElementsAre(SaysAt("1:2", "(---)", "'='"), SaysAt("3:4", "(---)", "'~'")));
}

TEST(DrawingProblem, LinesTooShortOrTooLong) {
  EXPECT_THAT(problems_of("o---o---o\n|       |x\no---o\n|       |\no---o---o\n"),
              ElementsAre(SaysAt("2:10", "longer"), SaysAt("3:6", "shorter")));
}

TEST(DrawingProblem, Size) {
  EXPECT_THAT(problems_of("o---o--\n|   |\no---o\n"),
              ElementsAre(SaysAt("1:8", "top line", "7 characters", "1 to 64 cells")));
  EXPECT_THAT(problems_of("o---o\n|   |\n"), ElementsAre(SaysAt("3:1", "2 lines", "2 for each row")));
  EXPECT_THAT(problems_of("o"), ElementsAre(SaysAt("1:2", "top line", "1 characters", "1 to 64 cells"),
                                            SaysAt("2:1", "1 line", "2 for each row")));
}

TEST(DrawingProblem, TooLarge) {
  std::string wide = "o";
  for (int x = 0; x < 65; ++x) wide += "---o";
  EXPECT_THAT(problems_of(wide + "\n|\n" + wide),
              ElementsAre(SaysAt("1:262", "top line", "261 characters", "1 to 64 cells")));
  std::string high = "o---o\n";
  for (int y = 0; y < 100'000; ++y) high += "|   |\no---o\n";
  EXPECT_THAT(problems_of(high), ElementsAre(SaysAt("130:1", "at most 129", "64 rows")));
}

TEST(DrawingProblem, AtMostTenAreListed) {
  EXPECT_THAT(problems_of("o---o---o---o---o\n|xxx|xxx|xxx|xxx|\no---o---o---o---o\n"), SizeIs(10));
}

TEST(DrawingProblem, EmptyFile) { EXPECT_THAT(problems_of("\r\n \n"), ElementsAre(SaysAt("0:0", "empty"))); }

}  // namespace
}  // namespace labmouse
