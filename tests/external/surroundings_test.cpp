#include "labmouse/external/surroundings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "labmouse/external/hidden_files.hpp"
#include "tests/external/bad_programs.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Not;
using testing::Pair;

class ItsSurroundings : public testing::Test {
 protected:
  ItsSurroundings() {
    fs::create_directories(folder_ / "mice");
    folder_ = fs::canonical(folder_);
  }
  ~ItsSurroundings() override { fs::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& content = "") const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << content;
    return folder_ / name;
  }
  Surroundings of(std::vector<std::string> words, const std::string& program) const {
    Launch launch;
    launch.words = std::move(words);
    launch.directory = folder_;
    return surroundings_of(launch, program);
  }

  fs::path folder_ = fs::temp_directory_path() / ("labmouse-around-" + test::tag());
};

TEST_F(ItsSurroundings, AreTheFolderOfTheFileThatItsCommandNames) {
  file("mice/mouse.py");
  const Surroundings around = of({"python3", "mice/mouse.py"}, "/usr/bin/python3");
  EXPECT_EQ(around.folder, folder_ / "mice");
  EXPECT_EQ(around.directory, folder_);
  EXPECT_THAT(around.visible, Contains("/usr"));
  EXPECT_THAT(around.visible, Not(Contains(folder_.string())));
  EXPECT_EQ(of({"./mice/mouse", "fast"}, file("mice/mouse")).folder, folder_ / "mice");
}

TEST_F(ItsSurroundings, AreItsDirectoryWhereItOwnsThat) {
  Launch launch;
  launch.words = {"python3", "mice/mouse.py"};
  file("mice/mouse.py");
  launch.directory = folder_;
  launch.owns_directory = true;
  EXPECT_EQ(folder_of(launch, "/usr/bin/python3"), folder_);
  launch.words = {"python3", "-m", "mouse"};
  launch.owns_directory = false;
  EXPECT_EQ(folder_of(launch, "/usr/bin/python3"), folder_);
}

TEST_F(ItsSurroundings, HaveAllThatAnInterpreterIsInstalledWith) {
  // A virtual environment beside the mouse, made from a Python elsewhere.
  file("base/bin/python3");
  file("base/lib/python3/os.py");
  file("env/pyvenv.cfg", "home = " + (folder_ / "base" / "bin").string() + "\n");
  fs::create_directories(folder_ / "env" / "bin");
  fs::create_symlink(folder_ / "base" / "bin" / "python3", folder_ / "env" / "bin" / "python3");
  file("mice/mouse.py");
  const std::string python = folder_ / "env" / "bin" / "python3";
  const Surroundings around = of({"env/bin/python3", "mice/mouse.py"}, python);
  EXPECT_EQ(around.folder, folder_ / "mice");
  EXPECT_THAT(around.visible,
              testing::AllOf(Contains((folder_ / "env").string()), Contains((folder_ / "base").string())));
}

TEST_F(ItsSurroundings, DoNotHaveFoldersThatAMouseNamesAsInstallations) {
  file("mazes/bin/notes.txt");
  file("mice/pyvenv.cfg", "home = " + (folder_ / "mazes" / "bin").string() + "\n");
  const std::string python = file("mice/bin/python3", "#!" + (folder_ / "mazes/bin/sh").string() + "\n");
  const Surroundings around = of({"mice/bin/python3", "mouse.py"}, python);
  EXPECT_THAT(around.visible, Not(Contains((folder_ / "mazes").string())));
}

TEST_F(ItsSurroundings, KeepTheLinksThatLeadThere) {
  fs::create_directory_symlink(folder_ / "mice", folder_ / "link");
  file("mice/table.txt");
  EXPECT_THAT(of({"sh", "-c", "true", "link/table.txt"}, "/bin/sh").folder, (folder_ / "mice").string());
  file("tables/table.txt");
  fs::create_directory_symlink(folder_ / "mice" / ".." / "tables", folder_ / "more");
  file("mice/mouse.sh");
  const Surroundings around = of({"sh", "mice/mouse.sh", "more/table.txt"}, "/bin/sh");
  EXPECT_THAT(around.visible, Contains((folder_ / "tables" / "table.txt").string()));
  EXPECT_THAT(around.links, Contains(Pair((folder_ / "more").string(), (folder_ / "tables").string())));
}

TEST_F(ItsSurroundings, HideWhatHoldsOurMazes) {
  file("env/bin/python3");
  file("env/bin/labmouse");
  file("env/lib/python3.11/site-packages/labmouse/_native.so");
  file("env/lib/liblabmouse_lab.so");
  file("env/lib/python3.11/site-packages/numpy/__init__.py");
  const Surroundings around = of({"env/bin/python3"}, folder_ / "env" / "bin" / "python3");
  EXPECT_THAT(around.hidden, Contains((folder_ / "env/bin/labmouse").string()));
  EXPECT_THAT(around.hidden, Contains((folder_ / "env/lib/python3.11/site-packages/labmouse").string()));
  EXPECT_THAT(around.hidden, Contains((folder_ / "env/lib/liblabmouse_lab.so").string()));
  EXPECT_THAT(around.hidden, Not(Contains(testing::HasSubstr("numpy"))));
}

TEST_F(ItsSurroundings, DoNotHaveWhatLiesElsewhere) {
  file("mice/mouse.sh");
  const Surroundings around = of({"sh", "mice/mouse.sh"}, "/bin/sh");
  const std::vector<std::string> paths = {(folder_ / "mice/maze.txt").string(), (folder_ / "maze.txt").string(),
                                          "/usr/share/maze.txt"};
  EXPECT_EQ(seen_of(around, paths), (std::vector<std::string>{paths[0], paths[2]}));
}

TEST(HiddenFiles, AreThereUnderEachOfTheirNames) {
  const fs::path folder = fs::temp_directory_path() / ("labmouse-hidden-" + test::tag());
  fs::create_directories(folder);
  std::ofstream(folder / "maze.txt") << "o";
  fs::create_symlink("maze.txt", folder / "link.txt");
  HiddenFiles hidden;
  EXPECT_TRUE(hidden.paths()->empty());
  hidden.add("");
  hidden.add(folder / "x" / ".." / "link.txt");
  EXPECT_THAT(*hidden.paths(), testing::IsSupersetOf({(folder / "link.txt").string()}));
  EXPECT_THAT(*hidden.paths(), Contains((fs::canonical(folder) / "maze.txt").string()));
  EXPECT_EQ(hidden.paths(), hidden.paths());
  fs::remove_all(folder);
}

}  // namespace
}  // namespace labmouse
