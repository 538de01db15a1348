// Maze files as others write them: bit orders, layouts and notations that no file states.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include "labmouse/maze/map_comparison.hpp"
#include "labmouse/maze/symmetry.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/maze/problem_lines.hpp"
#include "tests/maze/random_maze.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::Says;
using testing::ElementsAre;
using testing::IsEmpty;

// One way to write a maze as numbers.
struct Notation {
  std::array<Heading, 4> order;
  unsigned shift = 0;
  bool openings = false;
  bool columns = false;
  bool from_north = true;
};

unsigned number_of(const Maze& maze, Cell cell, const Notation& notation) {
  unsigned number = 0;
  for (unsigned bit = 0; bit < 4; ++bit)
    if (maze.is_open(cell, notation.order[bit]) == notation.openings) number |= 1U << (notation.shift + bit);
  return number;
}

// Rows or columns of numbers, each in brackets.
std::string list_of(const Maze& maze, const Notation& notation) {
  const auto [width, height] = maze.size();
  std::string text = "[";
  for (int i = 0; i < (notation.columns ? width : height); ++i) {
    text += i == 0 ? "[" : "], [";
    for (int j = 0; j < (notation.columns ? height : width); ++j) {
      const int x = notation.columns ? i : j, up = notation.columns ? j : i;
      const int y = notation.from_north ? height - 1 - up : up;
      text += (j == 0 ? "" : ", ") + std::to_string(number_of(maze, {x, y}, notation));
    }
  }
  return text + "]]";
}

// With the start that is usual: open to the north only.
Maze usual_maze(Size size, std::uint64_t seed) {
  const Maze maze = test::random_maze(size, seed, 5);
  MazeDraft draft(size, MazeDraft::Inside::closed);
  for (int i = 0; i < size.area(); ++i)
    for (const Heading side : {Heading::north, Heading::east})
      if (maze.is_open(size.cell_at(i), side)) draft.open(size.cell_at(i), side);
  draft.open({0, 0}, Heading::north);
  draft.close({0, 0}, Heading::east);
  draft.open({0, size.height - 1}, Heading::east);
  draft.open({0, size.height - 1}, Heading::south);
  draft.open({size.width - 1, 0}, Heading::north);
  draft.open({size.width - 1, 0}, Heading::west);
  draft.open({size.width - 1, size.height - 1}, Heading::west);
  draft.open({size.width - 1, size.height - 1}, Heading::south);
  return Maze(draft);
}

TEST(FieldFormats, FindTheBitsThatNoFileStates) {
  if (test::briefly_sanitized) GTEST_SKIP() << "takes long with the sanitizers: there only in `make proof`";
  int exact = 0;
  std::array order = {Heading::north, Heading::east, Heading::south, Heading::west};
  do
    for (const unsigned shift : {0U, 1U, 4U})
      for (const bool openings : {false, true})
        for (const bool columns : {false, true})
          for (const bool from_north : {false, true}) {
            const Maze maze = usual_maze({9, 7}, 3);
            const ReadResult read = read_maze(list_of(maze, {order, shift, openings, columns, from_north}));
            // A layout that is not in use, or numbers that fit what files of this format usually have.
            if (columns && from_north && !read.notes.empty()) continue;
            if (read.reading.ends_with("rows from the north, walls 1 north, 2 east, 4 south, 8 west")) continue;
            ++exact;
            EXPECT_EQ(read.maze, maze) << read.reading;
            EXPECT_THAT(read.notes, IsEmpty());
          }
  while (std::next_permutation(order.begin(), order.end()));
  EXPECT_GT(exact, 24 * 3 * 2 * 3);
}

TEST(FieldFormats, SayWhereTwoMazesFit) {
  // Two corners that could be the start.
  MazeDraft draft({3, 3}, MazeDraft::Inside::open);
  draft.close({0, 0}, Heading::east);
  draft.close({0, 2}, Heading::south);
  const Maze maze{draft};
  const std::array order = {Heading::west, Heading::south, Heading::north, Heading::east};
  const ReadResult read = read_maze(list_of(maze, {order, 0, false, false, true}));
  ASSERT_TRUE(read.maze);
  EXPECT_EQ(canonical_walls(*read.maze), canonical_walls(maze));
  EXPECT_THAT(read.notes, ElementsAre(Says("other maze")));
}

