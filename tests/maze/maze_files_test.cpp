// Reads every maze of a folder: LABMOUSE_MAZES, or ../shared/mazes beside the checkout. Skipped where there is none.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "labmouse/maze/formats/format.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/maze/problem_lines.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::maze_files;

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class MazeFiles : public testing::Test {
 protected:
  void SetUp() override {
    if (maze_files().empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  }
};

TEST_F(MazeFiles, AreAllRead) {
  for (const auto& file : maze_files()) EXPECT_EQ(test::lines_of(read_maze(content_of(file))), test::Lines{}) << file;
}

TEST_F(MazeFiles, SurviveEveryFormatThatHoldsThem) {
  int number = 0;
  for (const auto& file : maze_files()) {
    if (test::briefly_sanitized && number++ % 10 != 0) continue;
    const auto maze = read_maze(content_of(file)).maze;
    if (!maze) continue;
    for (const Format* format : all_formats()) {
      const auto written = format->write(*maze);
      if (!written.content) continue;
      EXPECT_EQ(read_maze(*written.content).maze, maze) << file << " as " << format->name;
    }
    EXPECT_TRUE(drawing_format.write(*maze).content) << file;
  }
}

}  // namespace
}  // namespace labmouse
