// `labmouse tune` from end to end.
#include <chrono>
#include <thread>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using test::AUser;
using test::corridor;
using test::Ended;
using test::Says;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST_F(AUser, TunesAMouse) {
  const Ended ended = labmouse({"tune", "visit-counter:search=dijkstra", "--params", "random_share,coverage=0.2:0.9",
                                "--mazes", "island-8", "spiral-9", "capstone-1", "--runs", "2", "--evaluations", "15",
                                "--population", "6", "--log", "out/log.csv", "--svg", "out/plot.svg"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_THAT(ended.out, HasSubstr("as given   "));
  const std::string log = content("out/log.csv");
  EXPECT_THAT(log, StartsWith("evaluation,generation,step,score,failures,random_share,coverage,mouse\n1,0,0,"));
  EXPECT_EQ(lines(log), 1 + 15);
  EXPECT_THAT(content("out/plot.svg"), HasSubstr("<svg"));
  // The last line is a SPEC that races as it was evaluated.
  const std::string spec = ended.out.substr(ended.out.rfind('\n', ended.out.size() - 2) + 1);
  EXPECT_THAT(log, HasSubstr("," + spec));
  EXPECT_THAT(spec, HasSubstr("search=dijkstra"));
}

TEST_F(AUser, TunesToTheSameForAnyNumberOfJobs) {
  file("corridor.txt", corridor);
  const auto log = [&](const char* jobs, const char* seed) {
    EXPECT_EQ(labmouse({"tune", "cautious", "--params", "explore_frac", "--mazes", "corridor.txt", "island-8", "--runs",
                        "3", "--evaluations", "12", "--jobs", jobs, "--seed", seed, "--log", "log.csv"})
                  .code,
              0);
    return content("log.csv");
  };
  const std::string alone = log("1", "1");
  EXPECT_EQ(log("4", "1"), alone);
  EXPECT_NE(log("4", "2"), alone);
}

TEST_F(AUser, IsToldWhatIsWrongWithTuning) {
  file("corridor.txt", corridor);
  file("closed.txt", "o---o---o\n| S | G |\no---o---o\n");
  const auto refused = [&](const char* mouse, const char* parameters, auto... parts) {
    is_refused({"tune", mouse, "--params", parameters, "--evaluations", "5", "--mazes", "corridor.txt"}, parts...);
  };
  refused("flod", "stride", "'flod'", "'flood'");
  refused("flood", "strid", "'strid'", "'stride'");
  refused("two-way", "join_legs", "'join_legs'", "'two-way'", "numbers", "bias");
  refused("two-way", "bias=3", "'3'", "LOW:HIGH");
  refused("two-way", "bias=3:300", "'300'", "'bias'", "0 to 100");
  is_refused({"tune", "flood", "--params", "stride"}, "'--evaluations'", "missing");
  is_refused({"tune", "flood", "--evaluations", "5"}, "'--params'", "missing");
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "0"}, "--evaluations");
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "5", "--population", "3"}, "--population");
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "5", "--sigma", "0"}, "--sigma");
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "5", "--sigma", "nan"}, "--sigma");
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "5", "--objective", "time"}, "--objective");
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "5", "--log", "a", "--svg", "a"}, "--log",
             "--svg");
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "5", "--mazes", "closed.txt"}, "goal", "to tune");
  is_refused({"run", "ariadne:cell_most=1", "capstone-1"}, "'cell_most'", "no effect in steps");
  is_refused({"tune", "ariadne", "--params", "travel", "--evaluations", "5", "--world", "seconds"}, "'travel'",
             "no effect in seconds");
}

TEST_F(AUser, IsToldAtOnceThatALogCannotBeWritten) {
  file("corridor.txt", corridor);
  is_refused({"tune", "flood", "--params", "stride", "--evaluations", "1000000", "--mazes", "corridor.txt", "--log",
              "corridor.txt/log.csv"},
             "corridor.txt/log.csv: error: ", "not a folder");
}

TEST_F(AUser, WhoInterruptsATuningKeepsItsLog) {
  file("corridor.txt", corridor);
  const test::Program program(folder_, {"tune", "random", "--params", "stride", "--evaluations", "1000000", "--mazes",
                                        "corridor.txt", "--runs", "1", "--log", "log.csv"});
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (lines(content("log.csv")) < 10 && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
  program.interrupt();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 130) << ended.err;
  const std::string count = std::to_string(lines(content("log.csv")) - 1);
  EXPECT_THAT(ended.out, Says("Stopped", count + " of 1000000 evaluations"));
  EXPECT_THAT(ended.out, HasSubstr("\n\nrandom"));
}

}  // namespace
}  // namespace labmouse