TEST(FieldFormats, AreReadFromOtherLanguages) {
  // By walls, the columns are 14, 9 and 14, 3.
  const Maze maze = test::maze_of(drawing_format, "o---o---o\n|       |\no   o   o\n|   |   |\no---o---o\n");
  for (const std::string_view text : {
           "const uint8_t m[2][2] = {\n  {0x0E, 0x09},\n  {0x0E, 0x03}, // east\n};\n",
           "#define SIZE 2\n/* walls[x][y] */ static int walls[SIZE][SIZE]={{14u,9U},{14,3}};",
           "var maze = [2][2]int{{14, 9}, {14, 3}}\n",
           "let maze: [[u8; 2]; 2] = [[0b1110, 0b1001], [0b1110, 0b0011]];",
           "maze = [\n  [14, 9],  # x = 0\n  [14, 3],\n]\n",
           "int maze[] = {14, 9, 14, 3};",
           "cell maze[2][2] = {{{0,1,1,1}, {1,0,0,1}}, {{0,1,1,1}, {1,1,0,0}}};",
           "bool m[4][4] = {{false, true, true, true}, {true,false,false,true}, {0,1,1,1}, {1,1,0,0}};",
           "const char *maze[] = {\"93\", \"ee\"};",
           R"([["NW", "NE"], ["ESW", "SEW"]])",
           R"([[["N","W"], ["N","E"]], [["E","S","W"], ["S","W","E"]]])",
           R"({"width": 2, "height": 2, "cells": [{"x":0,"y":0,"walls":"ESW"}, {"x":1,"y":0,"walls":"SEW"},
               {"x":0,"y":1,"walls":"NW"}, {"x":1,"y":1,"walls":["north","east"]}]})",
           R"([{"x":1,"y":1,"n":true,"e":true,"s":false,"w":false}, {"x":0,"y":1,"n":true,"e":false,"s":false,"w":true},
               {"x":0,"y":0,"n":false,"e":true,"s":true,"w":true}, {"x":1,"y":0,"n":false,"e":true,"s":true,"w":true}])",
           "[[9 3]\n [14 14]]\n",
           "[[ 9.  3.]\n [14. 14.]]\n",
           "[[9.0, 3.0], [14.0, 14.0]]",
           "9,3\n14,14\n",
           "9\t3\n14\t14\n",
           "y;x;N;E;S;W\n0;0;1;0;0;1\n0;1;1;1;0;0\n1;0;0;1;1;1\n1;1;0;1;1;1\n",
           "0e 09 0e 03\n",
           "00000000: 0e09 0e03                                ....\n",
           "00000000  0e 09 0e 03                                       |....|\n00000004\n",
           "93\nEe\n",
           "#####\n#   #\n# # #\n# # #\n#####\n",
           "11111\n10001\n10101\n10101\n11111\n",
           "[[1,1,1,1,1],[1,0,0,0,1],[1,0,1,0,1],[1,0,1,0,1],[1,1,1,1,1]]",
           "0 0 0 0 0\n0 1 1 1 0\n0 1 0 1 0\n0 1 0 1 0\n0 0 0 0 0\n",
       }) {
    const ReadResult read = read_maze(text);
    EXPECT_EQ(read.maze, maze) << text << '\n' << read.reading << testing::PrintToString(test::lines_of(read));
    EXPECT_THAT(read.reading, testing::HasSubstr("2x2"));
  }
}

