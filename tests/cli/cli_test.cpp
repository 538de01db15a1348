// The program from end to end: what it prints, where, and how it exits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <thread>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::json;
using test::AUser;
using test::content_of;
using test::corridor;
using test::Ended;
using test::Says;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A race's JSON without what differs from race to race.
void leave_times_out(Json& json) {
  for (Json& mouse : json.at("groups").at(0).at("mice")) {
    mouse.erase("microseconds_per_decision");
    for (Json& result : mouse.at("results")) result.erase("microseconds_per_decision");
  }
}

/// The commands that a help lists.
std::vector<std::string> commands_in(const std::string& help) {
  std::vector<std::string> commands;
  std::istringstream lines(help.substr(std::min(help.find("Subcommands:"), help.size())));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line.starts_with("  ")) commands.push_back(line.substr(2, line.find(' ', 2) - 2));
  return commands;
}

/// Its first example, of one line.
std::string example_in(const std::string& help) {
  const auto begin = help.find("Example: ");
  return begin == std::string::npos ? "" : help.substr(begin, help.find('\n', begin) - begin);
}

TEST_F(AUser, FindsHelpWithAnExampleOfItsOwnForEverything) {
  std::vector<std::vector<std::string>> left = {{}};
  std::set<std::string> examples;
  std::size_t seen = 0;
  for (; seen < left.size(); ++seen) {
    const std::vector<std::string> command = left[seen];
    std::vector<std::string> words = command;
    words.emplace_back("--help");
    const Ended help = labmouse(words);
    EXPECT_EQ(help.code, 0) << ::testing::PrintToString(command);
    EXPECT_EQ(help.err, "");
    const std::string example = example_in(help.out);
    std::string name = "labmouse";
    for (const std::string& word : command) name += " " + word;
    const auto inner = commands_in(help.out);
    EXPECT_THAT(example, HasSubstr(inner.empty() ? name : "labmouse"));
    // A command of commands may show the example of one of them.
    const bool is_new = !inner.empty() || examples.insert(example).second;
    EXPECT_TRUE(is_new) << example;
    for (const std::string& word : inner) {
      left.push_back(command);
      left.back().push_back(word);
    }
  }
  EXPECT_GT(seen, 30U);
}

TEST_F(AUser, CanRunTheExamplesOfTheHelp) {
  // The others need files of the user's own, or take long.
  for (const std::vector<std::string>& command : {std::vector<std::string>{"race"},
                                                  {"sweep"},
                                                  {"study"},
                                                  {"learn"},
                                                  {"run"},
                                                  {"show"},
                                                  {"inspect"},
                                                  {"make"},
                                                  {"convert"},
                                                  {"mice"},
                                                  {"rules", "show"},
                                                  {"bound"},
                                                  {"score"}}) {
    std::vector<std::string> words = command;
    words.emplace_back("--help");
    std::string example = example_in(labmouse(words).out);
    const std::string sign = "Example: ", program = "labmouse ", quoted = "'" LABMOUSE_PROGRAM "' ";
    ASSERT_TRUE(example.starts_with(sign)) << command.front();
    example.erase(0, sign.size());
    // Nobody looks at the steps.
    const std::string watch = " --watch";
    if (const auto at = example.find(watch); at != std::string::npos) example.erase(at, watch.size());
    for (std::size_t at = 0; (at = example.find(program, at)) != std::string::npos;)
      if (at == 0 || example[at - 1] == ' ') {
        example.replace(at, program.size(), quoted);
        at += quoted.size();
      } else {
        ++at;
      }
    if (command.front() == "learn") {
      // On one maze instead of all.
      const auto race = example.find(" race --mice");
      ASSERT_NE(race, std::string::npos);
      example.insert(race + 5, " --mazes capstone-1");
    }
    EXPECT_EQ(std::system(("cd " + folder_.string() + " && { " + example + "; } > out 2> err").c_str()), 0)
        << example << "\n"
        << content("err");
  }
}

TEST_F(AUser, AsksForTheVersion) {
  EXPECT_EQ(labmouse({"--version"}).out.find("labmouse 0."), 0U);
  EXPECT_EQ(labmouse({"--version"}).code, 0);
}

TEST_F(AUser, IsShownWhereToStart) {
  const Ended ended = labmouse({});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_THAT(ended.out, Says("labmouse race", "capstone:", "mms:", "--help"));
}

