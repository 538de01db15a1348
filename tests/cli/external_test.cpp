// External mice of the capstone world, raced as a user does.
#include <thread>

#include "tests/busy_machine.hpp"
#include "tests/cli/user.hpp"
#include "tests/external/bad_programs.hpp"

namespace labmouse::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// The SPEC of an external mouse that misbehaves in that way; see tests/external/bad/bad_program.cpp.
std::string bad(const std::string& how) { return "program:\"" LABMOUSE_BAD_PROGRAM "\" \"" + how + "\" " + tag(); }

class AHostOfPrograms : public AUser {
 protected:
  AHostOfPrograms() { file("corridor.txt", corridor); }

  Ended race_in_the_corridor(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"race", "--mazes", "corridor.txt"});
    return labmouse(std::move(arguments));
  }
};

TEST_F(AHostOfPrograms, RacesThemBesideTheOthers) {
  const auto json = race({"--mice", "flood," + bad("die"), "--mice", bad("turn"), "--mazes", "corridor.txt"});
  ASSERT_EQ(json["groups"][0].at("mice").size(), 3U);
  EXPECT_EQ(json["groups"][0]["mice"][0]["name"], "flood");
  EXPECT_EQ(json["groups"][0]["mice"][1]["results"][0]["outcome"], "forfeit: ended early");
  EXPECT_THAT(json["groups"][0]["mice"][1]["results"][0]["last_words"].get<std::string>(),
              Says("exit code 3", "\none\ntwo\nthree: no way out"));
  EXPECT_EQ(json["groups"][0]["mice"][2]["results"][0]["outcome"], "out of steps");
  EXPECT_FALSE(json["groups"][0]["mice"][2]["results"][0].contains("last_words"));
}

TEST_F(AHostOfPrograms, TellsHowTheyFailedInTheTable) {
  const Ended ended = race_in_the_corridor({"--mice", bad("die")});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, Says("forfeit (ended early) 1\n", "corridor.txt", "exit code 3",
                              "\n    | one\n    | two\n    | three: no way out\n"));
}

