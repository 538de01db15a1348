// The world in seconds as a user has it: routes, races, records.
#include <nlohmann/json.hpp>

#include "tests/cli/user.hpp"

namespace labmouse::test {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
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
  EXPECT_THAT(ended.out, Says("\nR90\n", "0.375 s", "420 mm/s"));
  EXPECT_THAT(content("route.svg"), HasSubstr("<title>corner: mm2021, 0.375 s</title>"));
  const auto json =
      nlohmann::json::parse(labmouse({"route", "corner.txt", "--robot", "mm2021", "--format", "json"}).out);
  EXPECT_EQ(json["mazes"][0]["time_us"], 375'000);
}

TEST_F(ADriver, IsToldWhyThereIsNoRoute) {
  file("corridor.txt", corridor);
  is_refused({"route", "corridor.txt"}, "corridor.txt: error: ", "no route", "north", "(0,0)");
  is_refused({"route", "nowhere.txt"}, "nowhere.txt");
  is_refused({"route", "corner.txt", "--robot", "clasic"}, "'clasic'", "'classic'");
  is_refused({"route", "corner.txt", "corridor.txt", "--svg", "x.svg"}, "--svg", "2");
  EXPECT_EQ(labmouse({"make", "wilson", "--size", "33x33", "-o", "large.txt"}).code, 0);
  is_refused({"route", "large.txt"}, "large.txt: error: ", "33x33", "32x32");
  is_refused({"race", "--world", "seconds", "--mazes", "large.txt"}, "large.txt: error: ", "33x33", "32x32");
  EXPECT_THAT(labmouse({"route", "large.txt", "corner.txt"}).out, Says("large.txt: ", "33x33", "32x32"));
}

TEST_F(ADriver, FindsWhichRouteWinsForWhichRobot) {
  const std::string grip = "curve.lateral_acceleration=7000:9000";
  const Ended ended = labmouse({"route", "contest-01", "--vary", grip, "--svg", "regions.svg"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, Says("contest-01", "curve.lateral_acceleration", "7000", "9000", "A ", "34", "B ", "32"));
  EXPECT_THAT(content("regions.svg"), StartsWith("<svg"));
  const auto json = nlohmann::json::parse(
      labmouse({"route", "contest-01", "--vary", grip, "--and", "straight.speed=2500:3500", "--format", "json"}).out);
  EXPECT_EQ(json["routes"].size(), 2U);
  EXPECT_EQ(json["and"]["key"], "straight.speed");
  for (const auto& row : json["rows"]) {
    EXPECT_EQ(row["regions"].front()["from"], 7000);
    EXPECT_EQ(row["regions"].back()["to"], 9000);
  }
}

TEST_F(ADriver, IsToldWhatCannotBeVaried) {
  const std::string grip = "curve.lateral_acceleration=7000:9000";
  is_refused({"route", "contest-01", "--vary", "curve.lateral_acceleration"}, "--vary", "KEY=FROM:TO");
  is_refused({"route", "contest-01", "--vary", "curve.grips=1:2"}, "'curve.grips'");
  is_refused({"route", "contest-01", "--vary", "curve.lateral_acceleration=9000:7000"}, "FROM", "TO");
  is_refused({"route", "contest-01", "--vary", grip, "--and", grip}, "--and", "same");
  is_refused({"route", "contest-01", "--and", grip}, "--vary");
  is_refused({"route", "contest-01", "contest-02", "--vary", grip}, "--vary", "one maze", "2");
  is_refused({"route", "contest-01", "--vary", "search.speed=9000:10000"}, "contest-01", "no robot");
  file("corridor.txt", corridor);
  is_refused({"route", "corridor.txt", "--vary", grip}, "corridor.txt: error: ", "no route");
}

TEST_F(ADriver, RacesInSeconds) {
  const Ended ended = race_in_seconds({});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(": world seconds, "));
  EXPECT_THAT(ended.out, HasSubstr("\nflood "));
  EXPECT_THAT(ended.out, HasSubstr("\ncertify "));
  EXPECT_THAT(ended.out, Says("Robot mm2021", "90 mm"));
  EXPECT_THAT(race_in_seconds({"--mice", "flood", "--format", "csv"}).out, StartsWith("mouse,maze,seed,"));
  EXPECT_EQ(race_in_seconds({"--mice", "flood", "--fail-above", "100"}).code, 0);
  EXPECT_EQ(race_in_seconds({"--mice", "flood", "--fail-above", "0.001"}).code, 1);
}

TEST_F(ADriver, ComparesRobots) {
  file("my.toml", content_of(std::string(LABMOUSE_SOURCE_DIR) + "/robots/half.toml"));
  const std::vector<std::string> race = {"race",    "--world",    "seconds", "--mice",         "flood,certify",
                                         "--mazes", "contest-01", "--robot", "classic,my.toml"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), race.begin(), race.end());
    return more;
  };
  const Ended ended = labmouse(race);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, Says("Robot classic", "Robot my.toml", "\nRobots ", "my.toml"));
  EXPECT_EQ(nlohmann::json::parse(labmouse(with({"--format", "json"})).out).at("groups").size(), 2U);
  is_refused(with({"--format", "csv"}), "--format csv", "--robot", "json");
  is_refused(with({"--out", "out"}), "--out", "--robot");
  is_refused(with({"--curves", "curves.svg"}), "--curves", "--variation");
  is_refused({"race", "--world", "physical", "--mice", "flood", "--mazes", "corner.txt", "--runs", "1", "--noise",
              "0,1", "--robot", "classic,kerise", "--curves", "curves.svg"},
             "--curves", "--robot");
  is_refused({"race", "--world", "physical", "--mice", "flood", "--mazes", "corner.txt", "--runs", "1", "--noise",
              "0,1", "--variation", "lab,contest", "--curves", "curves.svg"},
             "--curves", "--noise", "--variation");
}

