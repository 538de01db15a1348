#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "labmouse/lab/drawing/drawing.hpp"
#include "tests/lab/drawing/drawing_samples.hpp"

namespace labmouse {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(TextDrawing, ShowsWallsStartAndGoal) {
  EXPECT_EQ("\n" + draw_text(ring(), {}, false), R"(
o---o---o---o
|       |   |
o   o   o   o
|   | G     |
o   o---o   o
| S |       |
o---o---o---o
)");
}

TEST(TextDrawing, SmallestMazeStartsAtItsGoal) {
  EXPECT_EQ("\n" + draw_text(empty({1, 1}), {}, false), R"(
o---o
|GS |
o---o
)");
}

TEST(TextDrawing, PutsTitleAboveAndCoordinatesOnTheMargins) {
  DrawingLayers layers;
  layers.title = "Ring";
  layers.coordinates = true;
  EXPECT_EQ("\n" + draw_text(ring(), layers, false), R"(
Ring
   o---o---o---o
 2 |       |   |
   o   o   o   o
 1 |   | G     |
   o   o---o   o
 0 | S |       |
   o---o---o---o
     0   1   2
)");
}

TEST(TextDrawing, RouteIsDotsWithANumberWhereEachStepEnds) {
  DrawingLayers layers;
  layers.route = way_to_goal();
  EXPECT_EQ("\n" + draw_text(ring(), layers, false), R"(
o---o---o---o
| 1 . 2 |   |
o . o . o   o
| . |G3     |
o . o---o   o
| S |       |
o---o---o---o
)");
}

TEST(TextDrawing, RouteBreaksWhereTheMouseWasCarried) {
  DrawingLayers layers;
  layers.route = way_to_goal();
  layers.route.push_back({{0, 0}, Heading::north});
  layers.route.push_back({{0, 1}, Heading::north});
  EXPECT_EQ("\n" + draw_text(ring(), layers, false), R"(
o---o---o---o
| 1 . 2 |   |
o . o . o   o
| 5 |G3     |
o . o---o   o
|S4 |       |
o---o---o---o
)");
}

TEST(TextDrawing, NoLineThroughAWallEvenInOneRow) {
  DrawingLayers layers;
  layers.route = {{{1, 1}, Heading::west}, {{0, 1}, Heading::west}};
  EXPECT_THAT(draw_text(ring(), layers, false), HasSubstr("| 1 | G     |"));
}

TEST(TextDrawing, LabelsAreCentredAndCutWithAMark) {
  DrawingLayers layers;
  layers.label = [](Cell cell) {
    const std::vector<std::string> labels = {"", "1", "12", "123", "1234", "", "é", "\x1b[31m", "ab"};
    return labels[static_cast<std::size_t>(cell.y * 3 + cell.x)];
  };
  EXPECT_EQ("\n" + draw_text(ring(), layers, false), R"(
o---o---o---o
| é  [3~| ab|
o   o   o   o
|123|12~    |
o   o---o   o
| S | 1   12|
o---o---o---o
)");
}

TEST(TextDrawing, LabelsReplaceStepNumbersAndKeepTheDotsBetween) {
  DrawingLayers layers;
  layers.route = way_to_goal();
  layers.label = [](Cell cell) { return cell.x < 2 ? std::to_string(cell.x + cell.y) : ""; };
  EXPECT_EQ("\n" + draw_text(ring(), layers, false), R"(
o---o---o---o
| 2 . 3 |   |
o . o . o   o
| 1 |G2     |
o . o---o   o
|S0 | 1     |
o---o---o---o
)");
}

TEST(TextDrawing, UnknownWallsAreBrokenLinesOpenOrNot) {
  DrawingLayers layers;
  WallSet unknown = WallSet::all({3, 3});
  unknown.erase(wall_at({0, 0}, Heading::east));
  unknown.erase(wall_at({0, 0}, Heading::north));
  layers.unknown = unknown;
  layers.mouse = Pose{{0, 1}, Heading::north};
  EXPECT_EQ("\n" + draw_text(ring(), layers, false), R"(
o---o---o---o
|   :   :   |
o- -o- -o- -o
| ^ : G :   |
o   o- -o- -o
| S |   :   |
o---o---o---o
)");
}

TEST(TextDrawing, WrongGuessesAreCrosshatched) {
  DrawingLayers layers;
  layers.wrong.emplace();
  layers.wrong->insert(wall_at({1, 1}, Heading::south));
  layers.wrong->insert(wall_at({1, 2}, Heading::east));
  layers.unknown = layers.wrong;
  layers.unknown->insert(wall_at({2, 1}, Heading::north));
  EXPECT_EQ("\n" + draw_text(ring(), layers, false), R"(
o---o---o---o
|       #   |
o   o   o- -o
|   | G     |
o   o###o   o
| S |       |
o---o---o---o
# 2 wrong guesses: closed, never seen
)");
}

TEST(TextDrawing, MissedAndFalseWallsOfAMapHaveSignsOfTheirOwn) {
  DrawingLayers layers;
  layers.wrong.emplace();
  layers.wrong->insert(wall_at({1, 1}, Heading::south));
  layers.false_walls.emplace();
  layers.false_walls->insert(wall_at({0, 1}, Heading::south));
  layers.false_walls->insert(wall_at({1, 2}, Heading::east));
  layers.unknown.emplace();
  layers.unknown->insert(wall_at({2, 1}, Heading::north));
  EXPECT_EQ("\n" + draw_text(ring(), layers, false), R"(
o---o---o---o
|       %   |
o   o   o- -o
|   | G     |
o%%%o###o   o
| S |       |
o---o---o---o
# 1 missed wall: open in the map, closed in the maze
% 2 false walls: closed in the map, open in the maze
)");
}

TEST(TextDrawing, ExplorationHasASignForEachLegAndOneForBoth) {
  DrawingLayers layers;
  layers.search_run = search_run();
  layers.search_run->onwards.insert(layers.search_run->onwards.begin() + 1, Pose{{1, 2}, Heading::north});
  layers.search_run->onwards.insert(layers.search_run->onwards.begin() + 2, Pose{{1, 1}, Heading::north});
  EXPECT_EQ("\n" + draw_text(ring(), layers, false), R"(
o---o---o---o
| + + * |   |
o + o * o   o
| + |G* x x |
o + o---o x o
|S+ | x x x |
o---o---o---o
+ 3 steps to the goal, x 5 steps from there on, * both
)");
}

TEST(TextDrawing, ExplorationWithoutAGoalHasOneSign) {
  DrawingLayers layers;
  layers.search_run = SearchLegs{{{{0, 0}, Heading::north}, {{0, 1}, Heading::north}}, {}};
  EXPECT_THAT(draw_text(ring(), layers, false), HasSubstr("o---o---o---o\n+ 1 step, no goal entered\n"));
}

TEST(TextDrawing, TellsTheSharesOfTheExploredCells) {
  DrawingLayers layers;
  layers.explored = explored();
  EXPECT_THAT(draw_text(ring(), layers, false),
              HasSubstr("o\n6 of 9 cells visited (66.7 %), 8 of 9 cells discovered (88.9 %)\n"));
}

TEST(TextDrawing, MouseShowsItsHeading) {
  DrawingLayers layers;
  const std::vector<std::string> shapes = {"|S^ |", "|S> |", "|Sv |", "|S< |"};
  for (const Heading heading : all_headings) {
    layers.mouse = Pose{{0, 0}, heading};
    EXPECT_THAT(draw_text(ring(), layers, false), HasSubstr(shapes[static_cast<std::size_t>(heading)]));
  }
}

TEST(TextDrawing, ColoursOnlyWhereAskedForEvenWithHostileTexts) {
  DrawingLayers layers;
  layers.title = "\x1b[31mred\x1b[0m\r\n\x9b";
  layers.label = [](Cell) { return std::string("\x1b\x07"); };
  layers.visits = [](Cell cell) { return cell.x * 3; };
  layers.route = way_to_goal();
  layers.mouse = Pose{};
  const std::string plain = draw_text(ring(), layers, false);
  EXPECT_THAT(plain, Not(HasSubstr("\x1b")));
  EXPECT_THAT(plain, Not(HasSubstr("\r")));
  EXPECT_EQ(count(plain, "\n"), 8);
  EXPECT_THAT(draw_text(ring(), layers, true), HasSubstr("\x1b[0;"));
}

TEST(TextDrawing, ColoursDoNotChangeTheCharacters) {
  DrawingLayers layers;
  layers.route = way_to_goal();
  layers.visits = [](Cell cell) { return 1 + cell.y; };
  layers.unknown = WallSet::all({3, 3});
  layers.wrong = WallSet::all({3, 3});
  layers.wrong->erase(wall_at({0, 0}, Heading::north));
  layers.search_run = search_run();
  std::string coloured = draw_text(ring(), layers, true);
  for (auto at = coloured.find('\x1b'); at != std::string::npos; at = coloured.find('\x1b'))
    coloured.erase(at, coloured.find('m', at) - at + 1);
  EXPECT_EQ(coloured, draw_text(ring(), layers, false));
}

TEST(TextDrawing, EachColouredLineEndsWithoutColour) {
  DrawingLayers layers;
  layers.visits = [](Cell) { return 1; };
  const std::string text = draw_text(ring(), layers, true);
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    const std::string before = text.substr(0, at);
    const auto code = before.rfind("\x1b[");
    if (code == std::string::npos) continue;
    EXPECT_TRUE(before.substr(code).starts_with("\x1b[0m"));
  }
}

}  // namespace
}  // namespace labmouse
