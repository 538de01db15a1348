// Mice files as a user meets them.
#include <filesystem>

#include "tests/cli/user.hpp"

namespace labmouse::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A robot that turns on the spot and says so.
constexpr const char* turning =
    "import os\nimport sys\nclass Robot(object):\n    def __init__(self, dim):\n"
    "        sys.stderr.write('words %s mode %s' % (sys.argv[1:], os.environ.get('MODE')))\n"
    "    def next_move(self, sensors):\n        return 90, 0\n";

class ATeacher : public AUser {
 protected:
  ATeacher() {
    file("corridor.txt", corridor);
    std::filesystem::create_directories(folder_ / "class" / "anna");
    file("class/anna/robot.py", turning);
  }
  std::string names(const Ended& ended) const {
    const auto json = nlohmann::json::parse(ended.out);
    std::string all;
    for (const auto& mouse : json.at("groups").at(0).at("mice")) all += mouse.at("name").get<std::string>() + ";";
    return all;
  }
  Ended race_of(const std::string& mice_file, std::vector<std::string> more = {}) const {
    file("class/mice.toml", mice_file);
    more.insert(more.begin(),
                {"race", "--mazes", "corridor.txt", "--mice-file", "class/mice.toml", "--format", "json"});
    return labmouse(std::move(more));
  }
};

TEST_F(ATeacher, RacesAMiceFileByItsNames) {
  const Ended ended = race_of(
      "[[mouse]]\nname = \"Anna's\"\ncapstone = \"anna/robot.py\"\narguments = [\"ff\", \"no\"]\n"
      "environment = { MODE = \"fast\" }\nnote = \"by Anna\"\n[[mouse]]\nname = \"quick\"\nmouse = \"flood\"\n");
  EXPECT_EQ(names(ended), "quick;Anna's;");
  const auto anna = nlohmann::json::parse(ended.out).at("groups").at(0).at("mice")[1];
  EXPECT_EQ(anna.at("note"), "by Anna");
  EXPECT_THAT(anna.at("spec").get<std::string>(), HasSubstr("class/anna/robot.py"));
  EXPECT_THAT(anna.at("interpreter").at("version").get<std::string>(), HasSubstr("3."));
  EXPECT_THAT(anna.at("results")[0].at("last_words").get<std::string>(), HasSubstr("words ['ff', 'no'] mode fast"));
}

TEST_F(ATeacher, LeavesOutWhoCannotEnterAWorld) {
  const std::string mice_file =
      "[[mouse]]\nname = \"Anna's\"\nmouse = \"festina\"\n[[mouse]]\nname = \"quick\"\nmouse = \"flood\"\n";
  const Ended ended = race_of(mice_file, {"--world", "steps"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, testing::AllOf(HasSubstr("\"quick\""), Not(HasSubstr("Anna's"))));
  EXPECT_THAT(ended.err, Says("left out", "Anna's"));
  // One that is named itself is refused.
  EXPECT_EQ(labmouse({"race", "--mice", "flood,festina", "--world", "steps"}).code, 2);
}

TEST_F(ATeacher, IsToldWhereAMiceFileIsWrong) {
  const Ended ended =
      race_of("[[mouse]]\nname = \"a\"\nmouse = \"flod\"\n[[mouse]]\nname = \"b\"\ncapstone = \"no.py\"\n");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, Says("mice.toml:1:1: error: ", "'flood'", "mice.toml:4:1: error: ", "no.py"));
  for (const std::string command : {"sweep", "tune"}) {
    const std::string option = command == "sweep" ? "--vary" : "--params";
    std::vector<std::string> words = {command, "mice-file:class/mice.toml:a", option, "stride=1:2"};
    if (command == "sweep") words.back() += ":1";
    if (command == "tune") words.insert(words.end(), {"--evaluations", "2"});
    EXPECT_THAT(labmouse(words).err, testing::StartsWith("class/mice.toml:1:1: error: "));
  }
}

TEST_F(ATeacher, NamesMiceOnTheCommandLine) {
  const Ended ended =
      labmouse({"race", "--mazes", "corridor.txt", "--format", "json", "--mice",
                "far=flood:stride=2,near=flood:stride=1", "--mice", "mine=capstone:class/anna/robot.py ff no"});
  EXPECT_THAT(names(ended), testing::AllOf(HasSubstr("far;"), HasSubstr("near;"), HasSubstr("mine;")));
  EXPECT_THAT(ended.out, HasSubstr("words ['ff', 'no']"));
  EXPECT_THAT(labmouse({"race", "--mice", "a=flood,a=certify"}).err, Says("'a'", "name"));
  EXPECT_THAT(labmouse({"race", "--mice", "a=mice-file:class/mice.toml"}).err, Says("'a'", "own names"));
}