TEST_F(ADriver, IsToldWhichOptionsMakeNoSense) {
  is_refused({"race", "--robot", "half"}, "--robot", "--world seconds");
  is_refused({"race", "--rules", "uk"}, "--rules", "--world seconds");
  is_refused({"race", "--world", "seconds", "--budget", "5"}, "--budget", "--world steps");
  is_refused({"race", "--world", "seconds", "--mice", "manhattan"}, "'manhattan'", "seconds", "flood, ");
  is_refused({"race", "--world", "seconds", "--rules", "all-japam"}, "'all-japam'", "'all-japan'");
  is_refused({"race", "--world", "seconds", "--mice", "flood,ariadne:base=50"}, "'base'", "'ariadne'", "seconds",
             "labmouse mice ariadne");
  is_refused({"race", "--world", "seconds", "--mice", "flood:stride=1"}, "'stride'", "'flood'", "seconds",
             "labmouse mice flood");
  EXPECT_EQ(race_in_seconds({"--mice", "ariadne:prior=uniform"}).code, 0);
  is_refused({"race", "--world", "minutes"}, "--world");
}

TEST_F(ADriver, HasTheRulesOfTheMazesSize) {
  EXPECT_EQ(labmouse({"make", "wilson", "--size", "17x4", "-o", "large.txt"}).code, 0);
  const auto rules_of = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--mice", "flood", "--format", "json"});
    const Ended ended = labmouse(std::move(words));
    EXPECT_EQ(ended.code, 0) << ended.err;
    const auto name = nlohmann::json::parse(ended.out)["groups"][0]["rules"]["name"].get<std::string>();
    return std::pair(name, ended.err);
  };
  const std::vector<std::string> race = {"race", "--world", "seconds", "--mazes"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), race.begin(), race.end());
    return more;
  };
  EXPECT_EQ(rules_of(with({"corner.txt"})), std::pair(std::string("all-japan"), std::string()));
  EXPECT_EQ(rules_of(with({"large.txt"})), std::pair(std::string("all-japan-half"), std::string()));
  EXPECT_EQ(rules_of(with({"large.txt", "--rules", "uk"})), std::pair(std::string("uk"), std::string()));
  const auto [mixed, remark] = rules_of(with({"corner.txt", "large.txt"}));
  EXPECT_EQ(mixed, "all-japan");
  EXPECT_THAT(remark, Says("1 of 2", "all-japan-half", "--rules"));
  const std::string several = labmouse({"race", "--world", "failures", "--variation", "0,1", "--runs", "1", "--mice",
                                        "flood", "--mazes", "corner.txt", "large.txt"})
                                  .err;
  EXPECT_THAT(several, HasSubstr("1 of 2"));
  EXPECT_EQ(several.find("1 of 2"), several.rfind("1 of 2"));
  for (const char* maze : {"corner.txt", "large.txt"}) {
    ASSERT_EQ(labmouse({"run", "flood", maze, "--world", "seconds", "--record", "run.jsonl"}).code, 0);
    EXPECT_THAT(content("run.jsonl"), HasSubstr(std::string("\"all-japan") + (maze[0] == 'l' ? "-half\"" : "\"")));
  }
}

