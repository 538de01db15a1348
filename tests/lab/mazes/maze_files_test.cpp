#include "labmouse/lab/mazes/maze_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::SaysAt;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* good = "o---o---o\n| S   G |\no---o---o\n";

/// An empty folder that goes away with the test.
class AFolder : public testing::Test {
 protected:
  AFolder() { std::filesystem::create_directories(folder_ / "inner"); }
  ~AFolder() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name = "") const { return (folder_ / name).string(); }
  std::string file(const std::string& name, const std::string& content = good) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  MazeCollection load(const std::vector<std::string>& paths) const { return load_mazes(paths); }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() /
      ("labmouse-" + std::to_string(getpid()) + "-" + testing::UnitTest::GetInstance()->current_test_info()->name());
};

std::vector<std::string> names(const MazeCollection& collection) {
  std::vector<std::string> list;
  for (const NamedMaze& maze : collection.mazes) list.push_back(maze.name);
  return list;
}

std::vector<std::string> paths(const std::vector<SkippedFile>& files) {
  std::vector<std::string> list;
  for (const SkippedFile& file : files) list.push_back(file.path);
  return list;
}

TEST_F(AFolder, IsReadWithAllThatIsInIt) {
  const std::string b = file("b.txt"), a = file("a.txt"), inner = file("inner/c.txt");
  EXPECT_THAT(names(load({path("")})), ElementsAre(a, b, inner));
}

TEST_F(AFolder, HidesHiddenFiles) {
  file(".hidden.txt");
  std::filesystem::create_directories(folder_ / ".git");
  file(".git/config", "rubbish");
  const MazeCollection collection = load({path("")});
  EXPECT_THAT(names(collection), IsEmpty());
  EXPECT_THAT(collection.skipped, IsEmpty());
}

TEST_F(AFolder, SkipsABadFileAndSaysWhy) {
  const std::string fine = file("fine.txt"), bad = file("bad.txt", "o---o\n| S X\n");
  const MazeCollection collection = load({path("")});
  EXPECT_THAT(names(collection), ElementsAre(fine));
  EXPECT_THAT(paths(collection.skipped), ElementsAre(bad));
  EXPECT_THAT(collection.skipped[0].problems, ::testing::Not(IsEmpty()));
  EXPECT_THAT(collection.errors, IsEmpty());
}

TEST_F(AFolder, ABadFileNamedDirectlyIsAnError) {
  const std::string bad = file("bad.txt", "rubbish");
  const MazeCollection collection = load({bad});
  EXPECT_THAT(paths(collection.errors), ElementsAre(bad));
  EXPECT_THAT(collection.skipped, IsEmpty());
}

TEST_F(AFolder, APatternNamesSeveralFiles) {
  const std::string a1 = file("a1.txt"), a2 = file("a2.txt");
  file("b1.txt");
  EXPECT_THAT(names(load({path("a?.txt")})), ElementsAre(a1, a2));
  EXPECT_THAT(names(load({path("a*")})), ElementsAre(a1, a2));
}

TEST_F(AFolder, ABadFileFoundByAPatternIsSkipped) {
  const std::string fine = file("a1.txt"), bad = file("a2.txt", "rubbish");
  const MazeCollection collection = load({path("a*")});
  EXPECT_THAT(names(collection), ElementsAre(fine));
  EXPECT_THAT(paths(collection.skipped), ElementsAre(bad));
}

TEST_F(AFolder, WhatMatchesNothingIsAnError) {
  EXPECT_THAT(paths(load({path("none*")}).errors), ElementsAre(path("none*")));
  EXPECT_THAT(paths(load({path("none.txt")}).errors), ElementsAre(path("none.txt")));
}

TEST_F(AFolder, AFileNamedTwiceIsReadOnce) {
  const std::string a = file("a.txt"), b = file("b.txt");
  EXPECT_THAT(names(load({b, a, b, path("*.txt")})), ElementsAre(a, b));
  const std::string open = file("open.txt", "o---o---o\n| S   G  \no---o---o\n");
  EXPECT_THAT(load({open, path(), open}).notes, SizeIs(1));
}

TEST_F(AFolder, AFileWinsOverABuiltInMaze) {
  const std::string here = std::filesystem::current_path().string();
  file("capstone-1");
  std::filesystem::current_path(folder_);
  const MazeCollection collection = load({"capstone-1"});
  std::filesystem::current_path(here);
  EXPECT_EQ(collection.mazes.at(0).maze.size(), (Size{2, 1}));
}

TEST_F(AFolder, AFileThatIsTooLargeIsRefusedUnread) {
  const std::string large = file("large.txt", std::string(2U << 20U, 'o'));
  EXPECT_THAT(describe(large, load({large}).errors.at(0).problems.at(0)), HasSubstr("too large"));
}

TEST_F(AFolder, LinksInACircleDoNoHarm) {
  const std::string a = file("a.txt");
  std::filesystem::create_directory_symlink(folder_, folder_ / "inner" / "circle");
  EXPECT_THAT(names(load({path("")})), ElementsAre(a));
}

TEST(BuiltinMazes, AreFoundByTheirNames) {
  const std::vector<std::string> name = {"capstone-1"};
  EXPECT_THAT(names(load_mazes(name)), ElementsAre("capstone-1"));
}

TEST(BuiltinMazes, AMistypedNameIsAnErrorWithAHint) {
  const std::vector<std::string> name = {"capston-1"};
  EXPECT_THAT(load_mazes(name).errors.at(0).problems.at(0).reason, HasSubstr("'capstone-1'"));
}

TEST(BuiltinMazes, AreAllThoseOfTheFolder) {
  std::size_t files = 0;
  for (const auto& file : std::filesystem::directory_iterator(LABMOUSE_SOURCE_DIR "/mazes"))
    if (file.path().extension() == ".txt") ++files;
  EXPECT_EQ(builtin_mazes().size(), files);
  EXPECT_EQ(load_builtin_mazes().mazes.size(), files);
}

TEST(Describe, NamesFileLineAndColumn) {
  EXPECT_EQ(describe("a.txt", {2, 5, "is odd"}), "a.txt:2:5: error: is odd");
  EXPECT_EQ(describe("a.txt", {0, 0, "is odd as a whole"}), "a.txt: error: is odd as a whole");
}

TEST(Describe, NamesNoPlaceInAFileThatWasNotRead) {
  const std::vector<std::string> nothing = {"no-such-file.txt"};
  EXPECT_THAT(describe("no-such-file.txt", load_mazes(nothing).errors.at(0).problems.at(0)),
              SaysAt("no-such-file.txt", "no such"));
}

TEST(Describe, KeepsForeignNamesFromSteeringATerminal) {
  EXPECT_EQ(describe("a\n\x1b[31m.txt", {2, 5, "is odd"}), "a [31m.txt:2:5: error: is odd");
}

}  // namespace
}  // namespace labmouse