TEST_F(AUser, IsToldWhatAFileIsThatIsAnother) {
  file("corridor.txt", corridor);
  ASSERT_EQ(labmouse({"run", "flood", "corridor.txt", "--record", "walk.jsonl"}).code, 0);
  file("race.json", labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--format", "json"}).out);
  for (const std::vector<std::string>& maze_is_read_by :
       {std::vector<std::string>{"show"}, {"inspect"}, {"run", "flood"}, {"race", "--mazes"}}) {
    std::vector<std::string> words = maze_is_read_by;
    words.emplace_back("walk.jsonl");
    is_refused(words, "walk.jsonl", "record", "--record");
    words.back() = "race.json";
    is_refused(words, "race.json", "results", "labmouse report");
  }
  for (const char* command : {"replay", "score"}) {
    is_refused({command, "corridor.txt"}, "corridor.txt", "maze", "labmouse run");
    is_refused({command, "race.json"}, "race.json", "race", "labmouse report");
    is_refused({command, "."}, "folder");
  }
  const std::vector<std::string> baseline = {"race", "--mice", "flood", "--mazes", "corridor.txt", "--baseline"};
  for (const auto& [name, kind] : {std::pair("corridor.txt", "maze"), std::pair("walk.jsonl", "record")}) {
    std::vector<std::string> words = baseline;
    words.emplace_back(name);
    is_refused(words, name, kind, "results");
    is_refused({"race", "--mice-file", name}, name, kind, "mice file");
    is_refused({"mice-file", "check", name}, name, kind, "mice file");
  }
  is_refused({"run", "corridor.txt", "flood"}, "'corridor.txt'", "maze", "labmouse run flood corridor.txt");
  is_refused({"convert", "corridor.txt", "out.xyz"}, "out.xyz", "'.xyz'", "--format");
}

TEST_F(AUser, MayUseFormerNamesOfWorlds) {
  file("corridor.txt", corridor);
  for (const auto& [now, before] : {std::pair("steps", "strides"), std::pair("failures", "fallible")}) {
    const auto race = [&](const char* world) {
      Json json = Json::parse(labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--runs", "2", "--world",
                                        world, "--format", "json"})
                                  .out);
      leave_times_out(json);
      return json;
    };
    EXPECT_EQ(race(before), race(now));
    EXPECT_EQ(race(before).at("groups").at(0).at("world"), now);
  }
}

TEST_F(AUser, MayUseFormerNamesOfOptionsSpecsAndSettings) {
  file("corridor.txt", corridor);
  file("mice.toml", "[[mouse]]\nname = 'a'\nguest = 'false'\n");
  using Words = std::vector<std::string>;
  const std::vector<std::pair<Words, Words>> same = {
      {{"race", "--mice-file", "mice.toml", "--external-runs", "2"},
       {"race", "--lineup", "mice.toml", "--guest-runs=2"}},
      {{"race", "--mice", "flood", "a=program:false"}, {"race", "--mice", "flood", "a=guest:false"}},
      {{"race", "--mice", "mice-file:mice.toml:a"}, {"race", "--mice", "lineup:mice.toml:a"}},
      {{"race", "--world", "physical", "--runs", "1", "--mice", "c=controller:false"},
       {"race", "--world", "physical", "--runs", "1", "--mice", "c=pilot:false"}},
      {{"race", "--world", "physical", "--runs", "1", "--mice", "flood", "--variation", "1", "--map", "log-odds"},
       {"race", "--world", "physical", "--runs", "1", "--mice", "flood", "--spread", "1", "--map", "belief"}},
      {{"race", "--world", "failures", "--runs", "1", "--failure-rates", "kerise", "--mice",
        "m=festina:strategy=certify:map=log-odds-prior"},
       {"race", "--world", "failures", "--runs", "1", "--hazards", "kerise", "--mice",
        "m=festina:mind=certify:map=learned"}}};
  for (const auto& [now, before] : same) {
    const auto results = [&](Words words) {
      words.insert(words.end(), {"--mazes", "corridor.txt", "--format", "json"});
      const Ended ended = labmouse(words);
      Json json = Json::parse(ended.out, nullptr, false);
      EXPECT_TRUE(json.is_object()) << ended.err;
      if (json.is_object()) leave_times_out(json);
      return json;
    };
    EXPECT_EQ(results(before), results(now)) << testing::PrintToString(before);
  }
  EXPECT_EQ(labmouse({"hazards", "--help"}).out, labmouse({"failure-rates", "--help"}).out);
  EXPECT_EQ(labmouse({"lineup", "check", "mice.toml"}).out, labmouse({"mice-file", "check", "mice.toml"}).out);
}