TEST(FieldFormats, AreRefusedWhereTheyHoldNoMaze) {
  for (const std::string_view text : {
           "[]",
           "{}",
           "[[]]",
           "[1]",
           "[[1, 2], [3]]",
           "[[0, 0], [0, 0]]",
           "[\"once\", \"upon\"]",
           "[[[[[[[1]]]]]]]",
           "{\"a\": 1}",
           "int m[2][2] = {{WALL_N, 9}, {12, 3}};",
           "[[14, 9], [12, 3]",
           "const char* s = \"{\";",
           "{\"x\": [1, 2, 3, 4]}",
           "[{\"x\": 70, \"y\": 0, \"walls\": 3}]",
           "1,2\n3,4\n",
           "9\n3\n",
           "abc\n",
           "0e 09 0c\n",
           "12\n34\n",
       }) {
    const ReadResult read = read_maze(text);
    EXPECT_FALSE(read.maze) << text << '\n' << read.reading;
    EXPECT_FALSE(read.problems.empty()) << text;
  }
}

// What a format finds wrong with what only begins as its files do.
TEST(FieldFormats, SayWhatIsWrongWithWhatIsCut) {
  for (const auto& [text, at, word] : std::initializer_list<std::array<std::string_view, 3>>{
           {"9553\naaba\nc4\n", "3:1", "2 characters"},
           {"9553\naaba\nc4x6\n", "3:3", "'x'"},
           {"#####\n#   #\n", "1:1", "odd"},
           {"#####\n#   #\n# #\n", "3:1", "3 characters"},
           {"0;0;1;0;0;1\n0;1;1;1;0;0\n1;0;0;1;1;1\n1;1;0;1;1;1\n2;0;1\n", "5:1", "found 3"},
           {"0;0;1;0;0;1\n0;1;1;1;0;0\n1;0;0;1;1;1\n1;1;0;1;1;1\nend\n", "5:1", "whole numbers"},
           {"0;0;1;0;0;1\n0;1;1;1;0;0\n1;0;0;1;1;1\n", "0:0", "missing"},
           {"0;0;1;0;0;1\n0;1;1;1;0;0\n1;0;0;1;1;1\n1;0;0;1;1;1\n", "4:1", "line 3"},
           {R"([{"x":0,"y":0,"walls":"SEW"},{"x":0,"y":0,"walls":"SEW"},{"x":1,"y":1,"walls":"NE"}])", "1:30", "twice"},
           {R"([{"x":0,"y":0,"walls":"SEW"},{"x":1,"y":1,"walls":"NE"},{"x":0,"y":1,"walls":"NW"}])", "0:0", "missing"},
           {"11111\n10001\n10101\n10101\n11011\n", "1:1", "no order"},
           {"int m[] = {14, 9,\n", "1:11", "no end"},
           {"[[\"NW\", \"N", "1:9", "no end in its line"},
           {"[[1.5, 9], [14, 3]]", "1:3", "'1.5'"},
           {"[[-1, 9], [14, 3]]", "1:3", "'-1'"},
           {"int m[2][2] = {{WALL_N, 9}, {14, 3}};", "1:17", "'WALL_N'"},
           {"[[null, 9], [14, 3]]", "1:3", "'null'"},
       })
    EXPECT_THAT(test::lines_of(read_maze(text)), ElementsAre(test::SaysAt(std::string(at), std::string(word)))) << text;
}

TEST(FieldFormats, SayThatThereAreSeveralLists) {
  const ReadResult read = read_maze("int a[] = {14, 9, 14, 3}; int b[] = {14, 9, 14, 3}; int c[] = {1, 2};");
  EXPECT_TRUE(read.maze);
  EXPECT_THAT(read.notes, ElementsAre(Says("2 lists", "first")));
}

TEST(FieldFormats, SayWhereTheirWallsContradictEachOther) {
  EXPECT_THAT(test::lines_of(read_maze("int m[2][2] = {\n {14, 9},\n {13, 3}};")),
              ElementsAre(test::SaysAt("3:3", "(1,0)", "border"), test::SaysAt("3:7", "(1,1)", "(1,0)")));
}