TEST_F(AHostOfPrograms, FailsARaceInWhichOneNeverStarted) {
  file("mute.py", "raise SystemExit(2)\n");
  const Ended ended = race_in_the_corridor({"--mice", "flood,program:python3 mute.py", "--external-runs", "2"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.out, HasSubstr("flood"));
  EXPECT_THAT(ended.err, Says("program:python3 mute.py", "start", "exit code 2"));
  EXPECT_EQ(race_in_the_corridor({"--mice", "flood,mms:python3 mute.py", "--world", "each"}).code, 1);
  const Ended swept = labmouse({"sweep", "program:python3 mute.py {speed}", "--vary", "speed=1,2", "--mazes",
                                "corridor.txt", "--format", "table"});
  EXPECT_EQ(swept.code, 1);
  EXPECT_THAT(swept.out, Not(HasSubstr("Lowest"))) << "no value is better than another";
}

TEST_F(AHostOfPrograms, HasTheSameResultsOnABusyMachine) {
  // Limits of half a second, and an import that takes some of it.
  file("slow.py", "import decimal, email, json, unittest\nprint('labmouse 1', flush=True)\n");
  const auto results = [this] {
    const Ended ended = labmouse({"race",
                                  "--format",
                                  "json",
                                  "--mazes",
                                  "corridor.txt",
                                  "--start-limit",
                                  "0.5",
                                  "--silence-limit",
                                  "0.5",
                                  "--contest-limit",
                                  "0.5",
                                  "--mice",
                                  "program:python3 slow.py",
                                  "--mice",
                                  bad("turn"),
                                  "--mice",
                                  bad("work at the start"),
                                  "--mice",
                                  bad("hang at the start"),
                                  "--mice",
                                  bad("hang"),
                                  "--mice",
                                  bad("burn")});
    const auto json = nlohmann::json::parse(ended.out);
    auto outcomes = nlohmann::json::object();
    for (const auto& mouse : json["groups"][0]["mice"])
      outcomes[std::string(mouse["name"])] = mouse["results"][0]["outcome"];
    return outcomes;
  };
  const auto idle = results();
  EXPECT_EQ(idle.size(), 6U);
  EXPECT_EQ(idle["program:python3 slow.py"], "forfeit: ended early");
  for (const char* how : {"turn", "work at the start"}) EXPECT_EQ(idle[bad(how)], "out of steps");
  const BusyMachine busy;
  EXPECT_EQ(results(), idle);
}

TEST_F(AHostOfPrograms, ShowsTheirLastWordsAfterARun) {
  const Ended ended = labmouse({"run", bad("die"), "corridor.txt", "--record", "died.jsonl"});
  EXPECT_THAT(ended.out, Says("exit code 3\n| one\n| two\n| three: no way out\n"));
  EXPECT_THAT(labmouse({"replay", "died.jsonl"}).out, HasSubstr("| three: no way out\n"));
}

TEST_F(AHostOfPrograms, TellsWhichOfTheirStepsWereNotPerformed) {
  file("clumsy.sh", "echo labmouse 1\nwhile read -r word rest; do [ $word != sense ] || echo move 45 4; done\n");
  const std::string clumsy = "program:sh clumsy.sh";
  const auto lines =
      Says("5 of 5 steps", "blocked by a wall", "void turn", "cut to 3 cells",
           "step 1 at (0,0) heading north: turn +45, move +4\n",
           "\nprogram:sh clumsy.sh in corridor.txt: out of steps at (0,0) heading north", "5 search", "bound 1.067\n");
  const Ended run = labmouse({"run", clumsy, "corridor.txt", "--budget", "5", "--record", "clumsy.jsonl"});
  EXPECT_THAT(run.out, lines);
  // Behind the run stands whether there was a sandbox.
  EXPECT_THAT(run.out, testing::StartsWith(labmouse({"replay", "clumsy.jsonl"}).out));
  const Ended watched = labmouse({"replay", "clumsy.jsonl", "--watch"});
  EXPECT_THAT(watched.out, HasSubstr("turn +45, move +4 (invalid turn)  blocked\n"));
  EXPECT_THAT(watched.out, lines);
  EXPECT_THAT(race_in_the_corridor({"--mice", clumsy, "--budget", "5"}).out,
              Says("\n  program:sh clumsy.sh: 5 blocked", "5 void", "5 cut", "corridor.txt, step 1\n"));
  const auto json = race({"--mice", clumsy, "--budget", "5", "--mazes", "corridor.txt"});
  EXPECT_EQ(json["groups"][0]["mice"][0]["results"][0]["cut_movements"], 5);
}

TEST_F(AHostOfPrograms, SaysNothingOfStepsThatWerePerformed) {
  const Ended watched = labmouse({"run", "flood", "corridor.txt", "--watch"});
  EXPECT_THAT(watched.out, HasSubstr("sees 0 0 2  turn +90, move +2\n"));
  EXPECT_EQ(watched.out.find("blocked"), std::string::npos);
  EXPECT_EQ(watched.out.find("void"), std::string::npos);
}

TEST_F(AHostOfPrograms, LetsNothingThroughThatSteersATerminal) {
  const Ended ended = race_in_the_corridor({"--mice", bad("bytes")});
  EXPECT_EQ(ended.out.find('\x1b'), std::string::npos);
  EXPECT_THAT(ended.out, HasSubstr("forfeit (invalid answer) 1"));
}

TEST_F(AHostOfPrograms, HoldsThemToTheLimitsThatAreAskedFor) {
  EXPECT_THAT(race_in_the_corridor({"--mice", bad("hang"), "--silence-limit", "0.05"}).out,
              HasSubstr("forfeit (hung) 1"));
  EXPECT_THAT(race_in_the_corridor({"--mice", bad("hang at the start"), "--start-limit", "0.05"}).out,
              HasSubstr("forfeit (hung) 1"));
  EXPECT_THAT(race_in_the_corridor({"--mice", bad("turn"), "--contest-limit", "0.1", "--budget", "1000000"}).out,
              HasSubstr("forfeit (out of time) 1"));
  EXPECT_THAT(race_in_the_corridor({"--mice", bad("eat memory"), "--memory", "256", "--decision-limit", "20"}).out,
              HasSubstr("too much memory"));
}

TEST_F(AHostOfPrograms, RunsEachAsOftenAsAsked) {
  const auto json = race({"--mice", bad("end"), "--external-runs", "3", "--mazes", "corridor.txt"});
  EXPECT_EQ(json["groups"][0]["mice"][0]["runs"], 3);
}

TEST_F(AHostOfPrograms, IsToldWhereverTheyAreFree) {
  const Ended run = labmouse({"run", bad("die"), "corridor.txt", "--sandbox", "off"});
  EXPECT_THAT(run.out, HasSubstr("without a sandbox"));
  EXPECT_THAT(race_in_the_corridor({"--mice", bad("die"), "--sandbox", "off"}).out, HasSubstr("without a sandbox"));
  EXPECT_THAT(labmouse({"mms", "true", "--maze", "corridor.txt", "--sandbox", "off"}).out,
              HasSubstr("without a sandbox"));
}

/// Dies with all that it can find out as its last words: the seed that it was told, what it remembers, and mazes.
constexpr const char* cheat = R"(#!/bin/sh
while read -r word rest; do
  [ $word != seed ] || echo "seed $rest" >&2
  [ $word != begin ] || break
done
cat memory.txt >&2
echo I was here >> memory.txt
cat corridor.txt wider.txt results.db mice/*.txt 2> /dev/null | head -c 300 >&2
tr '\0' ' ' < /proc/1/cmdline >&2
)";

class ACheat : public AHostOfPrograms {
 protected:
  ACheat() {
    file("cheat.sh", cheat);
    file("wider.txt", "o---o---o---o---o\n| S           G |\no---o---o---o---o\n");
  }

  /// Its last words in each of its contests.
  std::vector<std::string> words(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"--mice", "program:sh cheat.sh", "--mazes", "corridor.txt", "wider.txt", "--jobs", "1"});
    more.insert(more.begin(), {"race", "--format", "json"});
    std::vector<std::string> all;
    const auto json = nlohmann::json::parse(labmouse(std::move(more)).out, nullptr, false);
    for (const auto& result : json["groups"][0]["mice"][0]["results"]) all.push_back(result["last_words"]);
    return all;
  }
  static std::string seed_of(const std::string& words) {
    const auto at = words.find("seed ");
    return words.substr(at, words.find('\n', at) - at);
  }
  bool has_sandboxes() const {
    return labmouse({"run", "program:sh cheat.sh", "corridor.txt", "--sandbox", "on"}).code != 2;
  }
};

TEST_F(ACheat, FindsNoMazesAndRemembersNothing) {
  if (!has_sandboxes()) GTEST_SKIP() << "no sandboxes here";
  for (const std::string& said : words({"--store", "results.db"})) {
    EXPECT_EQ(said.find("o---o"), std::string::npos);
    EXPECT_EQ(said.find("SQLite"), std::string::npos);
    EXPECT_EQ(said.find("I was here"), std::string::npos);
    EXPECT_EQ(said.find("race"), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "memory.txt"));
}

TEST_F(ACheat, FindsNoMazesInFoldersThatItNames) {
  if (!has_sandboxes()) GTEST_SKIP() << "no sandboxes here";
  for (const char* folder : {"own", "named", "imported"}) std::filesystem::create_directory(folder_ / folder);
  file("own/cheat.sh",
       "echo labmouse 1\nwhile read -r word rest; do [ $word != begin ] || break; done\n"
       "for folder in \"$1\" \"$PYTHONPATH\"; do ls $folder >&2; cat $folder/*.txt 2> /dev/null | head -c 300 >&2; "
       "done\n");
  for (const char* folder : {"named", "imported"}) {
    file(std::string(folder) + "/copy.txt", corridor);
    file(std::string(folder) + "/code_" + folder, "code");
  }
  const std::string imported = (folder_ / "imported").string();
  ASSERT_EQ(setenv("PYTHONPATH", imported.c_str(), 1), 0);
  const auto json = race({"--mice", "program:sh own/cheat.sh named", "--mazes", "corridor.txt"});
  ASSERT_EQ(unsetenv("PYTHONPATH"), 0);
  const std::string said = json["groups"][0]["mice"][0]["results"][0]["last_words"];
  EXPECT_THAT(said, Says("code_named", "code_imported"));
  EXPECT_EQ(said.find("o---o"), std::string::npos) << said;
}

TEST_F(ACheat, IsToldOfWhereItIsNotKeptFromThat) {
  if (!has_sandboxes()) GTEST_SKIP() << "no sandboxes here";
  const auto kept = words({"--keep-folder"});
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_THAT(kept[1], HasSubstr("I was here"));
  EXPECT_EQ(kept[1].find("o---o"), std::string::npos);
  EXPECT_THAT(words({"--sandbox", "off"})[0], HasSubstr("o---o"));
  EXPECT_THAT(race_in_the_corridor({"--mice", "program:sh cheat.sh", "--keep-folder"}).out, HasSubstr("--keep-folder"));
  EXPECT_THAT(race_in_the_corridor({"--mice", "program:sh cheat.sh", "--sandbox", "off"}).out,
              HasSubstr("Not protected against reading mazes"));
}

TEST_F(ACheat, IsToldTheSameSeedInAllMazes) {
  const auto two = words({"--external-runs", "2"});
  ASSERT_EQ(two.size(), 4U);
  EXPECT_EQ(seed_of(two[0]), seed_of(two[2]));
  EXPECT_EQ(seed_of(two[1]), seed_of(two[3]));
  EXPECT_NE(seed_of(two[0]), seed_of(two[1]));
  EXPECT_NE(seed_of(words({"--seed", "2"})[0]), seed_of(two[0]));
  // The same contest again, by the seed of its result. Without a sandbox, it remembers so much that its seed is cut
  // off.
  file("memory.txt", "");
  const std::string seed = seed_of(two[0]).substr(std::string("seed ").size());
  EXPECT_THAT(labmouse({"race", "--format", "csv", "--mice", "program:sh cheat.sh", "--mazes", "corridor.txt"}).out,
              HasSubstr("," + seed + ","));
  EXPECT_THAT(labmouse({"run", "program:sh cheat.sh", "corridor.txt", "--seed", seed}).out, HasSubstr(seed_of(two[0])));
}

TEST_F(AHostOfPrograms, LeavesOutOfAllMeansWhatItCannotJudge) {
  const std::vector<std::string> busy = {"--mice", "flood", "--mice", bad("wait for a disk"), "--start-limit", "0.03"};
  const Ended table = race_in_the_corridor(busy);
  EXPECT_EQ(table.code, 0);
  EXPECT_THAT(table.out, Says("Not judged", "disk\" " + tag() + " 1\n"));
  auto arguments = busy;
  arguments.insert(arguments.end(), {"--mazes", "corridor.txt", "--store", "results.db"});
  const auto json = race(arguments);
  const auto& mouse =
      json["groups"][0]["mice"][0]["name"] == "flood" ? json["groups"][0]["mice"][1] : json["groups"][0]["mice"][0];
  EXPECT_EQ(mouse["results"][0]["outcome"], "not judged");
  EXPECT_EQ(mouse["runs"], 0);
  EXPECT_THAT(labmouse({"store", "show", "results.db"}).out, testing::Not(HasSubstr("wait for a disk")));
}

TEST_F(AHostOfPrograms, StartsThemInTheirFolder) {
  std::filesystem::create_directories(folder_ / "place");
  std::filesystem::copy_file(LABMOUSE_BAD_PROGRAM, folder_ / "place" / "mouse");
  EXPECT_THAT(race_in_the_corridor({"--mice", "program:./mouse end", "--directory", "place"}).out,
              HasSubstr("forfeit (ended early) 1"));
  is_refused({"race", "--mice", "program:./mouse end"}, "no file", "'./mouse'");
}

TEST_F(AHostOfPrograms, RefusesWhatIsNoExternal) {
  is_refused({"race", "--mice", "program:"}, "'program:'", "command is empty");
  is_refused({"race", "--mice", "program:python3 \"my mouse.py"}, "quotation mark");
  is_refused({"race", "--mice", "program:no-such-program-anywhere"}, "'no-such-program-anywhere'", "PATH", "./mouse");
  is_refused({"race", "--mice", "flood,capstone:nowhere.py"}, "no such file", "'nowhere.py'");
  file("robot.py", "");
  is_refused({"race", "--mice", "capstone:robot.py", "--python", "no-such-python"}, "no executable interpreter",
             "'no-such-python'");
  is_refused({"race", "--mice", "capstone:robot.py", "--python", LABMOUSE_BAD_PROGRAM}, "working Python",
             LABMOUSE_BAD_PROGRAM);
  is_refused({"race", "--mice", "capstone:robot.py,flood"}, "'robot.py,flood'", "colon");
  is_refused({"race", "--mice", "capstone:."}, "'.'", "is a folder");
  is_refused({"race", "--mice", "program:./robot.py"}, "'./robot.py'", "'python3 ./robot.py'");
  is_refused({"race", "--mice", "program:robot.py"}, "'robot.py'", "'python3 robot.py'");
  is_refused({"race", "--mice", "program:./corridor.txt"}, "'./corridor.txt'", "chmod +x ./corridor.txt");
  is_refused({"race", "--mice", "program:~/mouse"}, "'~/mouse'", "full path");
  is_refused({"race", "--mice", "robot.py"}, "'robot.py'", "'capstone:robot.py'");
  is_refused({"race", "--mice", "python3 robot.py"}, "'python3 robot.py'", "'capstone:FILE'");
  is_refused({"race", "--mice", "Capstone"}, "'Capstone'", "'capstone:FILE'");
  is_refused({"race", "--mice", "program:a\tb"}, "unprintable");
  is_refused({"run", "mms:ls", "corridor.txt", "--world", "steps"}, "'mms:ls'", "mms");
  is_refused({"sweep", bad("end"), "--vary", "stride=1:2:1"}, "{stride}");
}

TEST_F(AHostOfPrograms, FindsRobotsInTheFolderOfTheUser) {
  file("robot.py",
       "class Robot(object):\n  def __init__(self, size): pass\n  def next_move(self, seen): return 90, 0\n");
  const std::string home = "HOME=" + folder_.string();
  EXPECT_EQ(labmouse({"run", "capstone:~/robot.py", "corridor.txt", "--budget", "3"}, home.c_str()).code, 0);
}

TEST_F(AHostOfPrograms, SaysWhichMazesRobotsDoNotExpect) {
  file("robot.py",
       "class Robot(object):\n  def __init__(self, size): pass\n  def next_move(self, seen): return 90, 0\n");
  const std::vector<std::string> robot = {"--mice", "capstone:robot.py", "--budget", "3"};
  EXPECT_THAT(race_in_the_corridor(robot).out, Says("Capstone robots", "1 maze", "corridor.txt"));
  EXPECT_THAT(labmouse({"race", "--mice", "capstone:robot.py", "--budget", "3", "--mazes", "capstone-1"}).out,
              testing::Not(HasSubstr("Capstone robots")));
}

TEST_F(AHostOfPrograms, RunsThemSideBySide) {
  // Each waits for the other one, so that neither would end if they ran in turn.
  const auto json =
      race({"--jobs", "2", "--mice", bad("meet") + " here there", "--mice", bad("meet") + " there here", "--budget",
            "5", "--start-limit", "20", "--mazes", "corridor.txt", "--directory", ".", "--keep-folder"});
  for (const auto& mouse : json["groups"][0].at("mice")) EXPECT_EQ(mouse["results"][0]["outcome"], "out of steps");
}

TEST_F(AHostOfPrograms, AnInterruptEndsThemAndPrintsWhatIsDone) {
  const Program program(folder_, {"race", "--jobs", "1", "--mice", bad("hang"), "--mice", "flood", "--mazes",
                                  "corridor.txt", "--silence-limit", "60"});
  while (bad_programs() < 1) std::this_thread::yield();
  program.interrupt();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 130);
  EXPECT_THAT(ended.out, Says("Stopped", "1 of 2 contests"));
  EXPECT_THAT(ended.out, ContainsRegex("flood +1/1"));
  EXPECT_EQ(tagged_processes(), 0);
}

TEST_F(AHostOfPrograms, NothingOutlivesARaceThatIsKilled) {
  const Program program(folder_, {"race", "--mice", bad("hang"), "--mazes", "corridor.txt", "--silence-limit", "60"});
  while (bad_programs() < 1) std::this_thread::yield();
  program.kill();
  EXPECT_EQ(program.wait().code, -SIGKILL);
  while (tagged_processes() > 0) std::this_thread::yield();
}

}  // namespace
}  // namespace labmouse::test
