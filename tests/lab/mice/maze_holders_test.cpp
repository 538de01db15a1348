#include "labmouse/lab/mice/maze_holders.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "labmouse/lab/mice/contestant.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Not;

class MazeHolders : public testing::Test {
 protected:
  MazeHolders() {
    fs::create_directories(folder_);
    folder_ = fs::canonical(folder_);
  }
  ~MazeHolders() override { fs::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& content) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }

  fs::path folder_ = fs::temp_directory_path() / ("labmouse-holders-" + std::to_string(getpid()));
};

constexpr const char* drawing = "o---o---o\n| S   G |\no---o---o\n";

TEST_F(MazeHolders, AreKnownByTheirContent) {
  EXPECT_TRUE(holds_maze(file("drawing.txt", drawing)));
  EXPECT_TRUE(holds_maze(file("maze.maz", std::string(256, '\x0f'))));
  EXPECT_TRUE(holds_maze(file("record.jsonl", R"({"labmouse":"record","format":1})")));
  EXPECT_TRUE(holds_maze(file("results.db", std::string("SQLite format 3\0 and more", 25))));
  EXPECT_TRUE(holds_maze(file("walk.svg", "<?xml version='1.0'?><svg/>")));
  EXPECT_TRUE(holds_maze(file("report.html", "<!doctype html>")));
  EXPECT_TRUE(holds_maze(file("report.htm", "<!doctype html>")));
  EXPECT_TRUE(holds_maze(file("picture.SVG", "<?xml version='1.0'?><svg/>")));
  EXPECT_TRUE(holds_maze(file("saved.txt", "\xef\xbb\xbf\n<!DOCTYPE HTML>")));
  EXPECT_TRUE(holds_maze(file("drawn", "<?xml version='1.0'?>\n<!-- by hand -->\n<svg/>")));
  EXPECT_TRUE(holds_maze(file("labmouse_core.wasm", "asm")));
  EXPECT_TRUE(holds_maze(file("builtin_mazes.cpp", "// Mazes")));
  EXPECT_FALSE(holds_maze(file("pages.py", "import sys\nHTML = '<!DOCTYPE html><svg>'\n")));
  EXPECT_FALSE(holds_maze(file("robot.py", "class Robot(object):\n    pass\n")));
  EXPECT_FALSE(holds_maze(file("settings.json", R"({"speed": 3})")));
  EXPECT_FALSE(holds_maze(file("program", std::string("\x7f\x45LF\0\0\0", 7))));
  EXPECT_FALSE(holds_maze(file("empty.txt", "")));
  EXPECT_FALSE(holds_maze((folder_ / "nowhere").string()));
}

TEST_F(MazeHolders, AreHiddenWhereverTheyLieInAFolder) {
  const std::string near = file("maze.txt", drawing), far = file("old/mazes/maze.txt", drawing);
  const std::string robot = file("robot.py", "pass\n"), other = file("node_modules/maze.txt", drawing);
  HiddenFiles hidden;
  hide_mazes_in(folder_.string(), hidden);
  EXPECT_THAT(*hidden.paths(),
              testing::AllOf(Contains(near), Contains(far), Not(Contains(robot)), Not(Contains(other))));
  // Each folder once.
  file("later.txt", drawing);
  const auto before = hidden.paths();
  hide_mazes_in(folder_.string(), hidden);
  EXPECT_EQ(hidden.paths(), before);
  hide_mazes_in("", hidden);
  EXPECT_THAT(hidden.unsearched(), testing::IsEmpty());
}

TEST_F(MazeHolders, AreNotAllFoundAmongTooManyFiles) {
  for (int i = 0; i < most_searched; ++i) file("data/" + std::to_string(i), "x");
  HiddenFiles hidden;
  hide_mazes_in((folder_ / "data").string(), hidden);
  EXPECT_THAT(hidden.unsearched(), testing::IsEmpty());
  file("one-more", "x");
  hide_mazes_in(folder_.string(), hidden);
  EXPECT_THAT(hidden.unsearched(), testing::ElementsAre(folder_.string()));
  Contestant mouse;
  mouse.sandboxed = true;
  mouse.hidden = std::make_shared<HiddenFiles>();
  EXPECT_EQ(freedom_note({mouse}), "");
  mouse.hidden->note_unsearched("/home/class");
  EXPECT_THAT(freedom_note({mouse}), testing::HasSubstr("/home/class"));
}

}  // namespace
}  // namespace labmouse