// The content of a format with one letter replaced; lines and columns count from 0.
std::string with_letter(std::string content, std::size_t line, std::size_t column, char letter) {
  std::size_t at = 0;
  for (; line > 0; --line) at = content.find('\n', at) + 1;
  content.at(at + column) = letter;
  return content;
}

// A hexadecimal digit of a row with one of its bits flipped.
std::string with_flipped_wall(const std::string& rows, Size size, Cell cell, Heading side) {
  const auto line = static_cast<std::size_t>(size.height - 1 - cell.y), column = static_cast<std::size_t>(cell.x);
  const char digit = rows.at(line * static_cast<std::size_t>(size.width + 1) + column);
  const int value = digit >= 'a' ? digit - 'a' + 10 : digit - '0';
  return with_letter(rows, line, column, "0123456789abcdef"[value ^ 1 << static_cast<int>(side)]);
}

TEST(BorderGaps, AreClosedOrTheStartAndTheGoal) {
  const Maze maze = usual_maze({6, 5}, 3);
  std::string hex = hex_format.write(maze).content.value(), blocks = blocks_format.write(maze).content.value();
  hex = with_flipped_wall(hex, maze.size(), {5, 2}, Heading::east);
  hex = with_flipped_wall(hex, maze.size(), {4, 0}, Heading::south);
  blocks = with_letter(with_letter(blocks, 5, 12, ' '), 10, 9, ' ');
  const ReadChoice places{.gaps_are_places = true};
  for (const std::string& content : {hex, blocks}) {
    const ReadResult read = read_maze(content);
    EXPECT_EQ(read.maze, maze) << content;
    EXPECT_THAT(read.notes, ElementsAre(Says("east of (5,2)", "south of (4,0)")));
    const ReadResult between = read_maze(content, places);
    ASSERT_TRUE(between.maze);
    EXPECT_THAT(between.notes, IsEmpty());
    EXPECT_EQ(between.maze->open_walls(), maze.open_walls());
    EXPECT_EQ(between.maze->start(), (Cell{4, 0}));
    EXPECT_EQ(between.maze->start_heading(), Heading::north);
    EXPECT_EQ(between.maze->goals().count(), 1);
    EXPECT_TRUE(between.maze->is_goal({5, 2}));
  }
  EXPECT_FALSE(read_maze(hex_format.write(maze).content.value(), places).maze);
  EXPECT_FALSE(read_maze(with_flipped_wall(hex, maze.size(), {0, 0}, Heading::west)).maze);
  EXPECT_FALSE(read_maze(with_letter(blocks, 0, 1, ' ')).maze);
  // Three cells of a small list would fit too often.
  EXPECT_FALSE(read_maze("93\nea\n").maze);
}

TEST(Contradictions, AreRepairedOnRequest) {
  const Maze maze = usual_maze({8, 7}, 5);
  const Wall wall{{0, 6}, Heading::east};  // is open
  const std::string hex = with_flipped_wall(hex_format.write(maze).content.value(), maze.size(), {1, 6}, Heading::west);
  const Notation notation{
      .order = {Heading::west, Heading::south, Heading::east, Heading::north}, .columns = true, .from_north = false};
  std::string list = list_of(maze, notation);
  const unsigned number = number_of(maze, {0, 6}, notation);
  const std::size_t end = list.find(']'), begin = list.rfind(' ', end) + 1;  // the last number of the first column
  list.replace(begin, end - begin, std::to_string(number ^ 4U));
  for (const std::string& content : {hex, list}) {
    const ReadResult read = read_maze(content);
    EXPECT_FALSE(read.maze) << read.reading;
    EXPECT_THAT(test::lines_of(read), ElementsAre(Says("(0,6)", "(1,6)")));
    const ReadResult repaired = read_maze(content, {.repaired = true});
    ASSERT_TRUE(repaired.maze);
    EXPECT_THAT(repaired.notes, testing::Contains(Says("(0,6)", "(1,6)", "closed")));
    EXPECT_FALSE(repaired.maze->is_open(wall.cell, wall.side));
    WallSet open = repaired.maze->open_walls();
    open.insert(wall);
    EXPECT_EQ(open, maze.open_walls());
  }
  // Two walls of twelve cells are too many.
  EXPECT_FALSE(read_maze("9513\naaea\ncc46\n", {.repaired = true}).maze);
}

