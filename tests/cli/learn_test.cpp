// `labmouse learn` from end to end, and mice with what it learned.
#include <chrono>
#include <thread>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using test::AUser;
using test::corridor;
using test::Ended;
using test::Says;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

TEST_F(AUser, LearnsAPriorAndRacesWithIt) {
  const Ended learned = labmouse({"learn", "contest-01", "contest-02", "-o", "out/my.prior"});
  EXPECT_EQ(learned.code, 0) << learned.err;
  EXPECT_EQ(learned.err, "");
  EXPECT_THAT(learned.out, MatchesRegex("2 mazes, [0-9]+ walls[^\n]* 0[.][0-9]+[^\n]* 0[.][0-9]+[^\n]*\n"));
  EXPECT_THAT(content("out/my.prior"), StartsWith("// labmouse prior 1\n// Learned by labmouse "));
  const nlohmann::json json = race({"--mice", "ariadne,ariadne:prior=out/my.prior", "--mazes", "contest-03"});
  EXPECT_EQ(json.at("groups").at(0).at("mice").size(), 2U);
  const Ended swept =
      labmouse({"sweep", "ariadne", "--vary", "prior=contest,uniform,out/my.prior", "--mazes", "contest-03"});
  EXPECT_EQ(swept.code, 0) << swept.err;
  EXPECT_THAT(swept.out, HasSubstr("out/my.prior"));
}

TEST_F(AUser, LearnsTheSameFromTheSameMazes) {
  ASSERT_EQ(labmouse({"learn", "contest-01", "spiral-9", "-o", "one.prior"}).code, 0);
  ASSERT_EQ(labmouse({"learn", "spiral-9", "contest-01", "spiral-9", "-o", "two.prior"}).code, 0);
  EXPECT_EQ(content("one.prior"), content("two.prior"));
  EXPECT_THAT(content("one.prior"), Not(HasSubstr("spiral")));
}

TEST_F(AUser, TunesRunsAndKeepsRecordsOfAMouseThatLearned) {
  ASSERT_EQ(labmouse({"learn", "contest-01", "-o", "my.prior"}).code, 0);
  EXPECT_EQ(
      labmouse({"tune", "ariadne:prior=my.prior", "--params", "travel", "--evaluations", "5", "--mazes", "spiral-9"})
          .code,
      0);
  EXPECT_EQ(labmouse({"bound", "spiral-9", "--hindsight", "ariadne:prior=my.prior"}).code, 0);
  EXPECT_EQ(labmouse({"run", "ariadne:prior=my.prior", "spiral-9", "--record", "walk.jsonl"}).code, 0);
  EXPECT_THAT(content("walk.jsonl"), HasSubstr("my.prior"));
  std::filesystem::remove(folder_ / "my.prior");
  EXPECT_EQ(labmouse({"replay", "walk.jsonl"}).code, 0);
}

TEST_F(AUser, StudiesAMouseThatLearns) {
  const Ended ended = labmouse({"study", "--mice", "ariadne,flood-return", "--folds", "2", "--mazes", "contest-01",
                                "contest-02", "spiral-9", "island-8"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, Says("Taught", "2 mazes", ": ariadne.\n"));
}

TEST_F(AUser, SeesThatAPriorMayBeAFile) {
  EXPECT_THAT(labmouse({"mice"}).out, Says("    prior=contest  prior, contest/uniform ", "`labmouse learn`"));
  const auto mice = nlohmann::json::parse(labmouse({"mice", "--format", "json"}).out);
  for (const auto& mouse : mice)
    if (mouse["name"] == "ariadne") {
      EXPECT_EQ(mouse["parameters"][0]["type"], "prior");
      EXPECT_EQ(mouse["parameters"][0]["choices"], (nlohmann::json{"contest", "uniform"}));
    }
}

TEST_F(AUser, IsToldWhatIsWrongWithLearning) {
  file("closed.txt", "o---o---o\n| S | G |\no---o---o\n");
  file("occupied", "a file where a folder should be");
  is_refused({"learn", "contest-01"}, "'--out'", "missing");
  is_refused({"learn", "contest-00", "-o", "my.prior"}, "contest-00", "'contest-01'");
  is_refused({"learn", "closed.txt", "-o", "my.prior"}, "route", "1 given");
  is_refused({"learn", "contest-01", "-o", "occupied/my.prior"}, "occupied/my.prior: error: ", "not a folder");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "my.prior"));
  std::filesystem::create_directories(folder_ / "empty");
  is_refused({"learn", "empty", "-o", "my.prior"}, "no maze", "built-in");
}

TEST_F(AUser, IsToldWhatIsWrongWithAPrior) {
  file("bad.prior", "// labmouse prior 1\n1,2,\n3,1000,\n");
  is_refused({"race", "--mice", "ariadne:prior=bad.prior"}, "bad.prior:3:3: ", "0 to 255", "'1000'");
  is_refused({"race", "--mice", "ariadne:prior=my.prior"}, "my.prior: ", "no such", "':' and ','");
  is_refused({"race", "--mice", "ariadne:prior=contes"}, "contes: ", "'contest'");
  is_refused({"run", "ariadne:prior=", "spiral-9"}, "'prior'", "'ariadne'", "contest/uniform");
  is_refused({"sweep", "ariadne", "--vary", "prior=contest,my.prior"}, "my.prior: ", "no such");
  is_refused({"tune", "ariadne", "--params", "prior", "--evaluations", "5"}, "'prior'", "'ariadne'", "numbers");
}

TEST_F(AUser, IsToldWhatLearningLeavesOut) {
  file("closed.txt", "o---o---o\n| S | G |\no---o---o\n");
  file("corridor.txt", corridor);
  file("same.txt", corridor);
  const Ended ended = labmouse({"learn", "corridor.txt", "same.txt", "closed.txt", "-o", "my.prior"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, StartsWith("1 maze, "));
  EXPECT_THAT(ended.out, HasSubstr("\n  same.txt = corridor.txt\n"));
  EXPECT_THAT(ended.out, HasSubstr("\n  closed.txt\n"));
}

TEST_F(AUser, WhoInterruptsLearningKeepsAnEarlierPrior) {
  file("my.prior", "// labmouse prior kept");
  std::filesystem::create_directories(folder_ / "mazes");
  // More to explore than a short while holds, and different.
  ASSERT_EQ(labmouse({"make", "prim", "--size", "64x64", "-o", "large.txt"}).code, 0);
  std::string maze = content("large.txt");
  const std::size_t row = maze.find('\n') + 1;
  for (int number = 0; number < 300; ++number) {
    const std::size_t side =
        2 * row * static_cast<std::size_t>(1 + number / 40) + row + 4 * static_cast<std::size_t>(1 + number % 40);
    maze[side] = maze[side] == ' ' ? '|' : ' ';
    file("mazes/" + std::to_string(number) + ".txt", maze);
  }
  const test::Program program(folder_, {"learn", "mazes", "-o", "my.prior"});
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!program.handles_interrupts() && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
  program.interrupt();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 130) << ended.err << ended.out;
  EXPECT_THAT(ended.out, Says("Stopped", "no prior"));
  EXPECT_EQ(content("my.prior"), "// labmouse prior kept");
}

}  // namespace
}  // namespace labmouse
