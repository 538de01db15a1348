// The world in seconds as a user has it: routes, races, records.
#include "tests/cli/user.hpp"

namespace labmouse::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class ADriver : public AUser {
 protected:
  ADriver() { file("corner.txt", "o---o---o\n|     G |\no   o---o\n| S |   |\no---o---o\n"); }

  Ended race_in_seconds(std::vector<std::string> options) const {
    options.insert(options.begin(), {"race", "--world", "seconds", "--robot", "mm2021", "--mazes", "corner.txt"});
    return labmouse(std::move(options));
  }
};

TEST_F(ADriver, FindsTheFastestRoute) {
  const Ended ended = labmouse({"route", "corner.txt", "--robot", "mm2021", "--svg", "route.svg"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out,
              HasSubstr("\nR90\n\n0.375 s from 420 mm/s in the centre of the start to the centre of the goal, "));
  EXPECT_THAT(content("route.svg"), HasSubstr("<title>corner: mm2021, 0.375 s</title>"));
  const auto json =
      nlohmann::json::parse(labmouse({"route", "corner.txt", "--robot", "mm2021", "--format", "json"}).out);
  EXPECT_EQ(json["mazes"][0]["time_us"], 375'000);
}

TEST_F(ADriver, IsToldWhyThereIsNoRoute) {
  file("corridor.txt", corridor);
  is_refused({"route", "corridor.txt"}, "corridor.txt: error: no route leads north from the start (0,0) to a goal");
  is_refused({"route", "nowhere.txt"}, "nowhere.txt");
  is_refused({"route", "corner.txt", "--robot", "clasic"}, "did you mean 'classic'?");
  is_refused({"route", "corner.txt", "corridor.txt", "--svg", "x.svg"}, "--svg draws one maze; these are 2");
  EXPECT_EQ(labmouse({"make", "wilson", "--size", "33x33", "-o", "large.txt"}).code, 0);
  is_refused({"route", "large.txt"}, "the world of seconds takes mazes up to 32x32");
  is_refused({"race", "--world", "seconds", "--mazes", "large.txt"}, "the world of seconds takes mazes up to 32x32");
  EXPECT_THAT(labmouse({"route", "large.txt", "corner.txt"}).out,
              HasSubstr("large.txt: is 33x33; the world of seconds"));
}

TEST_F(ADriver, RacesInSeconds) {
  const Ended ended = race_in_seconds({});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(": world of seconds, "));
  EXPECT_THAT(ended.out, HasSubstr("\nflood "));
  EXPECT_THAT(ended.out, HasSubstr("\ncertify "));
  EXPECT_THAT(ended.out, HasSubstr("\nRobot mm2021, cells of 90 mm."));
  EXPECT_THAT(race_in_seconds({"--mice", "flood", "--format", "csv"}).out, StartsWith("mouse,maze,seed,"));
  EXPECT_EQ(race_in_seconds({"--mice", "flood", "--fail-above", "100"}).code, 0);
  EXPECT_EQ(race_in_seconds({"--mice", "flood", "--fail-above", "0.001"}).code, 1);
}

TEST_F(ADriver, IsToldWhichOptionsMakeNoSense) {
  is_refused({"race", "--robot", "half"}, "--robot is for the world of seconds, in which no mouse races");
  is_refused({"race", "--rules", "uk"}, "--rules is for the world of seconds, in which no mouse races");
  is_refused({"race", "--world", "seconds", "--budget", "5"},
             "--budget is for the world of strides, in which no mouse races");
  is_refused({"race", "--world", "seconds", "--mice", "manhattan"},
             "mouse 'manhattan' does not drive in seconds; those that do are ");
  is_refused({"race", "--world", "seconds", "--rules", "all-japam"}, "did you mean 'all-japan'?");
  is_refused({"race", "--world", "seconds", "--mice", "flood,ariadne:base=50"},
             "parameter 'base' of mouse 'ariadne' has no meaning in seconds; it has 'prior' there");
  is_refused({"race", "--world", "seconds", "--mice", "flood:stride=1"},
             "has no meaning in seconds; it has none there");
  EXPECT_EQ(race_in_seconds({"--mice", "ariadne:prior=uniform"}).code, 0);
  is_refused({"race", "--world", "minutes"}, "--world");
}

TEST_F(ADriver, IsToldOfMazesThatAreTooLarge) {
  EXPECT_EQ(labmouse({"make", "wilson", "--size", "33x33", "-o", "mazes/large.txt"}).code, 0);
  file("mazes/corner.txt", content("corner.txt"));
  is_refused({"race", "--world", "seconds", "--mazes", "corner.txt", "mazes/large.txt"},
             "large.txt: error: is 33x33; the world of seconds");
  const Ended ended = labmouse({"race", "--world", "seconds", "--mice", "flood", "--mazes", "mazes"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("1 mouse, 1 maze, seed 1"));
  EXPECT_THAT(ended.err, HasSubstr("mazes/large.txt: error: is 33x33; the world of seconds takes mazes up to 32x32\n"));
}

TEST_F(ADriver, SeesTheRulesThatThereAre) {
  EXPECT_THAT(
      labmouse({"rules", "list"}).out,
      HasSubstr("\nthirtieth  the best of at most 100 runs in 600 s, gate to gate, plus 1/30 of the time in the maze"));
  const Ended shown = labmouse({"rules", "show", "uk"});
  EXPECT_THAT(shown.out, HasSubstr("\nmaze_time_divisor = 30\n"));
  file("mine.toml", shown.out);
  EXPECT_EQ(labmouse({"rules", "show", "./mine.toml"}).code, 0);
  EXPECT_EQ(race_in_seconds({"--rules", "mine.toml"}).code, 0);
  is_refused({"rules", "show", "all-japam"}, "did you mean 'all-japan'?");
}

TEST_F(ADriver, SavesRecordsAndPlaysThemAgain) {
  ASSERT_EQ(race_in_seconds({"--mice", "certify", "--out", "saved"}).code, 0);
  const std::string record = "saved/certify/corner-1.jsonl";
  const Ended replayed = labmouse({"replay", record, "--svg", "replayed.svg"});
  EXPECT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_THAT(replayed.out, HasSubstr("\ncertify in corner.txt, mm2021, all-japan: "));
  EXPECT_EQ(content("replayed.svg"), content("saved/certify/corner.svg"));
  EXPECT_EQ(labmouse({"show", "--record", record, "--svg", "shown.svg"}).code, 0);
  EXPECT_EQ(content("shown.svg"), content("replayed.svg"));
  EXPECT_THAT(labmouse({"score", record}).out, StartsWith("certify in corner.txt, mm2021, all-japan: "));
  EXPECT_EQ(nlohmann::json::parse(content("saved/results.json"))["groups"][0]["world"], "seconds");
  is_refused({"show", "--record", record}, "drawn as a picture only; name its file with --svg FILE");
  is_refused({"show", "--record", record, "--svg", "x.svg", "--layer", "heat"},
             "--layer is not for records in seconds");
  is_refused({"replay", record, "--watch"}, "--watch is not for records in seconds");
}

TEST_F(ADriver, IsToldOfRecordsThatCannotHaveHappened) {
  ASSERT_EQ(race_in_seconds({"--mice", "flood", "--out", "saved"}).code, 0);
  std::string record = content("saved/flood/corner-1.jsonl");
  file("cut.jsonl", record.substr(0, record.find("\"rules\"")) + "\n");
  is_refused({"replay", "cut.jsonl"}, "cut.jsonl:1:1: error: the line is not JSON");
  const auto gate = record.find("\"gate_out\":300000");
  ASSERT_NE(gate, std::string::npos);
  file("changed.jsonl", record.replace(gate, 17, "\"gate_out\":300001"));
  const Ended ended = labmouse({"replay", "changed.jsonl"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, HasSubstr("changed.jsonl: error: does not agree with its maze: run 1 (search): "));
}

}  // namespace
}  // namespace labmouse::test