TEST(ReadChoice, TransposesAndNamesTheFormat) {
  const Maze maze = usual_maze({6, 5}, 7);
  const std::string content = num_format.write(maze).content.value();
  const ReadResult read = read_maze(content, {.format = &num_format, .transposed = true});
  ASSERT_TRUE(read.maze);
  EXPECT_EQ(read.maze->size(), (Size{5, 6}));
  EXPECT_EQ(read.maze->start_heading(), Heading::north);
  EXPECT_EQ(read.maze->goals(), centre_of({5, 6}));
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 5; ++y) {
      EXPECT_EQ(read.maze->is_open({y, x}, Heading::east), maze.is_open({x, y}, Heading::north));
      EXPECT_EQ(read.maze->is_open({y, x}, Heading::north), maze.is_open({x, y}, Heading::east));
    }
  EXPECT_FALSE(read_maze(content, {.format = &hex_format}).maze);
}

TEST(PartialMaps, KnowWhichWallsWereNotSeen) {
  const ReadResult read = read_maze("o---o---o\n|  1:  0|\no   o\xC2\xB7\xC2\xB7\xC2\xB7o\n|  2|  1|\no---o---o\n");
  EXPECT_FALSE(read.maze);
  EXPECT_THAT(test::lines_of(read), ElementsAre(test::SaysAt("0:0", "partial map", "2 of 4")));
  ASSERT_TRUE(read.partial);
  EXPECT_EQ(read.partial->unseen.count(), 2);
  EXPECT_TRUE(read.partial->unseen.contains({{0, 1}, Heading::east}));
  EXPECT_TRUE(read.partial->unseen.contains({{1, 0}, Heading::north}));
  EXPECT_FALSE(read.partial->known.is_open({0, 0}, Heading::east));
}

TEST(PartialMaps, AreMazesWhereTheirUnseenWallsAreClosed) {
  const ReadResult read = read_maze("o---o---o---o\n| S   G :   |\no---o---o---o\n", {.closes_unseen = true});
  EXPECT_EQ(read.maze, test::maze_of(drawing_format, "o---o---o---o\n| S   G |   |\no---o---o---o\n"));
  EXPECT_THAT(read.notes, ElementsAre(Says("1 of 2", "closed")));
  EXPECT_THAT(read.problems, IsEmpty());
  ASSERT_TRUE(read.partial);
  EXPECT_TRUE(read.partial->unseen.contains({{1, 0}, Heading::east}));
}

TEST(PartialMaps, AreReadFromLogs) {
  for (const std::string_view text :
       {"0 0 N 101\n0 1 N 110\n", "0 0 E 0111\n0 1 S 1??1\n0 1 S 0??\n",
        "x y heading walls\n0 0 north 101\n0,1;n;110\n",
        "Step 0: Pos=[0, 0] Facing=N Walls=101 Move=001\nStep 1: Pos=[0, 1] Facing=N Walls=110\n"}) {
    const ReadResult read = read_maze(text);
    ASSERT_TRUE(read.partial) << text << testing::PrintToString(test::lines_of(read));
    EXPECT_EQ(read.partial->known,
              test::maze_of(drawing_format, "o---o---o\n|       |\no   o   o\n|   |   |\no---o---o\n"));
    EXPECT_EQ(read.partial->unseen.count(), 1);
  }
  EXPECT_THAT(test::lines_of(read_maze("0 0 N 101\n1 0 N 001\n")), ElementsAre(test::SaysAt("2:1", "(1,0)", "west")));
  EXPECT_THAT(test::lines_of(read_maze("0 0 N 001\n")), ElementsAre(test::SaysAt("1:1", "(0,0)", "west", "border")));
}

