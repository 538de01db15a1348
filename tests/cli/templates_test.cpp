// The templates of external mice: each solves every built-in maze, and stays short. Those of controllers finish
// contests.
#include <map>
#include <sstream>

#include "tests/cli/user.hpp"
#include "tests/interpreters.hpp"
#include "tests/slowness.hpp"

namespace labmouse::test {
namespace {

std::string path_of(const std::string& name) { return LABMOUSE_SOURCE_DIR "/templates/" + name; }

/// The command that runs a template; empty where what runs it is not here.
std::string command_of(const std::string& name) {
  if (name == "program.cpp") return "\"" LABMOUSE_PROGRAM_TEMPLATE "\"";
  const std::string& interpreter = name == "program.py" ? python3() : node();
  return interpreter.empty() ? "" : interpreter + " \"" + path_of(name) + "\"";
}

constexpr const char* small_ring =
    "o---o---o---o\n|           |\no   o---o   o\n|   |   | G |\no   o---o   o\n| S |       |\no---o---o---o\n";

class ATemplate : public AUser, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    if (command_.empty()) GTEST_SKIP() << "nothing that runs " << GetParam() << " is in PATH";
  }
  /// The steps of a contest as its record has them, and its end.
  std::string walk_of(const std::string& command, std::vector<std::string> where) const {
    where.insert(where.begin(), {"run", "program:" + command});
    where.insert(where.end(), {"--record", "walk.jsonl"});
    EXPECT_EQ(labmouse(where).code, 0);
    const std::string record = content("walk.jsonl");
    return record.substr(record.find('\n') + 1);
  }

  std::string command_ = command_of(GetParam());
};

TEST_P(ATemplate, SolvesAllBuiltinMazes) {
  std::vector<std::string> words = {"--mice", "program:" + command_};
  const std::vector<std::string> some = {"--mazes", "capstone-1", "contest-01", "island-8", "spiral-9"};
  if (!test::thorough) words.insert(words.end(), some.begin(), some.end());
  const auto race = AUser::race(words);
  const std::size_t mazes = test::thorough ? 43 : some.size() - 1;
  EXPECT_EQ(race.at("groups").at(0).at("mazes").size(), mazes);
  EXPECT_EQ(race.at("groups").at(0).at("mice").at(0).at("runs"), mazes);
  EXPECT_EQ(race.at("groups").at(0).at("mice").at(0).at("finished"), mazes)
      << race.at("groups").at(0).at("mice").at(0).at("results");
}

TEST_P(ATemplate, DoesWhatTheOthersDo) {
  for (const char* maze : {"capstone-1", "contest-05", "island-8"})
    EXPECT_EQ(walk_of(command_, {maze}), walk_of(command_of("program.cpp"), {maze})) << maze;
}

TEST_P(ATemplate, LooksBehindItselfAndBacks) {
  file("corridor.txt", corridor);
  const std::string walk = walk_of(command_, {"corridor.txt", "--start", "1,0,west", "--goal", "2,0"});
  EXPECT_THAT(walk, testing::HasSubstr(R"("action":[90,0])"));
  EXPECT_THAT(walk, testing::HasSubstr(R"("action":[0,-1])"));
  EXPECT_THAT(walk, testing::HasSubstr(R"("outcome":"finished")"));
}

TEST_P(ATemplate, EntersAGoalOnWhichItStands) {
  file("corridor.txt", corridor);
  const std::string walk = walk_of(command_, {"corridor.txt", "--goal", "0,0"});
  EXPECT_THAT(walk, testing::HasSubstr(R"("outcome":"finished")"));
  EXPECT_THAT(walk, testing::HasSubstr(R"("search_steps":2,"speed_steps":1)"));
}

