// Capstone robots raced as a user races them.
#include "tests/cli/user.hpp"
#include "tests/interpreters.hpp"

namespace labmouse::test {
namespace {

using testing::HasSubstr;

class ARobotsOwner : public AUser {
 protected:
  void SetUp() override {
    if (python3().empty()) GTEST_SKIP() << "no python3 that runs is in PATH";
    file("corridor.txt", corridor);
    file("robot.py",
         "class Robot(object):\n"
         "    def __init__(self, maze_dim):\n"
         "        self.moves = [(90, 3), ('Reset', 'Reset'), (90, 3)]\n"
         "    def next_move(self, sensors):\n"
         "        print('sensors %s' % sensors)\n"
         "        return self.moves.pop(0)\n");
    file("broken.py", "class Robot(object):\n    def __init__(self, maze_dim):\n        self.dim = maze_dim / 0\n");
  }
};

TEST_F(ARobotsOwner, RacesItBesideABuiltinMouse) {
  const auto race = AUser::race({"--mice", "flood,capstone:robot.py", "--mazes", "corridor.txt"});
  ASSERT_EQ(race.at("groups").at(0).at("mice").size(), 2U);
  for (const auto& mouse : race.at("groups").at(0).at("mice")) EXPECT_EQ(mouse.at("finished"), 1) << mouse;
  EXPECT_EQ(race.at("groups").at(0).at("mice").at(0).at("results").at(0).at("score"),
            race.at("groups").at(0).at("mice").at(1).at("results").at(0).at("score"));
}

TEST_F(ARobotsOwner, GoesOnWhereOneDies) {
  const Ended ended = labmouse({"race", "--mice", "capstone:broken.py", "--mice", "capstone:robot.py", "--mazes",
                                "corridor.txt", "--format", "json"});
  EXPECT_EQ(ended.code, 1);  // one of them never started
  const auto race = nlohmann::json::parse(ended.out);
  EXPECT_EQ(race.at("groups").at(0).at("mice").at(0).at("name"), "capstone:robot.py");
  EXPECT_EQ(race.at("groups").at(0).at("mice").at(1).at("results").at(0).at("outcome"), "forfeit: ended early");
}

TEST_F(ARobotsOwner, GetsTheRecordOfTheBuiltinMouseThatItsRobotDoesAsWell) {
  const std::string robot = "capstone:" LABMOUSE_SOURCE_DIR "/tests/external/robots/flood.py";
  EXPECT_EQ(labmouse({"run", robot, "capstone-1", "--record", "robot.jsonl"}).code, 0);
  EXPECT_EQ(labmouse({"run", "flood", "capstone-1", "--record", "mouse.jsonl"}).code, 0);
  const std::string robot_record = content("robot.jsonl"), mouse_record = content("mouse.jsonl");
  EXPECT_EQ(robot_record.substr(robot_record.find('\n')), mouse_record.substr(mouse_record.find('\n')));
}

TEST_F(ARobotsOwner, MaySayWhereItLiesFromAnywhere) {
  std::filesystem::create_directories(folder_ / "mice" / "mine");
  std::filesystem::rename(folder_ / "robot.py", folder_ / "mice" / "mine" / "robot.py");
  for (const std::string& path : {std::string("mice/mine/robot.py"), (folder_ / "mice/mine/robot.py").string()})
    EXPECT_THAT(labmouse({"run", "capstone:" + path, "corridor.txt"}).out, HasSubstr("finished, score 1.067")) << path;
}

TEST_F(ARobotsOwner, IsToldWhatFileIsMissing) {
  is_refused({"race", "--mice", "capstone:rowboat.py"}, "no such file", "'rowboat.py'", "capstone:FILE");
}

}  // namespace
}  // namespace labmouse::test
