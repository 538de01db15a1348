// What ends the program early.
#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using test::corridor;
using test::Ended;
using test::patiently;
using test::Program;

class AnImpatientUser : public test::AUser, public testing::WithParamInterface<int> {
 protected:
  bool has_files(const std::string& folder) const {
    std::error_code none;
    return std::filesystem::exists(folder_ / folder, none) && !std::filesystem::is_empty(folder_ / folder, none);
  }
};

TEST_P(AnImpatientUser, KeepsTheResultsOfARace) {
  file("corridor.txt", corridor);
  // Far more contests than a minute holds; the first record shows that the race is under way.
  const Program program(folder_, {"race", "--mazes", "corridor.txt", "--mice", "random", "--runs", "500000", "--jobs",
                                  "1", "--format", "json", "--out", "out"});
  ASSERT_TRUE(patiently([&] { return has_files("out/random"); }));
  program.signal(GetParam());
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 128 + GetParam());
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded()) << ended.err;
  EXPECT_EQ(json.at("stopped"), true);
  EXPECT_EQ(nlohmann::json::parse(content("out/results.json"), nullptr, false), json);
  const std::size_t done = json.at("groups").at(0).at("mice").at(0).at("results").size();
  std::size_t records = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out" / "random"))
    records += entry.path().extension() == ".jsonl" ? 1 : 0;
  EXPECT_EQ(records, done);
}

TEST_P(AnImpatientUser, StopsASearch) {
  file("corridor.txt", corridor);
  const Program program(folder_, {"sweep", "random", "--vary", "stride=1:8:1", "--mazes", "corridor.txt", "--runs",
                                  "500000", "--jobs", "1"});
  ASSERT_TRUE(patiently([&] { return program.handles_interrupts(); }));
  program.signal(GetParam());
  EXPECT_EQ(program.wait().code, 128 + GetParam());
}

TEST_P(AnImpatientUser, KeepsWhatFailureRatesCounted) {
  const Program program(folder_, {"failure-rates", "--mice", "flood-return", "--mazes", "contest-01", "--runs",
                                  "500000", "--jobs", "1", "--format", "json", "--save", "mine.json"});
  ASSERT_TRUE(patiently([&] { return program.handles_interrupts(); }));
  program.signal(GetParam());
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 128 + GetParam());
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded()) << ended.err;
  EXPECT_EQ(json.at("stopped"), true);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "mine.json"));
}

TEST_P(AnImpatientUser, KeepsTheDrivesThatAreDone) {
  const Program program(folder_,
                        {"drive", "--mazes", "contest-01", "--runs", "500000", "--jobs", "1", "--format", "json"});
  ASSERT_TRUE(patiently([&] { return program.handles_interrupts(); }));
  program.signal(GetParam());
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 128 + GetParam());
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_FALSE(json.is_discarded()) << ended.err;
  EXPECT_EQ(json.at("stopped"), true);
  EXPECT_LT(json.at("drives").at(0).at("runs"), 500000);
}

TEST_P(AnImpatientUser, EndsARaceThatHangs) {
  // Nobody ever writes the earlier results.
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  const Program program(folder_, {"race", "--mice", "flood", "--baseline", "pipe"});
  ASSERT_TRUE(patiently([&] { return program.handles_interrupts(); }));
  EXPECT_TRUE(patiently([&] {
    program.signal(GetParam());
    return !program.runs();
  }));
  program.kill();
  EXPECT_EQ(program.wait().code, -GetParam());
}

/// Nobody ever reads the record.
TEST_P(AnImpatientUser, EndsARunWhoseContestIsOver) {
  file("corridor.txt", corridor);
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  const Program program(folder_, {"run", "flood", "corridor.txt", "--record", "pipe"});
  EXPECT_TRUE(patiently([&] { return program.sleeps() && !program.handles_interrupts(); }));
  program.signal(GetParam());
  EXPECT_TRUE(patiently([&] { return !program.runs(); }));
  program.kill();
  EXPECT_EQ(program.wait().code, -GetParam());
}

INSTANTIATE_TEST_SUITE_P(Signals, AnImpatientUser, testing::Values(SIGINT, SIGTERM, SIGHUP));

class AUserOfASweep : public test::AUser {};

/// The first value fails at once; the second one hangs, and shows that the first is done.
TEST_F(AUserOfASweep, FindsWhatAStoppedOneHasBesideItsFile) {
  file("corridor.txt", corridor);
  file("mouse.sh", "[ \"$1\" = 1 ] && exit 1\ntouch second\nexec tail -f /dev/null\n");
  file("values.csv", "value,mean,low,high,kept");
  const Program program(folder_, {"sweep", "program:sh mouse.sh {v}", "--vary", "v=1,2", "--mazes", "corridor.txt",
                                  "--sandbox", "off", "--jobs", "1", "--csv", "values.csv"});
  ASSERT_TRUE(patiently([&] { return std::filesystem::exists(folder_ / "second"); }));
  program.interrupt();
  EXPECT_EQ(program.wait().code, 128 + SIGINT);
  EXPECT_EQ(content("values.csv"), "value,mean,low,high,kept");
  const std::string partial = content("values.csv.partial");
  EXPECT_EQ(std::count(partial.begin(), partial.end(), '\n'), 2) << partial;
}

class AUserOfNohup : public test::AUser {};

TEST_F(AUserOfNohup, GetsNoHangup) {
  file("corridor.txt", corridor);
  const auto before = std::signal(SIGHUP, SIG_IGN);  // as nohup does, for its child
  const Program program(folder_, {"sweep", "random", "--vary", "stride=1:8:1", "--mazes", "corridor.txt", "--runs",
                                  "500000", "--jobs", "1"});
  std::signal(SIGHUP, before);
  ASSERT_TRUE(patiently([&] { return program.handles_interrupts(); }));
  program.signal(SIGHUP);
  program.signal(SIGTERM);
  EXPECT_EQ(program.wait().code, 128 + SIGTERM);
}

}  // namespace
}  // namespace labmouse
