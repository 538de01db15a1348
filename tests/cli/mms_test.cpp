// Programs for mms, hosted and raced as a user does.
#include <thread>

#include "tests/cli/user.hpp"

namespace labmouse::test {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// The command of a program that does what the words say; see tests/external/mms/mms_program.cpp.
std::string external(const std::vector<std::string>& words) {
  std::string command = "\"" LABMOUSE_MMS_PROGRAM "\"";
  for (const std::string& word : words) command += " \"" + word + "\"";
  return command;
}

class AnMmsUser : public AUser {
 protected:
  AnMmsUser() { file("plank.txt", "o---o---o---o\n|           |\no---o---o---o\n"); }

  Ended mms(const std::vector<std::string>& words, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"mms", external(words), "--maze", "plank.txt"});
    return labmouse(std::move(options));
  }
  /// The group of the JSON of a race in the plank.
  nlohmann::json group(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = {"--mazes", "plank.txt", "--mice"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return race(std::move(all)).at("groups").at(0);
  }

  const std::string to_the_goal_ = "mms:" + external({"ask:turnRight", "need:ack", "ask:moveForwardHalf", "need:ack"});
};

TEST_F(AnMmsUser, HostsAProgramInOneMaze) {
  const Ended ended = mms({"ask:mazeWidth", "need:3", "say:setText 1 0 hi", "ask:turnRight", "ask:moveForward"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, Says("complete", "exit code 0", "4 lines", "0.5 s"));
  EXPECT_THAT(ended.out, Says(" in plank.txt: score 2.3", "2 best run", "3 total / 10", "bound 1.2", "run 1\n"));
  EXPECT_THAT(ended.out, HasSubstr("|"));
  EXPECT_THAT(ended.out, Not(HasSubstr("\x1b")));
}

TEST_F(AnMmsUser, ExitCodesSayHowAProgramEnded) {
  EXPECT_EQ(mms({"exit:7"}).code, 1);
  EXPECT_THAT(mms({"errors:no way out", "exit:7"}).out, Says("  | no way out\n", "failed", "exit code 7"));
  EXPECT_EQ(mms({"hang"}, {"--start-limit", "0.06"}).code, 1);
  is_refused({"mms", "/no/such/mouse", "--maze", "plank.txt"}, "/no/such/mouse");
  is_refused({"mms", "", "--maze", "plank.txt"}, "command: ", "empty");
  is_refused({"mms", external({}), "--maze", "nowhere.txt"}, "nowhere.txt");
  is_refused({"mms", external({}), "--maze", "plank.txt", "--decision-limit", "-1"}, "--decision-limit");
  is_refused({"mms", external({}), "--maze", "plank.txt", "--record", "plank.txt/x"}, "plank.txt/x");
}

TEST_F(AnMmsUser, TellsOfLinesThatAreNoCommands) {
  const Ended ended = mms({"say:turnright", "say:what", "ask:turnRight"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, Says("2 lines", "line 1: 'turnright'", "line 2: 'what'"));
  const Ended strict = mms({"say:turnright", "hang"}, {"--strict"});
  EXPECT_EQ(strict.code, 1);
  EXPECT_THAT(strict.out, HasSubstr("invalid: line 1: 'turnright'"));
}

TEST_F(AnMmsUser, PressesResetForWhoWaits) {
  const std::vector<std::string> waiting = {"burst:100:wasReset", "hear:100", "ask:wasReset", "need:true",
                                            "ask:ackReset"};
  EXPECT_EQ(mms(waiting, {"--presses", "1"}).code, 0);
  EXPECT_THAT(mms(waiting).out, Says("waiting", "Reset", "--presses"));
}

TEST_F(AnMmsUser, RunsAProgramInItsFolder) {
  std::filesystem::create_directories(folder_ / "place");
  std::filesystem::copy_file(LABMOUSE_MMS_PROGRAM, folder_ / "place" / "mouse");
  EXPECT_EQ(labmouse({"mms", "./mouse ask:mazeWidth", "--maze", "plank.txt", "--directory", "place"}).code, 0);
  is_refused({"mms", "./mouse", "--maze", "plank.txt"}, "./mouse");
}

TEST_F(AnMmsUser, KeepsARecord) {
  EXPECT_EQ(mms({"ask:turnRight", "ask:moveForward"}, {"--record", "walk.jsonl"}).code, 0);
  const std::string record = content("walk.jsonl");
  EXPECT_EQ(std::count(record.begin(), record.end(), '\n'), 4);
  EXPECT_THAT(record, StartsWith("{\"labmouse\":\"mms record\""));
  EXPECT_THAT(record,
              HasSubstr("{\"line\":\"moveForward\",\"reply\":\"ack\",\"place\":[3,1],\"heading\":\"east\",\"clock\":"));
}

TEST_F(AnMmsUser, DrawsARecord) {
  const Ended hosted =
      mms({"say:setText 1 0 hi", "ask:turnRight", "ask:moveForward", "errors:all well"}, {"--record", "walk.jsonl"});
  const std::string drawing = hosted.out.substr(0, hosted.out.rfind("o---o") + 6);
  const std::string score = hosted.out.substr(hosted.out.rfind(": score"));
  const Ended replayed = labmouse({"replay", "walk.jsonl", "--svg", "replayed.svg"});
  EXPECT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_THAT(replayed.out, StartsWith(drawing));
  EXPECT_THAT(replayed.out, Says("  | all well\n", "complete", "3 lines", score));
  EXPECT_THAT(labmouse({"show", "--record", "walk.jsonl"}).out, StartsWith(drawing));
  EXPECT_THAT(labmouse({"score", "walk.jsonl"}).out, HasSubstr(score));
  EXPECT_EQ(labmouse({"show", "--record", "walk.jsonl", "--svg", "walk.svg"}).code, 0);
  EXPECT_THAT(content("walk.svg"), AllOf(StartsWith("<svg"), HasSubstr(">hi<")));
  EXPECT_EQ(content("walk.svg"), content("replayed.svg"));
  is_refused({"show", "--record", "walk.jsonl", "--step", "1"}, "--step");
  EXPECT_THAT(labmouse({"replay", "walk.jsonl", "--watch"}).out,
              AllOf(HasSubstr("moveForward -> ack"), EndsWith(score)));
}

TEST_F(AnMmsUser, DrawsNoRecordThatCouldNotHaveHappened) {
  mms({"ask:turnRight", "ask:moveForward"}, {"--record", "walk.jsonl"});
  std::string record = content("walk.jsonl");
  record.replace(record.find("[3,1]"), 5, "[5,1]");
  file("walk.jsonl", record);
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"replay", "walk.jsonl"}, {"score", "walk.jsonl"}, {"show", "--record", "walk.jsonl", "--svg", "x.svg"}}) {
    const Ended ended = labmouse(command);
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.out, "");
    EXPECT_THAT(ended.err, Says("walk.jsonl: error: ", "event 2"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.svg"));
  is_refused({"replay", file("bad.jsonl", record.substr(0, record.find('\n')) + "\n{}\n")}, "bad.jsonl:2");
}

TEST_F(AnMmsUser, WatchesEachMove) {
  const Ended ended = mms({"say:setText 1 0 hi", "ask:turnRight", "ask:moveForward"}, {"--watch"});
  EXPECT_THAT(ended.out, ContainsRegex("0\\.13 s  at \\(0,0\\) heading east  turnRight -> ack\n"));
  EXPECT_THAT(ended.out, ContainsRegex("0\\.53 s  at \\(1,0\\) heading east  moveForward -> ack\n"));
  // What was only drawn shows in the frame of the next move.
  EXPECT_THAT(ended.out, StartsWith("   o---o---o---o\n 0 |S>  Ghi    |\n"));
}

TEST_F(AnMmsUser, WatchesOnATerminalAtAnySpeed) {
  const auto printed = on_a_terminal({"mms", external({"say:setColor 1 0 G", "ask:turnRight", "ask:moveForward"}),
                                      "--maze", (folder_ / "plank.txt").string(), "--speed", "1000"},
                                     "NO_COLOR=");
  if (!printed) GTEST_SKIP() << "the system lends no terminals";
  EXPECT_THAT(*printed, HasSubstr("\x1b[H"));
  EXPECT_THAT(*printed, HasSubstr("48;5;28m"));
  EXPECT_THAT(*printed, HasSubstr("score 2.3"));
}

TEST_F(AnMmsUser, AnInterruptEndsTheProgram) {
  const Program program(folder_,
                        {"mms", external({"ask:turnRight", "hang"}), "--maze", "plank.txt", "--silence-limit", "60"});
  while (!program.handles_interrupts()) std::this_thread::yield();
  program.interrupt();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 130);
  EXPECT_THAT(ended.out, HasSubstr("interrupted"));
}