TEST(PartialMaps, AreReadFromLogsWithoutCellsOutsideOfTheMaze) {
  for (const std::string_view text : {"0 -1 N 101\n", "-1 0 N 101\n", "0 64 N 101\n"})
    EXPECT_FALSE(read_maze(text, {.format = &steps_format}).partial) << text;
}

TEST(PartialMaps, AreWrittenAsDrawings) {
  const std::string_view drawing = "o---o---o---o\n|   : G :   |\no   o...o...o\n| S | G     |\no---o---o---o\n";
  const ReadResult read = read_maze(drawing);
  ASSERT_TRUE(read.partial);
  EXPECT_EQ(write_partial_map(*read.partial).content, drawing);
}

TEST(PartialMaps, AreComparedWithTheMaze) {
  const Maze maze = test::random_maze({5, 4}, 2, 4);
  EXPECT_FALSE(compare_maps(maze, {}, test::random_maze({4, 4}, 2, 4)));
  MazeDraft draft({5, 4}, MazeDraft::Inside::closed);
  maze.open_walls().for_each([&](Wall wall) { draft.open(wall.cell, wall.side); });
  const Wall changed{{2, 1}, Heading::north}, other{{3, 2}, Heading::east}, third{{0, 0}, Heading::east};
  const bool was_open = maze.is_open(changed.cell, changed.side);
  was_open ? draft.close(changed.cell, changed.side) : draft.open(changed.cell, changed.side);
  WallSet unseen;
  unseen.insert(other);
  draft.open(other.cell, other.side);
  maze.is_open(third.cell, third.side) ? draft.close(third.cell, third.side) : draft.open(third.cell, third.side);
  const auto found = compare_maps(Maze(draft), unseen, maze);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->unseen, unseen);
  EXPECT_EQ((was_open ? found->false_walls : found->missed_walls).contains(changed), true);
  EXPECT_EQ((maze.is_open(third.cell, third.side) ? found->false_walls : found->missed_walls).contains(third), true);
  EXPECT_EQ(found->false_walls.count() + found->missed_walls.count(), 2);
}

// The small inputs from the field beside the checkout, each of one of two mazes.
TEST(FieldFormats, AreTheMazesThatTheCasesSay) {
  const std::filesystem::path cases = test::folder_of_mazes() / "../cases/mazes";
  std::error_code missing;
  std::filesystem::directory_iterator files(cases, missing);
  if (missing) GTEST_SKIP() << "no folder " << cases;
  const std::array mazes = {test::maze_in_file(LABMOUSE_SOURCE_DIR "/mazes/halls-12.txt"),
                            test::maze_in_file(test::folder_of_mazes() / "classic/87us1.txt")};
  for (const auto& file : files) {
    const std::string name = file.path().filename().string();
    const Maze* maze = name.starts_with("halls-12.") ? &*mazes[0] : name.starts_with("87us1.") ? &*mazes[1] : nullptr;
    if (maze == nullptr) continue;
    const ReadResult read = read_maze(test::text_of(file.path()));
    if (name.find(".steps.") == std::string::npos) {
      EXPECT_EQ(read.maze, *maze) << name;
      continue;
    }
    ASSERT_TRUE(read.partial) << name;
    const auto found = compare_maps(read.partial->known, read.partial->unseen, *maze);
    EXPECT_TRUE(found && found->false_walls.empty() && found->missed_walls.empty()) << name;
  }
  const auto gaps = test::maze_in_file(cases / "border-gaps.txt"),
             arrows = test::maze_in_file(cases / "print-maze-arrows.txt");
  const ReadResult partial = read_maze(test::text_of(cases / "partial-print-maze.txt"));
  ASSERT_TRUE(gaps && arrows && partial.partial);
  EXPECT_EQ(partial.partial->unseen.count(), 19);
  EXPECT_EQ(gaps->size(), (Size{5, 5}));
  EXPECT_EQ(arrows->size(), (Size{4, 2}));
  EXPECT_TRUE(arrows->is_goal({2, 0}));
}

}  // namespace
}  // namespace labmouse
