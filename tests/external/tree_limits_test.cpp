// Limits over an external mouse and all that it started.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/external/external_strategy.hpp"
#include "labmouse/external/mms/run.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/external/bad_programs.hpp"
#include "tests/external/mms_fixture.hpp"
#include "tests/external/sandboxes.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using namespace std::chrono_literals;

struct Excess {
  const char* how;
  ForfeitReason reason;
  std::vector<std::string> words;
};

void PrintTo(const Excess& excess, std::ostream* out) { *out << excess.how; }

/// Each of them with and without a sandbox.
class TreeLimits : public testing::TestWithParam<std::tuple<Excess, bool>> {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    if (std::get<1>(GetParam()) && !test::has_sandboxes()) GTEST_SKIP() << "no sandboxes here: " << why_no_sandbox();
  }
  ~TreeLimits() override { std::filesystem::remove_all(folder_); }

  Launch launch(const std::string& how) const {
    Launch launch = test::bad_program(how);
    launch.limits.decision = launch.limits.silence = 60s;
    launch.limits.contest = 120s;
    launch.limits.memory = std::uint64_t{1} << 28U;
    launch.limits.written = std::uint64_t{1} << 28U;
    launch.directory = folder_;
    launch.sandbox = std::get<1>(GetParam());
    return launch;
  }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("labmouse-tree-" + test::tag());
};

TEST_P(TreeLimits, EndItUnderItsName) {
  const Excess& excess = std::get<0>(GetParam());
  const Maze maze = test::drawn(R"(
      o---o---o
      | S   G |
      o---o---o
  )");
  const int descriptors = test::open_descriptors(), children = test::children();
  RunRecord record;
  {
    ExternalStrategy strategy(launch(excess.how), brief(maze, {}, 1));
    record = run(maze, {}, strategy);
  }
  EXPECT_EQ(name_of(record.steps.back().action.reason), name_of(excess.reason));
  EXPECT_THAT(record.last_words, test::HasParts(excess.words));
  EXPECT_EQ(test::tagged_processes(), 0);
  EXPECT_EQ(test::open_descriptors(), descriptors);
  EXPECT_EQ(test::children(), children);
}

INSTANTIATE_TEST_SUITE_P(
    All, TreeLimits,
    testing::Combine(
        testing::Values(Excess{"idlers", ForfeitReason::too_many_processes, {"64 processes", "--processes"}},
                        Excess{"bomb", ForfeitReason::too_many_processes, {"64 processes"}},
                        Excess{"bomb in sessions", ForfeitReason::too_many_processes, {"64 processes"}},
                        Excess{"big idlers", ForfeitReason::too_much_memory, {"256 MiB", "--memory"}},
                        Excess{"eat memory", ForfeitReason::too_much_memory, {"256 MiB"}},
                        Excess{"share memory", ForfeitReason::too_much_memory, {"256 MiB"}},
                        Excess{"write files", ForfeitReason::too_much_written, {"256 MiB", "--written"}}),
        testing::Bool()),
    [](const auto& test) {
      std::string name = std::get<0>(test.param).how;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name + (std::get<1>(test.param) ? "_in_a_sandbox" : "");
    });

TEST(TreeLimitsOfMms, HaveTheirOutcomeAndNoScore) {
  Launch launch;
  launch.words = {"/bin/sh", "-c", "while :; do sleep 1000 & done"};
  launch.limits.start = launch.limits.silence = 60s;
  const MmsRun run = run_mms(launch, test::field(), {});
  EXPECT_EQ(run.outcome, MmsOutcome::too_many_processes);
  EXPECT_TRUE(is_cut_short(run.outcome));
  EXPECT_THAT(run.end, Says("64 processes", "--processes"));
}

TEST(Survey, DividesMemoryInCommonOnlyWhereItIsAskedTo) {
  // Three children of a process share its pages: one by one they seem to hold three times as much.
  Launch launch;
  launch.words = {"python3", "-c",
                  "import os, sys\nheld = b'x' * (64 << 20)\nfor _ in range(3):\n    if os.fork() == 0: break\n"
                  "os.write(1, b'there\\n')\nsys.stdin.read()"};
  ExternalProcess process(launch);
  const auto deadline = ExternalProcess::Clock::now() + 60s;
  for (int lines = 0; lines < 4;) {
    ASSERT_EQ(process.wait(deadline), ExternalEvent::output);
    while (process.lines().next()) ++lines;
  }
  const Holdings apart = survey(getpid(), 64, false), shared = survey(getpid(), 64, true);
  EXPECT_GE(apart.processes, 5);  // the keeper, and four of them
  EXPECT_FALSE(apart.is_full);
  EXPECT_GT(apart.memory, std::uint64_t{4 * 64} << 20U);
  EXPECT_LT(shared.memory, std::uint64_t{3 * 64} << 20U);
  EXPECT_TRUE(survey(getpid(), 4, false).is_full);
}

}  // namespace
}  // namespace labmouse