TEST_F(AUser, IsToldInOneLineWhatIsWrong) {
  is_refused({"rase"}, "'rase'", "'race'");
  is_refused({"race", "--mise", "flood"}, "'--mise'", "'--mice'", "labmouse race --help");
  is_refused({"race", "--mouse", "flood"}, "'--mouse'", "'--mice'");
  is_refused({"race", "flood"}, "'flood'", "--mice flood");
  is_refused({"run", "flood"}, "maze", "for example");
  is_refused({"-v"}, "'-v'", "'--version'");
  is_refused({"race", "--world", "physics"}, "'physics'", "'physical'");
  is_refused({"race", "--mice", "flod"}, "'flod'", "'flood'");
  is_refused({"race", "--mice", "flood:stride=99"}, "'99'", "'stride'", "'flood'");
  is_refused({"race", "--mazes", "capston-1"}, "capston-1", "'capstone-1'");
  is_refused({"race", "--mazes", "capstone-1,"}, "error: the name of a maze", "empty");
  is_refused({"race", "--runs", "0"}, "--runs");
  is_refused({"race", "--jobs", "many"}, "--jobs");
  is_refused({"race", "--format", "xml"}, "--format");
  is_refused({"race", "--baseline", "nothing.json"}, "nothing.json: ", "no such");
  is_refused({"run", "flood"}, "error: 'maze' ", "missing");
  is_refused({"run", "flood,certify", "capstone-1"}, "one mouse");
  is_refused({"run", "flood", "capstone-1", "--start", "99,0"}, "'99,0'", "X,Y");
  is_refused({"run", "flood", "capstone-1", "--goal", "12,0"}, "(12,0)", "12x12");
  is_refused({"replay", "nothing.jsonl"}, "nothing.jsonl: ", "no such");
  is_refused({"make", "castle"}, "'castle'", "wilson");
  is_refused({"make", "Prim"}, "'Prim'", "'prim'");
  is_refused({"make", "empty", "--seed", "-1"}, "--seed", "'-1'", "2^64 - 1");
  is_refused({"make", "empty", "--seed", "18446744073709551616"}, "--seed", "'18446744073709551616'", "2^64 - 1");
  is_refused({"make", "empty", "--loops", "nan"}, "--loops", "'nan'");
  is_refused({"race", "--fail-above", "nan"}, "--fail-above", "'nan'");
  is_refused({"race", "--formt", "json"}, "'--formt'", "'--format'");
  is_refused({"score", "a", "b", "c"}, "'b'", "labmouse score --help");
}

TEST_F(AUser, IsToldWhichCommandsThereAre) {
  is_refused({"store"}, "command is missing", "merge", "verify", "labmouse store --help");
  is_refused({"store", "foo"}, "'foo'", "merge", "verify", "labmouse store --help");
  is_refused({"store", "marge"}, "'marge'", "'merge'");
  is_refused({"rules", "liste"}, "'liste'", "'list'");
  for (const char* word : {"help", "version"})
    is_refused({word}, std::string("'") + word + "'", std::string("'--") + word + "'");
}

TEST_F(AUser, IsToldWhichArgumentsACommandTakes) {
  is_refused({"run", "flood", "stride=1", "capstone-1"}, "'capstone-1'", "'mouse' and 'maze'");
  is_refused({"sweep", "flood", "certify", "--vary", "stride=1,2"}, "'certify'", "takes 'mouse'");
  is_refused({"drive", "contest-01"}, "'contest-01'", "options");
  is_refused({"mice-file", "init", "nowhere"}, "'nowhere'", "no folder");
}

TEST_F(AUser, IsToldInWhichWorldsASettingCounts) {
  is_refused({"run", "flood", "capstone-1", "--variation", "2"}, "--variation", "--world physical", "--world failures");
  is_refused({"race", "--world", "steps", "--robot", "half"}, "--robot", "--world seconds", "--world failures");
  is_refused({"race", "--world", "failures", "--noise", "2"}, "--noise", "--world physical");
}

TEST_F(AUser, IsToldTheRangeThatANumberHas) {
  file("m.txt", corridor);
  for (const char* pace : {"0.1", "2"}) {
    is_refused({"race", "--world", "failures", "--mazes", "m.txt", "--pace", pace}, "--pace", pace, "0.2 to 1");
    is_refused({"failure-rates", "--mazes", "m.txt", "--pace", pace}, "--pace", pace, "0.2 to 1");
  }
  is_refused({"failure-rates", "--mazes", "m.txt", "--rules", "time-trial"}, "--rules", "time-trial", "lap");
  is_refused({"failure-rates", "--mazes", "m.txt", "--mice", "program:true"}, "--mice", "external");
  is_refused({"run", "flood", "m.txt", "--goal", "99,99"}, "'99,99'", "0 to 63");
  is_refused({"sweep", "flood", "--vary", "stride=1-3", "--mazes", "m.txt"}, "'1-3'", "LOW:HIGH:STEP");
}

TEST_F(AUser, IsToldWhichNameNoMouseCanHave) {
  is_refused({"race", "--mice", "my mouse=flood", "--mazes", "capstone-1"}, "'my mouse'", "NAME=SPEC");
  is_refused({"race", "--mice", "my mouse=flod", "--mazes", "capstone-1"}, "'my mouse=flod'");
}

TEST_F(AUser, IsToldWhatIsWrongWithASweep) {
  is_refused({"sweep", "flood"}, "'--vary'", "missing");
  is_refused({"sweep", "--vary", "stride=1,2"}, "error: 'mouse' ", "missing");
  is_refused({"sweep", "flod", "--vary", "stride=1,2"}, "'flod'", "'flood'");
  is_refused({"sweep", "flood,certify", "--vary", "stride=1,2"}, "'flood,certify'", "2 mice");
  is_refused({"sweep", "flood", "--vary", "strid=1,2"}, "'strid'", "'stride'");
  is_refused({"sweep", "flood", "--vary", "stride=7:9:1"}, "'9'", "'stride'", "'flood'", "1 to 8");
  is_refused({"sweep", "flood", "--vary", "stride=1:3"}, "'1:3'", "LOW:HIGH:STEP");
  is_refused({"sweep", "flood", "--vary", "stride"}, "'stride'", "NAME=");
  is_refused({"sweep", "flood", "--vary", "stride=0:1:0.0001"}, "10001", "1000");
  is_refused({"sweep", "flood", "--vary", "stride=1", "--mazes", "capston-1"}, "capston-1", "'capstone-1'");
}

