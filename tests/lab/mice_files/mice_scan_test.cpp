#include "labmouse/lab/mice_files/mice_scan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "labmouse/external/command_line.hpp"
#include "labmouse/lab/mice_files/mice_file.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr const char* robot = "class Robot(object):\n    def next_move(self, sensors):\n        return 0, 1\n";

class MiceScan : public testing::Test {
 protected:
  ~MiceScan() override { fs::remove_all(folder_); }

  void file(const fs::path& name, const std::string& content, bool executable = false) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << content;
    if (executable) fs::permissions(folder_ / name, fs::perms::owner_all);
  }
  std::vector<FoundMouse> found(const std::string& old_python = "") const { return scan_for_mice(folder_, old_python); }
  FoundMouse only(const std::string& old_python = "") const {
    const auto all = found(old_python);
    EXPECT_THAT(all, SizeIs(1));
    return all.empty() ? FoundMouse() : all.front();
  }

  fs::path folder_ = fs::temp_directory_path() / ("labmouse-scan-" + std::to_string(getpid()));
};

TEST_F(MiceScan, NamesEachRobotAfterItsFolderInTheirOrder) {
  file("ben/deep/robot.py", robot);
  file("anna/robot.py", robot);
  file("anna/old/robot.py", robot);
  file("cleo.py", robot);
  const auto mice = found();
  ASSERT_THAT(mice, SizeIs(3));
  EXPECT_EQ(mice[0].name, "anna");
  EXPECT_EQ(mice[0].kind, "capstone");
  EXPECT_EQ(mice[0].file, "anna/robot.py");
  EXPECT_EQ(mice[1].file, "ben/deep/robot.py");
  EXPECT_EQ(mice[2].name, "cleo");
}

TEST_F(MiceScan, KeepsARobotThatIsBroken) {
  file("anna/robot.py", "import nothing\n");
  file("ben/robot.py", "import API\nAPI.moveForward()\n");
  file("ben/main.py", "import robot\nAPI.mazeWidth()\n");
  const auto mice = found();
  ASSERT_THAT(mice, SizeIs(2));
  EXPECT_EQ(mice[0].kind, "capstone");
  EXPECT_EQ(mice[0].file, "anna/robot.py");
  EXPECT_EQ(mice[1].kind, "mms");
}

TEST_F(MiceScan, KnowsProgramsByWhatTheySay) {
  file("a/mouse.py", "print('labmouse 1', flush=True)\n");
  file("b/Main.py", "import API\nAPI.moveForward()\n");
  file("b/API.py", "print('mazeWidth')\n");
  file("c/run", "#!/bin/sh\necho mazeWidth\n", true);
  file("d/notes.txt", "labmouse 1");
  file("e/drive.py", "print('labmouse pilot 1', flush=True)\n");
  const auto mice = found();
  ASSERT_THAT(mice, SizeIs(5));
  EXPECT_EQ(mice[0].kind + " " + mice[0].interpreter, "program python3");
  EXPECT_EQ(mice[1].kind + " " + mice[1].file, "mms b/Main.py");
  EXPECT_EQ(mice[2].kind + " " + mice[2].interpreter, "mms ");
  EXPECT_EQ(mice[3].kind, "");
  EXPECT_EQ(mice[4].kind + " " + mice[4].interpreter, "controller python3");
}

TEST_F(MiceScan, TakesTheVirtualEnvironmentBesideARobot) {
  file("anna/robot.py", robot);
  file("anna/venv/bin/python", "");
  file("anna/venv/lib/robot.py", robot);
  EXPECT_EQ(only().interpreter, "anna/venv/bin/python");
}

TEST_F(MiceScan, MarksPython2) {
  file("anna/robot.py", std::string(robot) + "print \"hello\"\n");
  EXPECT_EQ(only("python2").interpreter, "python2");
  EXPECT_TRUE(only("python2").can_start);
  EXPECT_FALSE(only().can_start);
  EXPECT_THAT(only().remark, HasSubstr("not tried"));
  // What is switched off is no mouse of the mice file.
  file("ben/robot.py", std::string(robot) + "print('hello')  # print a word\n");
  const MiceFileResult read = read_mice_file(mice_file_text(found()));
  ASSERT_THAT(read.mice, SizeIs(1));
  EXPECT_EQ(read.mice[0].name, "ben");
}

TEST_F(MiceScan, WritesWhatTheReaderReads) {
  file("a \"b\\/robot.py", robot);
  file("c/my mouse", "#!/bin/sh\necho labmouse 1\n", true);
  file("d/my \"mouse\"", "#!/bin/sh\necho labmouse 1\n", true);
  file("e/a\nb/robot.py", robot);
  const MiceFileResult read = read_mice_file(mice_file_text(found()));
  ASSERT_THAT(read.mice, SizeIs(3));
  EXPECT_EQ(read.mice[0].name, "a \"b\\");
  EXPECT_EQ(read.mice[0].what, "a \"b\\/robot.py");
  EXPECT_EQ(read.mice[1].what, "\"./my mouse\"");
  EXPECT_EQ(read.mice[1].directory, "c");
  EXPECT_THAT(split_command(read.mice[2].what), testing::ElementsAre("./my \"mouse\""));
}

}  // namespace
}  // namespace labmouse