TEST_P(ATemplate, SkipsWhatItDoesNotKnowInTheBriefing) {
  file("host.txt",
       "labmouse 1\nsize 6 1\nnews start 3 0 sense goal 1 1\nstart 0 0 east\ngoal 5 0\nstride 3\nbegin\nsense 0 5 0\n"
       "sense 0 4 0\nsense 0 3 0\nsense 0 2 0\nsense 0 1 0\nsense 0 0 0\nsense 0 5 0\nsense 0 2 0\n");
  const std::string run = "cd '" + folder_.string() + "' && " + command_ + " <host.txt >said.txt";
  EXPECT_EQ(std::system(run.c_str()), 0);
  EXPECT_EQ(content("said.txt"),
            "labmouse 1\nmove 0 1\nmove 0 1\nmove 0 1\nmove 0 1\nmove 0 1\nreset\nmove 0 3\nmove 0 2\n");
}

TEST(Templates, AreShort) {
  std::map<std::string, int> templates;
  for (const auto& file : std::filesystem::directory_iterator(path_of(""))) {
    if (!file.is_regular_file() || file.path().filename().string().starts_with(".")) continue;
    SCOPED_TRACE(file.path());
    const std::string kind = file.path().stem().string();
    ++templates[kind];
    std::istringstream text(content_of(file.path()));
    int lines = 0;
    for (std::string line; std::getline(text, line); ++lines) EXPECT_LE(line.size(), 120U) << line;
    EXPECT_LT(lines, kind == "program" ? 30 : 300);
  }
  EXPECT_EQ(templates,
            (std::map<std::string, int>{{"controller", 2}, {"estimator", 1}, {"labmouse_stream", 1}, {"program", 3}}));
}

class AnEstimatorTemplate : public AUser {
 protected:
  void SetUp() override {
    if (python3().empty()) GTEST_SKIP() << "no Python 3 is in PATH";
    file("ring.txt", small_ring);
  }

  std::string spec_ = "flood-return:parts=" + python3() + " \"" + path_of("estimator.py") + "\"";
};

TEST_F(AnEstimatorTemplate, FinishesAContestWithoutNoise) {
  const auto race = AUser::race(
      {"--mice", "mine=" + spec_, "--mazes", "ring.txt", "--world", "physical", "--noise", "0", "--runs", "1"});
  const auto& mouse = race.at("groups").at(0).at("mice").at(0);
  EXPECT_EQ(mouse.at("finished"), 1) << mouse;
}

TEST_F(AnEstimatorTemplate, IsShownAndNotReplayed) {
  const std::vector<std::string> run = {"run", spec_, "ring.txt", "--world", "physical", "--noise", "0"};
  auto with = [&](std::initializer_list<std::string> more) {
    std::vector<std::string> words = run;
    words.insert(words.end(), more);
    return words;
  };
  const Ended ended = labmouse(with({"--record", "run.jsonl", "--svg", "run.svg"}));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, testing::HasSubstr("gate to gate in run 3"));
  EXPECT_THAT(content("run.svg"), testing::HasSubstr("<svg"));
  const Ended again = labmouse({"replay", "run.jsonl"});
  EXPECT_EQ(again.code, 1);
  EXPECT_THAT(again.err, Says("not", "driven", "again"));
  is_refused(with({"--log", "run.csv"}), "--log", "program");
  is_refused({"run", spec_, "ring.txt"}, "'parts'", "--world physical");
}

TEST_F(AnEstimatorTemplate, IsTriedOutAsOneOfAMiceFile) {
  file("mice.toml", "[[mouse]]\nname = \"mine\"\nmouse = 'flood-return:parts=" + python3() + "'\narguments = ['" +
                        path_of("estimator.py") + "']\n");
  const Ended checked = labmouse({"mice-file", "check", "mice.toml"});
  EXPECT_EQ(checked.code, 0) << checked.out << checked.err;
  EXPECT_THAT(checked.out, testing::ContainsRegex("mine +mouse +(plays|finished)"));
  EXPECT_THAT(checked.out, testing::Not(testing::HasSubstr("differs")));
}