TEST_F(AUser, GetsNothingButJson) {
  const Ended ended = labmouse({"race", "--mice", "flood,random", "--runs", "2", "--format", "json", "--worst", "2"});
  EXPECT_TRUE(Json::accept(ended.out));
  EXPECT_THAT(ended.err, HasSubstr("worst mazes"));
}

TEST_F(AUser, GetsTheSameForAnyNumberOfJobsAndAnyOrder) {
  for (const char* folder : {"one", "two"}) std::filesystem::create_directories(folder_ / folder);
  file("one/bad.txt", "rubbish");
  file("two/bad.txt", "rubbish");
  file("one/corridor.txt", corridor);
  file("two/corridor.txt", corridor);
  Json forwards =
      race({"--jobs", "1", "--runs", "3", "--mice", "flood,certify,random", "--mazes", "one", "two", "spiral-9"});
  Json backwards = race({"--jobs", "3", "--runs", "3", "--mice", "random,certify", "--mice", "flood", "--mazes",
                         "spiral-9", "two", "one", "two"});
  leave_times_out(forwards);
  leave_times_out(backwards);
  EXPECT_EQ(forwards, backwards);
  EXPECT_EQ(forwards.at("skipped").size(), 2U);
}

TEST_F(AUser, SeesEveryMouseInTheTable) {
  const Ended ended = labmouse({"race", "--runs", "1"});
  EXPECT_EQ(ended.code, 0);
  const Json mice = Json::parse(labmouse({"mice", "--format", "json"}).out);
  EXPECT_GE(mice.size(), 18U);
  for (const Json& mouse : mice) {
    const bool races = ended.out.find("\n" + mouse["name"].get<std::string>() + " ") != std::string::npos;
    EXPECT_EQ(races, mouse["walks"].get<bool>()) << mouse["name"];
  }
  EXPECT_EQ(ended.err, "");
}

TEST_F(AUser, SetsTheBudget) {
  const auto steps = [this](const char* budget) {
    const Ended ended =
        labmouse({"race", "--mice", "wall-left", "--mazes", "island-8", "--budget", budget, "--format", "json"});
    const auto json = nlohmann::json::parse(ended.out);
    EXPECT_EQ(json["groups"][0]["budget"], std::stoi(budget));
    return json["groups"][0]["mice"][0]["results"][0]["search_steps"].get<int>();
  };
  EXPECT_EQ(steps("7"), 7);
  EXPECT_EQ(steps("1500"), 1500);
  EXPECT_THAT(labmouse({"run", "wall-left", "island-8", "--budget", "12"}).out, HasSubstr("out of steps"));
  EXPECT_EQ(labmouse({"race", "--budget", "0"}).code, 2);
}

TEST_F(AUser, ReadsTheBuiltinMiceAsJson) {
  const auto mice = nlohmann::json::parse(labmouse({"mice", "--format", "json"}).out);
  std::string table = labmouse({"mice"}).out;
  EXPECT_GT(mice.size(), 5U);
  for (const auto& mouse : mice) {
    EXPECT_THAT(table, HasSubstr(mouse["name"].get<std::string>() + " "));
    for (const auto& parameter : mouse["parameters"])
      EXPECT_THAT(table, HasSubstr("    " + parameter["name"].get<std::string>() + "=" +
                                   parameter["default"].get<std::string>()));
  }
}

TEST_F(AUser, AsksForTheSignatureAlone) {
  EXPECT_THAT(labmouse({"bench", "--signature"}).out, testing::MatchesRegex("[0-9a-f]+-[0-9a-f]+-[0-9a-f]+\n"));
}

TEST_F(AUser, AsksForTheMemoryOfStrategies) {
  const auto rows = nlohmann::json::parse(labmouse({"bench", "--memory", "--robot", "mm2021", "--format", "json"}).out);
  ASSERT_EQ(rows.size(), 2U);
  const std::string table = labmouse({"bench", "--memory", "--robot", "mm2021"}).out;
  for (const auto& row : rows) {
    EXPECT_EQ(row["robot"], "mm2021");
    std::ostringstream kib;
    kib << std::fixed << std::setprecision(1) << row["fields_bytes"].get<double>() / 1024.0;
    EXPECT_THAT(table, HasSubstr(" " + kib.str() + " "));
  }
  EXPECT_EQ(labmouse({"bench", "--robot", "mm2021"}).code, 2);
  EXPECT_EQ(labmouse({"bench", "--memory", "--robot", "no-such-robot"}).code, 2);
}

TEST_F(AUser, SeesNoColoursInAFile) {
  EXPECT_THAT(labmouse({"race", "--mice", "flood"}).out, Not(HasSubstr("\x1b")));
  EXPECT_THAT(labmouse({"show", "capstone-1"}).out, Not(HasSubstr("\x1b")));
}

