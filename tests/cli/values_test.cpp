// What stands behind options and in files: numbers that are none, values that are empty, mice of other worlds.
#include <string>
#include <vector>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using test::AUser;
using test::Ended;
using test::Says;
using ::testing::HasSubstr;

TEST_F(AUser, HasAPictureOfARobotWithoutDiagonals) {
  EXPECT_EQ(labmouse({"robot", "show", "beginner", "--svg", "x.svg"}).code, 0);
  EXPECT_THAT(content("x.svg"), HasSubstr("</svg>"));
}

TEST_F(AUser, IsToldWhereANumberIsNone) {
  file("race.json", "{\n \"labmouse\": \"0.1.0\",\n \"mazes\": [{\"bound\": 1e309}],\n \"mice\": []\n}\n");
  is_refused({"race", "--mice", "flood", "--baseline", "race.json"}, "race.json:3:22: error: ", "'1e309'");
  is_refused({"race", "--world", "failures", "--failure-rates", "./race.json"}, "race.json:3:22: error: ", "'1e309'");
  file("robot.toml", "cell = 1e-320\n");
  is_refused({"robot", "show", "./robot.toml"}, "robot.toml:1:8: error: ");
  file("walk.jsonl", "{}\n{\"a\": 1e309}\n");
  is_refused({"score", "walk.jsonl"}, "walk.jsonl:", ": error: ");
}

TEST_F(AUser, MayGiveAllDigitsOfANumber) {
  file("m.txt", test::corridor);
  EXPECT_EQ(labmouse({"race", "--mice", "flood", "--mazes", "m.txt", "--fail-above", "22.033333333333335"}).code, 0);
  EXPECT_EQ(labmouse({"make", "empty", "--size", "4x4", "--loops", "1e-1"}).code, 0);
}

TEST_F(AUser, GivesDecimalNumbersToAllOptions) {
  file("m.txt", test::corridor);
  for (const std::string odd : {"0x1", "inf", "nan", "1x", "+1", " 1", "1,5x", "1e309", "1e-320", "1_0"}) {
    is_refused({"race", "--world", "physical", "--mice", "flood", "--mazes", "m.txt", "--noise", odd}, "--noise");
    is_refused({"drive", "--mazes", "m.txt", "--noise", odd}, "--noise");
    is_refused({"race", "--world", "physical", "--mice", "flood", "--variation", odd}, "--variation");
    is_refused({"drive", "--variation", odd}, "--variation");
    is_refused({"race", "--fail-above", odd}, "--fail-above");
    is_refused({"race", "--seed", odd}, "--seed");
    is_refused({"race", "--runs", odd}, "--runs");
    is_refused({"race", "--start-limit", odd}, "--start-limit");
    is_refused({"race", "--memory", odd}, "--memory");
    is_refused({"race", "--jobs", odd}, "--jobs");
  }
  // Eight in the system of eight is none of ten.
  EXPECT_EQ(labmouse({"run", "flood", "m.txt", "--candidates", "010", "--explain"}).code, 0);
  is_refused({"drive", "--noise", "1,"}, "--noise");
}

TEST_F(AUser, ChoosesAWorldByItsNameAndNotByAParameter) {
  file("m.txt", test::corridor);
  const std::vector<std::string> race = {"race", "--mice", "flood,ariadne:cell_most=1", "--mazes", "m.txt"};
  is_refused(race, "'cell_most'", "--world seconds");
  is_refused({"sweep", "ariadne", "--vary", "cell_most=0,1", "--mazes", "m.txt"}, "'cell_most'", "--world seconds");
  std::vector<std::string> named = race;
  named.insert(named.end(), {"--world", "seconds"});
  EXPECT_EQ(labmouse(named).code, 0);
}

TEST_F(AUser, GivesSpeedsInMillimetres) {
  file("m.txt", test::corridor);
  is_refused({"race", "--world", "physical", "--mice", "flood", "--mazes", "m.txt", "--search-speed", "0.3"},
             "error: --search-speed", "mm/s");
  is_refused({"drive", "--mazes", "m.txt", "--search-speed", "0.3"}, "--search-speed", "mm/s");
  is_refused({"failure-rates", "--mazes", "m.txt", "--search-speed", "0.3"}, "--search-speed", "mm/s");
}