TEST_F(AnEstimatorTemplate, SaysWhyAnotherProgramFails) {
  const Ended ended = labmouse({"run", "flood:parts=sh -c \"exit 4\"", "ring.txt", "--world", "physical"});
  EXPECT_THAT(ended.out, testing::HasSubstr("it ended with exit code 4 before it wrote 'labmouse pilot 1 PART...'"));
}

class AControllerTemplate : public AUser, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    if (python3().empty()) GTEST_SKIP() << "no Python 3 is in PATH";
    file("ring.txt", small_ring);
  }

  std::string spec_ = std::string("controller:") + GetParam();
};

TEST_P(AControllerTemplate, FinishesContests) {
  const auto race = AUser::race({"--mice", spec_, "--mazes", "ring.txt", "--runs", "4"});
  const auto& group = race.at("groups").at(0);
  EXPECT_EQ(group.at("world"), "physical");
  for (const auto& result : group.at("mice").at(0).at("results")) {
    EXPECT_TRUE(result.at("score").is_object()) << result;
    // A search, and speed runs by what it has seen.
    EXPECT_GE(result.at("done").get<int>(), 2) << result;
  }
}

TEST_P(AControllerTemplate, LeavesRecordsThatReplay) {
  ASSERT_EQ(labmouse({"race", "--mice", "mine=" + spec_, "--mazes", "ring.txt", "--runs", "1", "--out", "out"}).code,
            0);
  int records = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "out"))
    if (entry.path().extension() == ".jsonl") {
      ++records;
      EXPECT_EQ(labmouse({"replay", entry.path().string()}).code, 0);
    }
  EXPECT_EQ(records, 1);
}

TEST_P(AControllerTemplate, LeavesALogOfEachMillisecond) {
  ASSERT_EQ(labmouse({"run", spec_, "ring.txt", "--world", "physical", "--record", "a.jsonl", "--log", "a.csv"}).code,
            0);
  ASSERT_EQ(labmouse({"replay", "a.jsonl", "--log", "b.csv"}).code, 0);
  const std::string log = content_of(folder_ / "a.csv");
  EXPECT_THAT(log, testing::StartsWith("time,left,right,left_count"));
  EXPECT_GT(std::count(log.begin(), log.end(), '\n'), 1000);
  EXPECT_EQ(log, content_of(folder_ / "b.csv"));
}

TEST_P(AControllerTemplate, IsFoundAndTriedOutAsOneOfAMiceFile) {
  std::filesystem::create_directories(folder_ / "class");
  const bool script = spec_.find(".py") != std::string::npos;
  const std::string program = script ? path_of("controller.py") : LABMOUSE_CONTROLLER_TEMPLATE;
  std::filesystem::copy(program, folder_ / "class" / (script ? "mine.py" : "mine"));
  ASSERT_EQ(labmouse({"mice-file", "init", "class"}).code, 0);
  EXPECT_THAT(content_of(folder_ / "class" / "mice.toml"), testing::HasSubstr("\ncontroller = \"./mine"));
  const Ended checked = labmouse({"mice-file", "check", "class/mice.toml"});
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_THAT(checked.out, testing::ContainsRegex("mine +controller +(Python [0-9.]+ +)?finished"));
  EXPECT_THAT(checked.out, testing::Not(testing::HasSubstr("differs")));
}

INSTANTIATE_TEST_SUITE_P(In, AControllerTemplate,
                         testing::Values("\"" LABMOUSE_CONTROLLER_TEMPLATE "\"",
                                         "python3 \"" LABMOUSE_SOURCE_DIR "/templates/controller.py\""),
                         [](const auto& name) { return name.index == 0 ? "c" : "py"; });

INSTANTIATE_TEST_SUITE_P(In, ATemplate, testing::Values("program.cpp", "program.py", "program.js"),
                         [](const auto& name) {
                           return std::string(name.param).substr(std::string_view("program.").size());
                         });

}  // namespace
}  // namespace labmouse::test