TEST_F(AUser, SeesColoursOnATerminalUnlessNotWanted) {
  const auto wanted = test::on_a_terminal({"show", "capstone-1"}, "NO_COLOR=");
  const auto unwanted = test::on_a_terminal({"show", "capstone-1"}, "NO_COLOR=1");
  if (!wanted || !unwanted) GTEST_SKIP() << "this system lends no terminals";
  EXPECT_THAT(*wanted, HasSubstr("\x1b["));
  EXPECT_THAT(*unwanted, Not(HasSubstr("\x1b")));
}

TEST_F(AUser, CannotWatchInATerminalThatIsTooSmall) {
  const auto printed = test::on_a_terminal({"run", "flood", "capstone-1", "--watch"}, "NO_COLOR=1");
  if (!printed) GTEST_SKIP() << "this system lends no terminals";
  EXPECT_THAT(*printed, Says("terminal", "52x29"));
}

TEST_F(AUser, IsNotToldNamesThatSteerTheTerminal) {
  file("\x1b[31mred.txt", corridor);
  for (const char* command : {"bound", "inspect", "show"})
    EXPECT_THAT(labmouse({command, "\x1b[31mred.txt"}).out, Not(HasSubstr("\x1b"))) << command;
  EXPECT_THAT(labmouse({"show", "\x1b[31mred.txt", "--start", "60,60"}).err, Not(HasSubstr("\x1b")));
}

TEST_F(AUser, MayStopReadingEarly) { EXPECT_EQ(test::without_a_reader({"inspect", "spiral-9"}), 0); }