TEST_F(ADriver, IsToldOfMazesThatAreTooLarge) {
  EXPECT_EQ(labmouse({"make", "wilson", "--size", "33x33", "-o", "mazes/large.txt"}).code, 0);
  file("mazes/corner.txt", content("corner.txt"));
  is_refused({"race", "--world", "seconds", "--mazes", "corner.txt", "mazes/large.txt"}, "large.txt: error: ", "33x33",
             "32x32");
  const Ended ended = labmouse({"race", "--world", "seconds", "--mice", "flood", "--mazes", "mazes"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("1 mouse, 1 maze, seed 1"));
  EXPECT_THAT(ended.err, Says("mazes/large.txt: error: ", "33x33", "32x32"));
}

TEST_F(ADriver, SeesTheRulesThatThereAre) {
  EXPECT_THAT(labmouse({"rules", "list"}).out,
              testing::ContainsRegex("\nthirtieth  [^\n]*100 runs[^\n]*600 s[^\n]*gate to gate[^\n]*1/30 "));
  const Ended shown = labmouse({"rules", "show", "uk-2018"});
  EXPECT_THAT(shown.out, HasSubstr("\nmaze_time_divisor = 30\n"));
  file("mine.toml", shown.out);
  EXPECT_EQ(labmouse({"rules", "show", "./mine.toml"}).code, 0);
  EXPECT_EQ(race_in_seconds({"--rules", "mine.toml"}).code, 0);
  is_refused({"rules", "show", "all-japam"}, "'all-japam'", "'all-japan'");
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
  EXPECT_THAT(labmouse({"show", "--record", record}).out,
              AllOf(StartsWith("   o---"), HasSubstr("\ncertify in corner.txt, mm2021, all-japan: ")));
  is_refused({"show", "--record", record, "--svg", "x.svg", "--layer", "heat"}, "--layer", "seconds");
  EXPECT_THAT(labmouse({"replay", record, "--watch"}).out, AllOf(HasSubstr(" s  search  at "), EndsWith(replayed.out)));
  EXPECT_EQ(labmouse({"replay", record, "--maze", "capstone-1"}).code, 1);
}

TEST_F(ADriver, IsToldOfRecordsThatCannotHaveHappened) {
  ASSERT_EQ(race_in_seconds({"--mice", "flood", "--out", "saved"}).code, 0);
  std::string record = content("saved/flood/corner-1.jsonl");
  file("cut.jsonl", record.substr(0, record.find("\"rules\"")) + "\n");
  is_refused({"replay", "cut.jsonl"}, "cut.jsonl:1:", ": error: ", "JSON");
  const auto gate = record.find("\"gate_out\":300000");
  ASSERT_NE(gate, std::string::npos);
  file("changed.jsonl", record.replace(gate, 17, "\"gate_out\":300001"));
  const Ended ended = labmouse({"replay", "changed.jsonl"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, Says("changed.jsonl: error: ", "run 1 (search): ", "0.300001 s"));
}

}  // namespace
}  // namespace labmouse::test