TEST_F(AUser, HasNoEmptyValueTakenForNone) {
  const std::vector<std::vector<std::string>> all = {{"failure-rates", "--check", ""},
                                                     {"race", "--start", ""},
                                                     {"mice", ""},
                                                     {"mice", "--format", ""},
                                                     {"race", "--label", ""},
                                                     {"race", "--mice", ""},
                                                     {"race", "--goal", ""},
                                                     {"race", "--runs", ""},
                                                     {"race", "--noise", ""},
                                                     {"bound", "--hindsight", ""},
                                                     {"show", "--layer", ""},
                                                     {"show", ""},
                                                     {"sweep", "", "--vary", "a=1"},
                                                     {"race", "--fail-above", ""},
                                                     {"race", "--python", ""},
                                                     {"convert", "", "-"},
                                                     {"race", "--shard", ""},
                                                     {"store", "list", ""},
                                                     {"store", "list", "s.db", "--mouse", ""}};
  for (const auto& words : all) is_refused(words, "error: ", "empty");
  is_refused({"race", "--start="}, "error: ", "--start");
}

TEST_F(AUser, IsToldWhichMiceHaveHindsight) {
  file("m.txt", test::corridor);
  is_refused({"bound", "m.txt", "--hindsight", "festina"}, "error: ", "'festina'", "steps", "seconds");
  is_refused({"bound", "m.txt", "--hindsight", "controller:true"}, "error: ", "steps", "physical");
  is_refused({"bound", "m.txt", "--hindsight", "mms:true"}, "error: ", "steps", "mms");
}

TEST_F(AUser, IsToldOfParametersWithoutEffectAndChoosesTheWorld) {
  file("m.txt", test::corridor);
  const std::vector<std::vector<std::string>> commands = {
      {"race", "--mice", "festina:search=0.5"},
      {"race", "--mice", "flood,festina:search=0.5"},
      {"study", "--mice", "festina,festina:search=0.5"},
      {"sweep", "festina", "--vary", "search=0.5,1"},
      {"tune", "festina", "--params", "search", "--evaluations", "4"}};
  for (std::vector<std::string> words : commands) {
    words.insert(words.end(), {"--mazes", "m.txt"});
    is_refused(words, "error: ", "'search'", "'festina'", "seconds", "physical world and the failure model",
               "--world physical");
    words.insert(words.end(), {"--world", "seconds"});
    if (words[2] != "flood,festina:search=0.5") is_refused(words, "error: ", "'search'", "'festina'", "failure model");
  }
  const Ended chosen =
      labmouse({"race", "--mice", "festina:search=0.5", "--mazes", "m.txt", "--world", "failures", "--runs", "1"});
  EXPECT_EQ(chosen.code, 0) << chosen.err;
  is_refused({"race", "--mice", "flood,ariadne:cell_most=1", "--mazes", "m.txt"}, "error: ", "'cell_most'", "steps",
             "--world seconds");
  is_refused({"failure-rates", "--mice", "ariadne:travel=30", "--mazes", "m.txt"}, "error: --mice: ", "'travel'",
             "steps");
  is_refused({"run", "ariadne:cell_most=1", "m.txt"}, "error: ", "'cell_most'", "seconds");
  is_refused({"bound", "m.txt", "--hindsight", "ariadne:cell_most=1"}, "error: ", "'cell_most'", "seconds");
}

TEST_F(AUser, MayHaveAMouseThatOnlyDrivesInAMiceFile) {
  file("mice.toml", "[[mouse]]\nname = \"anna\"\nmouse = \"festina\"\n");
  const Ended ended = labmouse({"mice-file", "check", "mice.toml"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, Says("anna ", "score ", " s"));
}

TEST_F(AUser, IsToldOfProgramsThatNeverStart) {
  file("m.txt", test::corridor);
  file("n.txt", "o---o---o\n| S   G |\no---o---o\n");
  const auto is_told = [&](const std::vector<std::string>& words) {
    const Ended ended = labmouse(words);
    EXPECT_EQ(ended.code, 1) << ended.out << ended.err;
    EXPECT_NE(ended.out, "");
    EXPECT_THAT(ended.err, Says("program:false", "start"));
  };
  is_told({"sweep", "program:false {depth}", "--vary", "depth=1,2", "--mazes", "m.txt"});
  is_told({"study", "--mice", "flood,program:false", "--folds", "2", "--mazes", "m.txt", "n.txt"});
  is_told({"bound", "m.txt", "--hindsight", "program:false"});
}

}  // namespace
}  // namespace labmouse