TEST_F(AUser, KeepsARecordOfEachMazeWhereTwoHaveOneName) {
  for (const char* folder : {"one", "two"}) {
    std::filesystem::create_directories(folder_ / folder);
    file(std::string(folder) + "/corridor.txt", corridor);
  }
  EXPECT_EQ(labmouse({"race", "--mice", "flood", "--mazes", "one", "two", "--out", "out"}).code, 0);
  for (const char* kept : {"corridor-1.jsonl", "corridor.svg", "corridor~2-1.jsonl", "corridor~2.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / "flood" / kept)) << kept;
}

TEST_F(AUser, KeepsALinkWhenItsTargetIsWritten) {
  file("target.txt", corridor);
  std::filesystem::create_symlink("target.txt", folder_ / "link.txt");
  EXPECT_EQ(labmouse({"make", "empty", "--size", "2x2", "-o", "link.txt"}).code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.txt"));
  EXPECT_THAT(content("target.txt"), AllOf(HasSubstr("o---o"), Not(HasSubstr(corridor))));
}

TEST_F(AUser, WritesIntoADeviceWithoutReplacingIt) {
  EXPECT_EQ(labmouse({"make", "empty", "-o", "/dev/null"}).code, 0);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(AUser, LearnsBeforeTheRaceThatTheFolderCannotBeWritten) {
  file("occupied", "a file where a folder should be");
  is_refused({"race", "--mice", "flood", "--out", "occupied/out"}, "occupied/out: error: ", "not a folder");
}

TEST_F(AUser, RacesOnPastLinksThatLeadNowhere) {
  std::filesystem::create_directories(folder_ / "mazes");
  file("mazes/fine.txt", corridor);
  std::filesystem::create_symlink("nowhere", folder_ / "mazes/dangling.txt");
  std::filesystem::create_symlink("round.txt", folder_ / "mazes/round.txt");
  for (const char* mazes : {"mazes", "mazes/*"}) {
    const Json json = race({"--mice", "flood", "--mazes", mazes});
    EXPECT_EQ(json.at("groups").at(0).at("mazes").size(), 1U);
    EXPECT_EQ(json.at("skipped").size(), 2U);
  }
}

TEST_F(AUser, MayHaveFailingMice) {
  file("closed.txt", "o---o---o\n| S | G |\no---o---o\n");
  const Ended ended = labmouse({"race", "--mice", "flood", "--mazes", "closed.txt"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("0/0"));
}

TEST_F(AUser, FailsABuildAboveAScore) {
  file("corridor.txt", corridor);
  EXPECT_EQ(labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--fail-above", "1.07"}).code, 0);
  const Ended above = labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--fail-above", "1.06"});
  EXPECT_EQ(above.code, 1);
  EXPECT_THAT(above.err, Says("flood", "1.067", "1.06"));
}

TEST_F(AUser, ComparesWithAnEarlierRace) {
  file("earlier.json", labmouse({"race", "--mice", "flood", "--format", "json"}).out);
  const Ended same = labmouse({"race", "--mice", "flood", "--baseline", "earlier.json"});
  EXPECT_EQ(same.code, 0);
  EXPECT_THAT(same.out, HasSubstr("flood: +0.000 [+0.000, +0.000]"));
  is_refused({"race", "--mice", "flood", "--baseline", file("bad.json", "{}")}, "bad.json: error: ", "JSON of a race");
  is_refused({"race", "--mice", "flod", "--baseline", "bad.json"}, "'flod'", "'flood'");
}

TEST_F(AUser, KeepsRecordsAndPicturesOfARace) {
  file("corridor.txt", corridor);
  ASSERT_EQ(labmouse({"race", "--mice", "flood,random", "--runs", "2", "--mazes", "corridor.txt", "--out", "out"}).code,
            0);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "out"))
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder_).string());
  EXPECT_EQ(files.size(), 3U + 2U + 1U);  // a record each, a picture a maze and mouse, and the results
  for (const std::string& name : files) {
    if (!name.ends_with(".jsonl")) continue;
    EXPECT_EQ(labmouse({"replay", name}).code, 0) << name;
  }
}

TEST_F(AUser, KeepsTheResultsOfARaceWhateverIsPrinted) {
  file("corridor.txt", corridor);
  const Ended table = labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--out", "out"});
  Json saved = Json::parse(content("out/results.json"));
  EXPECT_THAT(table.out, HasSubstr("95 %"));
  const Ended json =
      labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--out", "again", "--format", "json"});
  EXPECT_EQ(json.out, content("again/results.json"));
  Json printed = Json::parse(json.out);
  leave_times_out(saved);
  leave_times_out(printed);
  EXPECT_EQ(saved, printed);
  std::filesystem::create_directories(folder_ / "blocked/results.json");
  const Ended blocked = labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--out", "blocked"});
  EXPECT_EQ(blocked.code, 2);
  EXPECT_THAT(blocked.err, Says("blocked/results.json: error: ", "is a folder"));
  EXPECT_THAT(blocked.out, HasSubstr("flood"));
}

TEST_F(AUser, SweepsAParameter) {
  file("corridor.txt", corridor);
  const Ended ended = labmouse({"sweep", "random", "--vary", "stride=1:2:1", "--mazes", "corridor.txt", "--runs", "5",
                                "--csv", "out/results.csv", "--svg", "out/strides.svg"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_THAT(ended.out, Says("interval", "5 runs"));
  const std::string csv = content("out/results.csv");
  EXPECT_THAT(csv, HasSubstr("value,mean,low,high,failures,runs\n1,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_THAT(content("out/strides.svg"), HasSubstr("<svg"));
}

TEST_F(AUser, SweepsANumberOfARobot) {
  file("corridor.txt", corridor);
  const std::vector<std::string> sweep = {
      "sweep", "festina",       "--world", "seconds",       "--mazes",        "corridor.txt",
      "--csv", "out/robot.csv", "--svg",   "out/robot.svg", "--robot-number", "straight.acceleration=3000:9000:3000"};
  const Ended ended = labmouse(sweep);
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_THAT(ended.out, Says("classic", "straight.acceleration", "6000", "difference"));
  const std::string csv = content("out/robot.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  EXPECT_THAT(content("out/robot.svg"), HasSubstr("<svg"));
  std::vector<std::string> as_json = sweep;
  as_json.insert(as_json.end(), {"--format", "json", "--store", "all.db"});
  for (const char* said : {"0 contests from it, 3 added", "3 contests from it, 0 added"}) {
    const Ended printed = labmouse(as_json);
    EXPECT_EQ(printed.code, 0);
    EXPECT_THAT(printed.err, HasSubstr(said));
    EXPECT_EQ(nlohmann::json::parse(printed.out)["values"].size(), 3U);
  }
  const std::string name = file("mine.toml", content_of(LABMOUSE_SOURCE_DIR "/robots/half.toml"));
  const Ended own = labmouse({"sweep", "festina", "--world", "seconds", "--mazes", "corridor.txt", "--robot", name,
                              "--robot-number", "diagonals=true,false"});
  EXPECT_EQ(own.code, 0) << own.err;
  EXPECT_THAT(own.out, HasSubstr("mine.toml"));
}

TEST_F(AUser, IsToldWhatIsWrongWithASweepOfRobots) {
  const auto refused = [&](const char* number, auto... parts) {
    is_refused({"sweep", "flood", "--world", "seconds", "--robot-number", number}, parts...);
  };
  refused("straight.acceleration=5", "straight.acceleration=5", "100 to 200000");
  refused("straight.acceleration", "NAME=", "straight.acceleration");
  refused("straight.acceleration=1:2", "'1:2'", "LOW:HIGH:STEP");
  refused("speed=3", "'speed'", "'straight.speed'");
  is_refused({"sweep", "flood", "--robot-number", "sight=1,2"}, "steps", "--world seconds");
  is_refused({"sweep", "flood", "--robot-number", "sight=1,2", "--vary", "stride=1,2"}, "--vary", "--robot-number");
  is_refused({"sweep", "flood,certify", "--world", "seconds", "--robot-number", "sight=1,2"}, "2 mice");
  is_refused({"sweep", "flood", "--world", "seconds", "--robot", "half,classic", "--robot-number", "sight=1,2"}, "one");
  is_refused({"sweep", "flood", "--world", "failures", "--robot-number", "straight.acceleration=3000"}, "failures",
             "--world physical");
}

TEST_F(AUser, SeesTheSweepWhoseFilesCannotBeWritten) {
  file("corridor.txt", corridor);
  std::vector<std::string> sweep = {"sweep", "flood", "--vary", "stride=1,2", "--mazes", "corridor.txt", "--csv"};
  sweep.emplace_back("/dev/full");
  const Ended ended = labmouse(sweep);
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.out, HasSubstr("Lowest mean"));
  EXPECT_THAT(ended.err, Says("/dev/full: error: ", "no space"));
  sweep.back() = "corridor.txt/a.csv";
  is_refused(sweep, "corridor.txt/a.csv: error: ", "not a folder");
}

TEST_F(AUser, WhoInterruptsASweepAtOnceLosesNoFile) {
  file("corridor.txt", corridor);
  file("results.csv", "value,mean,low,high,kept");
  const test::Program program(folder_, {"sweep", "random", "--vary", "stride=1:8:1", "--mazes", "corridor.txt",
                                        "--runs", "500000", "--jobs", "1", "--csv", "results.csv"});
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!program.handles_interrupts() && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
  program.interrupt();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_THAT(ended.out, Says("Stopped", "0 of 8 values"));
  EXPECT_EQ(content("results.csv"), "value,mean,low,high,kept");
}

TEST_F(AUser, SeesHowMuchOfTheMazesWasSeen) {
  file("corridor.txt", corridor);
  const Ended raced = labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--shares"});
  EXPECT_THAT(raced.out, HasSubstr("\nmouse discovered% visited%\nflood       100.0    100.0\n"));
  const Ended as_data = labmouse({"race", "--mice", "flood", "--mazes", "corridor.txt", "--shares", "--format", "csv"});
  EXPECT_THAT(as_data.out, Not(HasSubstr("discovered%")));
  EXPECT_THAT(as_data.err, HasSubstr("discovered%"));
  EXPECT_THAT(labmouse({"run", "flood", "corridor.txt"}).out,
              Says("discovered 100.0 %", "visited 100.0 %", "3 reachable cells", "\nflood in corridor.txt: finished"));
}

TEST_F(AUser, LearnsTheBound) {
  const Ended ended = labmouse({"bound", "capstone-1"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("17.600"));
}

TEST_F(AUser, SeesTheWayOfAnExplorationThatNeverEnded) {
  file("corridor.txt", corridor);
  EXPECT_THAT(labmouse({"run", "flood", "corridor.txt", "--budget", "1"}).out,
              Says("+ 1 step to the goal", "never reset"));
  EXPECT_THAT(labmouse({"run", "flood", "corridor.txt"}).out, AllOf(HasSubstr("finished"), Not(HasSubstr("+ 1 step"))));
}

TEST_F(AUser, ReplaysAndScoresARecord) {
  ASSERT_EQ(labmouse({"run", "certify", "capstone-1", "--record", "walk.jsonl", "--svg", "walk.svg"}).code, 0);
  EXPECT_THAT(content("walk.svg"), HasSubstr("<svg"));
  const Ended replayed = labmouse({"replay", "walk.jsonl"}), scored = labmouse({"score", "walk.jsonl"});
  EXPECT_EQ(replayed.code, 0);
  EXPECT_EQ(scored.code, 0);
  EXPECT_THAT(replayed.out, HasSubstr("certify in capstone-1: finished, score "));
  EXPECT_THAT(replayed.out, HasSubstr(scored.out));
}

TEST_F(AUser, SeesARecordInLayers) {
  const Ended ran = labmouse({"run", "flood", "capstone-1", "--record", "walk.jsonl", "--svg", "run.svg"});
  ASSERT_EQ(ran.code, 0);
  const Ended shown = labmouse({"show", "--record", "walk.jsonl"});
  // The same picture; `run` has a line more, on what the search run saw.
  const auto picture = [](const std::string& out) { return out.substr(0, out.rfind("o---o")); };
  EXPECT_EQ(picture(shown.out), picture(ran.out));
  EXPECT_EQ(shown.err, "");
  EXPECT_EQ(labmouse({"show", "--record", "walk.jsonl", "--svg", "show.svg"}).code, 0);
  EXPECT_EQ(content("show.svg"), content("run.svg"));
  const Ended layers = labmouse({"show", "--record", "walk.jsonl", "--layer", "search,wrong", "--layer", "known"});
  EXPECT_THAT(layers.out, HasSubstr("+ 30 steps to the goal\n# "));
  EXPECT_THAT(layers.out, HasSubstr("- -"));
  EXPECT_EQ(layers.err, "");
}

TEST_F(AUser, IsToldWhichLayersTheTerminalLeavesOut) {
  ASSERT_EQ(labmouse({"run", "flood", "capstone-1", "--record", "walk.jsonl"}).code, 0);
  EXPECT_THAT(labmouse({"show", "--record", "walk.jsonl", "--layer", "heat,path"}).err,
              AllOf(Says("heat", "--svg", "colours"), Not(HasSubstr("path"))));
  const Ended shares = labmouse({"show", "--record", "walk.jsonl", "--layer", "shares"});
  EXPECT_THAT(shares.err, AllOf(Says("shares", "--svg"), Not(HasSubstr("colours"))));
  EXPECT_THAT(shares.out, HasSubstr(" of 144 cells visited ("));
  const Ended picture = labmouse({"show", "--record", "walk.jsonl", "--layer", "heat,shares", "--svg", "walk.svg"});
  EXPECT_EQ(picture.err + picture.out, "");
  EXPECT_THAT(content("walk.svg"), HasSubstr(" of 144 cells discovered ("));
}

TEST_F(AUser, SeesAMazeInLayers) {
  EXPECT_EQ(labmouse({"show", "capstone-1", "--layer", "path,coordinates,distances"}).out,
            labmouse({"show", "capstone-1", "--distances"}).out);
  EXPECT_EQ(labmouse({"show", "capstone-1", "--layer", "coordinates"}).out,
            labmouse({"show", "capstone-1", "--no-route"}).out);
  EXPECT_EQ(labmouse({"show", "capstone-1", "--layer", "cells"}).err, "");
}

TEST_F(AUser, IsToldWhatCannotBeShown) {
  ASSERT_EQ(labmouse({"run", "flood", "capstone-1", "--record", "walk.jsonl"}).code, 0);
  is_refused({"show"}, "either", "--record");
  is_refused({"show", "capstone-1", "--record", "walk.jsonl"}, "either", "--record");
  is_refused({"show", "--record", "walk.jsonl", "--layer", "heat,pth"}, "'pth'", "'path'");
  is_refused({"show", "--record", "walk.jsonl", "--layer", ""}, "--layer", "empty");
  is_refused({"show", "--record", "walk.jsonl", "--layer", "cells", "--distances"}, "--distances", "layer cells");
  is_refused({"show", "--record", "walk.jsonl", "--goal", "1,1"}, "--goal", "record");
  is_refused({"show", "capstone-1", "--layer", "heat"}, "layer heat", "--record");
  is_refused({"show", "--record", "nothing.jsonl"}, "nothing.jsonl: ", "no such");
  file("bare.jsonl", R"({"labmouse":"record","format":1,"mouse":{"name":"flood"}})");
  is_refused({"show", "--record", "bare.jsonl"}, "bare.jsonl: error: ", "--maze");
}

TEST_F(AUser, SeesHowFarARecordWithoutAnEndGoes) {
  ASSERT_EQ(labmouse({"run", "flood", "capstone-1", "--record", "walk.jsonl"}).code, 0);
  const std::string whole = content("walk.jsonl");
  std::size_t end = 0;
  for (int line = 0; line < 20; ++line) end = whole.find('\n', end) + 1;
  file("cut.jsonl", whole.substr(0, end));
  const Ended cut = labmouse({"show", "--record", "cut.jsonl", "--layer", "search,path"});
  EXPECT_EQ(cut.code, 0);
  EXPECT_THAT(cut.err, Says("layer path", "no speed run"));
  EXPECT_THAT(cut.out, Says("+ 19 steps", "no goal", "\nflood in capstone-1: ", "breaks off after step 19"));
  EXPECT_EQ(labmouse({"show", "--record", "cut.jsonl", "--svg", "cut.svg"}).code, 0);
  EXPECT_THAT(content("cut.svg"), HasSubstr("<title>flood in capstone-1: breaks off after step 19</title>"));
}

TEST_F(AUser, CannotReplayATamperedRecord) {
  ASSERT_EQ(labmouse({"run", "flood", "capstone-1", "--record", "walk.jsonl"}).code, 0);
  std::string text = content("walk.jsonl");
  const auto reading = text.find("\"reading\":[0,11,0]");
  ASSERT_NE(reading, std::string::npos);
  file("tampered.jsonl", text.replace(reading, 18, "\"reading\":[0,10,0]"));
  const Ended ended = labmouse({"replay", "tampered.jsonl"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, Says("tampered.jsonl: error: ", "step 1:", "0 10 0", "0 11 0"));
  const Ended shown = labmouse({"show", "--record", "tampered.jsonl"});
  EXPECT_EQ(shown.code, 1);
  EXPECT_EQ(shown.err, ended.err);
}

TEST_F(AUser, CannotReplayARecordInAnotherMaze) {
  ASSERT_EQ(labmouse({"run", "flood", "capstone-1", "--record", "walk.jsonl"}).code, 0);
  EXPECT_EQ(labmouse({"replay", "walk.jsonl", "--maze", "empty-12"}).code, 1);
}

TEST_F(AUser, WhoInterruptsARaceSeesWhatIsDone) {
  file("corridor.txt", corridor);
  // Far more contests than a minute holds; the first record shows that the race is under way.
  std::vector<std::string> arguments = {"race",   "--mazes", "corridor.txt", "--mice", "random", "--runs", "500000",
                                        "--jobs", "1",       "--format",     "json",   "--out",  "out"};
  const test::Program program(folder_, arguments);
  const auto first = folder_ / "out" / "random";
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while ((!std::filesystem::exists(first) || std::filesystem::is_empty(first)) &&
         std::chrono::steady_clock::now() < patience)
    std::this_thread::yield();
  program.interrupt();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 130);
  const Json json = Json::parse(ended.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded()) << ended.err;
  EXPECT_EQ(json.at("stopped"), true);
  EXPECT_GE(json.at("groups").at(0).at("mice").at(0).at("results").size(), 1U);
  EXPECT_LT(json.at("groups").at(0).at("mice").at(0).at("results").size(), 500'000U);
}

}  // namespace
}  // namespace labmouse
