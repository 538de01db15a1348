// Which format a content is taken for, and what is said when there is none.
#include "labmouse/maze/formats/format.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/maze/problem_lines.hpp"
#include "tests/maze/random_maze.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::SaysAt;
using testing::ElementsAre;

// The name of the one format that recognises the content, or "none".
std::string format_of(std::string_view content) {
  std::string names;
  for (const Format* format : all_formats())
    if (format->recognises(content)) names += format->name;
  return names.empty() ? "none" : names;
}

TEST(AllFormats, AreFoundByTheirNames) {
  for (const Format* format : all_formats()) EXPECT_EQ(find_format(format->name), format);
  EXPECT_EQ(all_formats().size(), 11U);
  EXPECT_EQ(find_format("Maz"), nullptr);
  EXPECT_EQ(find_format(""), nullptr);
}

TEST(AllFormats, BelongToExtensions) {
  for (const Format* format : all_formats()) {
    const Format* const of_file = format_of_file("a.b/maze" + std::string(format->extension));
    EXPECT_TRUE(of_file == format || format->extension == ".txt") << format->name;
  }
  for (const char* name : {"maze", "maze.txt", "maze.maze", "folder.num/maze", ".num", "a/.num"})
    EXPECT_EQ(format_of_file(name), &drawing_format) << name;
  EXPECT_EQ(format_of_file("maze.c"), &c_format);
  EXPECT_EQ(format_of_file("maze.xyz"), nullptr);
}

TEST(AllFormats, RecogniseWhatTheyWriteAndNothingElse) {
  const Maze maze = test::random_maze({16, 16}, 1, 4);
  for (const Format* format : all_formats()) EXPECT_EQ(format_of(format->write(maze).content.value()), format->name);
}

TEST(AllFormats, RecogniseBrokenContentByItsFirstLine) {
  EXPECT_EQ(format_of("o---o   o\n"), "drawing");
  EXPECT_EQ(format_of("\xEF\xBB\xBF+---+\r\n"), "drawing");
  EXPECT_EQ(format_of("o"), "drawing");
  EXPECT_EQ(format_of("99\r\n"), "capstone");
  EXPECT_EQ(format_of("1,5,7,5\n"), "capstone");
  EXPECT_EQ(format_of("0 0 1 1 1\n"), "num");
}

TEST(AllFormats, LeaveOtherTextAlone) {
  for (const std::string_view text :
       {"once upon a time", "<html>", "\n12\n0", "|   |", "12.5", "-----", ",,,", "\xFF\xFE", "(see below", "a;b\n1;2"})
    EXPECT_EQ(format_of(text), "none") << text;
}

TEST(AllFormats, DoNotTakeATextOf256BytesForMaz) {
  std::string capstone = "12\n";
  capstone.resize(256, ' ');
  EXPECT_EQ(format_of(capstone), "capstone");
  EXPECT_EQ(format_of(std::string(256, 'x')), "none");
  EXPECT_EQ(format_of(std::string(256, char{15})), "maz");
}

TEST(ReadMaze, SaysWhatItExpected) {
  const auto result = read_maze("once upon a time\n");
  EXPECT_FALSE(result.maze);
  EXPECT_THAT(test::lines_of(result), ElementsAre(SaysAt("0:0", "not a maze", "drawing")));
}

TEST(ReadMaze, SaysThatAFileIsEmpty) {
  for (const std::string_view text : {"", "\n", " \t\r\n\n", "\xEF\xBB\xBF"})
    EXPECT_THAT(test::lines_of(read_maze(text)), ElementsAre(SaysAt("0:0", "empty"))) << text;
  EXPECT_THAT(test::lines_of(read_maze(std::string(256, '\n'))), ElementsAre(SaysAt("0:0", "empty")));
}

TEST(ReadMaze, PassesOnWhatTheFormatFinds) {
  EXPECT_THAT(test::lines_of(read_maze("1\n2\n")), ElementsAre(SaysAt("2:1", "(0,0)", "east", "border")));
}

TEST(ReadMaze, SurvivesLargeContent) {
  constexpr std::size_t size = test::sanitized ? 500'000 : 5'000'000;
  for (const char letter : {'\0', '\n', ' ', ',', '1', 'o', '-', '\xFF'})
    EXPECT_FALSE(read_maze(std::string(size, letter)).maze);
  EXPECT_FALSE(read_maze("2\n" + std::string(size, ',')).maze);
  EXPECT_FALSE(read_maze("0 0 " + std::string(size, '1')).maze);
  EXPECT_FALSE(read_maze("0 0 1 1 1 1" + std::string(size, '\n') + "1 0").maze);
}

}  // namespace
}  // namespace labmouse