TEST_F(AnMmsUser, RacesInAWorldOfItsOwn) {
  const Ended ended = labmouse({"race", "--mice", to_the_goal_, "--mazes", "plank.txt"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, Says("world mms", "1 mouse", "1 maze"));
  EXPECT_THAT(ended.out, ContainsRegex(" 1/1 +1\\.2 "));
  EXPECT_THAT(ended.out, Not(HasSubstr("search steps")));
}

TEST_F(AnMmsUser, RacesBesideTheOthersInASecondTable) {
  is_refused({"race", "--mice", "flood", "--mice", to_the_goal_, "--mazes", "plank.txt"}, "'flood'", "steps", "mms",
             "--world each");
  const Ended ended =
      labmouse({"race", "--mice", "flood", "--mice", to_the_goal_, "--mazes", "plank.txt", "--world", "each"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_LT(ended.out.find("\nflood "), ended.out.find("world mms"));
}

TEST_F(AnMmsUser, GetsAllStatisticsAsJson) {
  const auto mms = group({to_the_goal_});
  EXPECT_EQ(mms.at("world"), "mms");
  EXPECT_EQ(mms.at("mice")[0].at("name"), to_the_goal_);
  const auto& result = mms.at("mice")[0].at("results")[0];
  EXPECT_EQ(result.at("outcome"), "complete");
  EXPECT_EQ(result.at("statistics").size(), 10U);
  EXPECT_NEAR(result.at("statistics").at("score").get<double>(), 1.2, 1e-9);
  EXPECT_EQ(result.at("best_run"), 1);
}

TEST_F(AnMmsUser, GivesAMazeOfTheRaceItsBound) {
  EXPECT_EQ(group({to_the_goal_}).at("mazes")[0].at("best_run"), 1);
  EXPECT_NEAR(group({to_the_goal_}).at("mazes")[0].at("best_score").get<double>(), 1.2, 1e-9);
}

TEST_F(AnMmsUser, GetsOneWorldAsCsv) {
  const Ended ended = labmouse({"race", "--mice", to_the_goal_, "--mazes", "plank.txt", "--format", "csv"});
  EXPECT_THAT(ended.out, StartsWith("mouse,maze,outcome,end,finished,"));
  is_refused(
      {"race", "--mice", "flood", "--mice", to_the_goal_, "--mazes", "plank.txt", "--world", "each", "--format", "csv"},
      "--format csv", "--format json");
}

TEST_F(AnMmsUser, IsToldWhatIsNotForMms) {
  is_refused({"race", "--mice", to_the_goal_, "--mazes", "plank.txt", "--goal", "2,0"}, "--goal");
  is_refused({"race", "--mice", "mms:", "--mazes", "plank.txt"}, "mms:");
  is_refused({"race", "--mice", "mms:/no/such/mouse", "--mazes", "plank.txt"}, "/no/such/mouse");
}

TEST_F(AnMmsUser, GetsTheRecordsOfARace) {
  EXPECT_EQ(labmouse({"race", "--mice", "flood", "--mice", to_the_goal_, "--mazes", "plank.txt", "--world", "each",
                      "--out", "out"})
                .code,
            0);
  int records = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "out"))
    if (entry.path().filename() == "plank.jsonl")
      records += content_of(entry.path()).starts_with("{\"labmouse\":\"mms record\"") ? 1 : 0;
  EXPECT_EQ(records, 1);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/flood/plank-1.jsonl"));
}

TEST_F(AnMmsUser, CanFailAboveAMean) {
  const std::vector<std::string> arguments = {"race", "--mice", to_the_goal_, "--mazes", "plank.txt", "--fail-above"};
  auto with = [&](const char* limit) {
    auto all = arguments;
    all.emplace_back(limit);
    return labmouse(all);
  };
  EXPECT_EQ(with("1.3").code, 0);
  const Ended above = with("1.1");
  EXPECT_EQ(above.code, 1);
  EXPECT_THAT(above.err, Says("1.200", "1.1"));
}

TEST_F(AnMmsUser, LimitsHoldInRacesToo) {
  const auto mms = group({"mms:" + external({"ask:mazeWidth", "hang"}), "--silence-limit", "0.06"});
  EXPECT_EQ(mms.at("mice")[0].at("results")[0].at("outcome"), "hung");
  const auto strict = group({"mms:" + external({"say:what", "hang"}), "--strict"});
  EXPECT_EQ(strict.at("mice")[0].at("results")[0].at("outcome"), "invalid");
}

TEST_F(AnMmsUser, RacesAndReplaysAProgramThatNeverEnds) {
  const std::string on =
      "mms:" + external({"ask:turnRight", "ask:moveForward", "ask-on:moveForward/turnRight/turnRight"});
  const std::vector<std::string> order = {"race", "--mazes", "plank.txt", "--simulated-limit", "100", "--mice", on};
  auto saving = order;
  saving.insert(saving.begin() + 1, {"--out", "out"});
  const Ended raced = labmouse(saving);
  EXPECT_EQ(raced.code, 0) << raced.err;
  EXPECT_THAT(raced.out, Says(" 1/1 ", " 2.3 ", "never ended 1", "6 commands", "(2,0) (1,0)"));
  const auto mouse = group({on, "--simulated-limit", "100"}).at("mice")[0];
  EXPECT_EQ(mouse.at("outcomes"), nlohmann::json({{"never ended", 1}}));
  const auto& result = mouse.at("results")[0];
  EXPECT_EQ(result.at("outcome"), "never ended");
  EXPECT_EQ(result.at("finished"), true);
  EXPECT_EQ(result.at("best_run"), 2);
  EXPECT_NEAR(result.at("score").get<double>(), 2.3, 1e-6);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "out"))
    if (entry.path().extension() == ".jsonl") {
      const Ended replayed = labmouse({"replay", entry.path().string()});
      EXPECT_EQ(replayed.code, 0) << replayed.err;
      EXPECT_THAT(replayed.out, Says("never ended", "6 commands", "score 2.3"));
      EXPECT_THAT(labmouse({"score", entry.path().string()}).out, Says("never ended", "score 2.3"));
    }
}

TEST_F(AnMmsUser, AnInterruptedRacePrintsWhatIsDone) {
  const Program program(folder_, {"race", "--mice", "mms:" + external({"ask:turnRight", "hang"}), "--mazes",
                                  "plank.txt", "--silence-limit", "60"});
  while (!program.handles_interrupts()) std::this_thread::yield();
  program.interrupt();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 130);
  EXPECT_THAT(ended.out, Says("Stopped", "0 of 1 contests"));
}

}  // namespace
}  // namespace labmouse::test