TEST_F(ATeacher, RunsOneMouseOfAMiceFile) {
  file("class/mice.toml", "[[mouse]]\nname = \"a\"\nmouse = \"flood\"\n[[mouse]]\nname = \"b\"\nmouse = \"certify\"\n");
  EXPECT_THAT(labmouse({"run", "mice-file:class/mice.toml:b", "corridor.txt"}).out,
              HasSubstr("b in corridor.txt: finished"));
  EXPECT_THAT(labmouse({"run", "mice-file:class/mice.toml:c", "corridor.txt"}).err, HasSubstr("'c'"));
  EXPECT_EQ(labmouse({"run", "mice-file:class/mice.toml", "corridor.txt"}).code, 2);
}

TEST_F(ATeacher, VariesNamedMiceAsTheMiceThatTheyAre) {
  file("class/mice.toml", "[[mouse]]\nname = \"a\"\nmouse = \"flood\"\n");
  for (const std::string mouse : {"certify=flood", "mice-file:class/mice.toml:a"}) {
    const Ended swept = labmouse({"sweep", mouse, "--vary", "stride=1:3:1", "--mazes", "corridor.txt"});
    EXPECT_EQ(swept.code, 0) << swept.err;
    EXPECT_THAT(swept.out, HasSubstr("flood"));
  }
  // The name is that of another mouse, with other parameters.
  EXPECT_EQ(labmouse({"race", "--mice", "ariadne=flood", "--world", "seconds", "--mazes", "corridor.txt"}).code, 0);
  EXPECT_EQ(labmouse({"sweep", "mice-file:class/mice.toml", "--vary", "stride=1:3:1", "--mazes", "corridor.txt"}).code,
            0);
  EXPECT_EQ(labmouse({"sweep", "mine=capstone:class/anna/robot.py", "--vary", "stride=1:3:1"}).code, 2);
}

TEST_F(ATeacher, WritesAMiceFileAndChecksIt) {
  std::filesystem::create_directories(folder_ / "class" / "clock");
  file("class/clock/robot.py",
       "import time\nclass Robot(object):\n    def __init__(self, dim):\n        pass\n"
       "    def next_move(self, sensors):\n        return [90, -90][time.time_ns() // 1000 % 2], 0\n");
  std::filesystem::create_directories(folder_ / "class" / "wrong");
  file("class/wrong/robot.py",
       "class Robot(object):\n    def __init__(self, dim):\n        raise ValueError('no way')\n"
       "    def next_move(self, sensors):\n        pass\n");
  const Ended written = labmouse({"mice-file", "init", "class"});
  EXPECT_EQ(written.code, 0);
  EXPECT_THAT(content_of(folder_ / "class" / "mice.toml"), HasSubstr("name = \"anna\"\ncapstone = \"anna/robot.py\""));
  EXPECT_THAT(labmouse({"mice-file", "init", "class"}).err, Says("mice.toml", "--overwrite"));
  EXPECT_EQ(labmouse({"mice-file", "init", "class", "--overwrite"}).code, 0);
  const Ended checked = labmouse({"mice-file", "check", "class/mice.toml"});
  EXPECT_EQ(checked.code, 1);
  EXPECT_THAT(checked.out, testing::ContainsRegex("anna +capstone Python 3[.0-9]+ +plays[^\n]*\n"));
  EXPECT_THAT(checked.out, testing::ContainsRegex("clock[^\n]*plays[^\n]*differs from run to run"));
  EXPECT_THAT(checked.out, testing::ContainsRegex("wrong[^\n]*error"));
  EXPECT_THAT(checked.out, HasSubstr("no way"));
  EXPECT_THAT(checked.out, Not(testing::ContainsRegex("anna[^\n]*differs")));
}

TEST_F(ATeacher, GetsTheSameTableTwice) {
  file("class/anna/robot.py",
       "import random\nclass Robot(object):\n    def __init__(self, dim):\n        pass\n"
       "    def next_move(self, sensors):\n        return random.choice([90, -90, 0]), random.choice([1, 2])\n");
  const auto walk = [&] {
    labmouse({"run", "capstone:class/anna/robot.py", "corridor.txt", "--record", "walk.jsonl"});
    return content_of(folder_ / "walk.jsonl");
  };
  const std::string first = walk();
  EXPECT_EQ(walk(), first);
  EXPECT_THAT(first, HasSubstr("\"interpreter\":"));
}

}  // namespace
}  // namespace labmouse::test
