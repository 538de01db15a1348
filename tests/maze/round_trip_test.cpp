// Writing and reading give the same maze, for random mazes in every format that can hold them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "labmouse/maze/formats/format.hpp"
#include "tests/maze/random_maze.hpp"

namespace labmouse {
namespace {

using test::marked_mazes;
using test::mazes_of;
using test::sizes;

rc::Gen<Size> larger_sizes() {
  return rc::gen::map(sizes(), [](Size size) { return Size{std::max(size.width, 2), std::max(size.height, 2)}; });
}

// A maze that the format must hold comes back the same, whether the format is named or recognised.
void expect_same(const Format& format, const Maze& maze) {
  const WriteResult written = format.write(maze);
  RC_ASSERT(written.content.has_value());
  RC_ASSERT(written.reason.empty());
  RC_ASSERT(format.read(*written.content).maze == maze);
  RC_ASSERT(read_maze(*written.content).maze == maze);
}

RC_GTEST_PROP(RoundTrip, DrawingAndNumHoldAllSizes, ()) {
  const Maze maze = *mazes_of(sizes());
  expect_same(drawing_format, maze);
  expect_same(num_format, maze);
}

RC_GTEST_PROP(RoundTrip, CapstoneHoldsSquares, ()) {
  const auto squares = rc::gen::map(sizes(), [](Size size) { return Size{size.width, size.width}; });
  expect_same(capstone_format, *mazes_of(squares));
}

RC_GTEST_PROP(RoundTrip, MazAndDumpHoldSquares, ()) {
  const auto squares = rc::gen::map(larger_sizes(), [](Size size) { return Size{size.width, size.width}; });
  const Maze maze = *mazes_of(squares);
  expect_same(maz_format, maze);
  expect_same(dump_format, maze);
  expect_same(steps_format, maze);
}

RC_GTEST_PROP(RoundTrip, BlocksHoldAllSizes, ()) { expect_same(blocks_format, *mazes_of(sizes())); }

RC_GTEST_PROP(RoundTrip, TablesHoldAllSizesFromTwoRowsAndColumns, ()) {
  const Maze maze = *mazes_of(larger_sizes());
  for (const Format* format : {&hex_format, &csv_format, &json_format, &c_format}) expect_same(*format, maze);
}

RC_GTEST_PROP(RoundTrip, DrawingHoldsMarks, ()) {
  const Maze maze = *marked_mazes();
  if (maze.start_heading() == Heading::north && !maze.is_goal(maze.start())) expect_same(drawing_format, maze);
}

RC_GTEST_PROP(RoundTrip, AFormatHoldsAMazeOrSaysWhyNot, ()) {
  const Maze maze = *marked_mazes();
  for (const Format* format : all_formats()) {
    const WriteResult written = format->write(maze);
    RC_ASSERT(written.content.has_value() == written.reason.empty());
    if (written.content) RC_ASSERT(format->read(*written.content).maze == maze);
  }
}

RC_GTEST_PROP(RoundTrip, ADrawingWithoutTrailingBlanksAndWithPlusesIsTheSame, ()) {
  const Maze maze = *mazes_of(sizes());
  std::string content = drawing_format.write(maze).content.value();
  for (char& letter : content)
    if (letter == 'o') letter = '+';
  RC_ASSERT(drawing_format.read(content).maze == maze);
}

// One flipped bit is seen by both neighbours, so it can never go unnoticed.
RC_GTEST_PROP(RoundTrip, AFlippedSideIsAProblemOrANoteThatNamesTheCell, ()) {
  const Maze maze = *mazes_of(rc::gen::just(Size{16, 16}));
  std::string content = maz_format.write(maze).content.value();
  const auto byte = *rc::gen::inRange<std::size_t>(0, content.size());
  content[byte] = static_cast<char>(content[byte] ^ (1 << *rc::gen::inRange(0, 4)));
  const ReadResult result = read_maze(content);
  const std::string cell = "(" + std::to_string(byte / 16) + "," + std::to_string(byte % 16) + ")";
  if (result.maze) {
    // One on the border can be an entrance.
    RC_ASSERT(result.notes.size() == 1U);
    RC_ASSERT(result.notes.front().find(cell) != std::string::npos);
    RC_ASSERT(result.maze == maze);
    return;
  }
  RC_ASSERT(result.problems.size() == 1U);
  RC_ASSERT(result.problems.front().reason.find(cell) != std::string::npos);
  // With few openings, no reading is better than others.
  if (maze.open_walls().count() <= maze.size().area() / 2) return;
  const ReadResult repaired = read_maze(content, {.repaired = true});
  RC_ASSERT(repaired.problems.empty());
  RC_ASSERT(repaired.notes.size() == 1U);
  const int walls = maze.open_walls().count() - repaired.maze->open_walls().count();
  RC_ASSERT(walls == 0 || walls == 1);
}

// A content gives a maze that survives being written, or problems; never both and never neither.
void expect_maze_or_problems(const std::string& content) {
  for (const Format* format : all_formats()) {
    const ReadResult result = format->read(content);
    RC_ASSERT(result.maze.has_value() == result.problems.empty());
    RC_ASSERT(result.problems.size() <= most_problems);
    if (!result.maze) continue;
    // A file of bytes can be a rectangle, which is not written: its size would have to be guessed.
    const WriteResult written = format->write(*result.maze);
    if (written.content) RC_ASSERT(format->read(*written.content).maze == result.maze);
  }
  const ReadResult result = read_maze(content);
  RC_ASSERT(result.maze.has_value() == result.problems.empty());
}

RC_GTEST_PROP(AnyContent, GivesAMazeOrProblems, (const std::string& content)) { expect_maze_or_problems(content); }

RC_GTEST_PROP(AnyContent, GivesAMazeOrProblemsAfterAFewAccidents, ()) {
  const Maze maze = *mazes_of(rc::gen::just(Size{16, 16}));
  std::string content = (*rc::gen::elementOf(all_formats()))->write(maze).content.value();
  const int accidents = *rc::gen::inRange(1, 4);
  for (int i = 0; i < accidents; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, content.size());
    const auto length = *rc::gen::inRange<std::size_t>(0, 3);
    content.replace(at, length,
                    *rc::gen::element<std::string>("", " ", "\n", "\r\n", "o", "-", "S", "G", ",", "1", "16"));
  }
  expect_maze_or_problems(content);
}

}  // namespace
}  // namespace labmouse
