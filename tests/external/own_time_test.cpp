// Limits of time on a machine that is busy with other work.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/external/external_strategy.hpp"
#include "labmouse/external/mms/run.hpp"
#include "labmouse/external/patience.hpp"
#include "labmouse/external/sandbox.hpp"
#include "tests/busy_machine.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/external/bad_programs.hpp"
#include "tests/external/mms_fixture.hpp"

namespace labmouse {
namespace {

using namespace std::chrono_literals;

Maze corridor() {
  return test::drawn(R"(
      o---o---o
      | S   G |
      o---o---o
  )");
}

RunRecord contest(const Launch& launch) {
  Rules rules;
  rules.budget = 10;
  const Maze maze = corridor();
  ExternalStrategy strategy(launch, brief(maze, rules, 1));
  return run(maze, rules, strategy);
}

TEST(OwnTime, IsNoShorterOnABusyMachine) {
  // It works for 0.1 s before its first word, which takes about three times as long here.
  const test::BusyMachine busy;
  Launch launch = test::bad_program("work at the start");
  launch.limits.start = 160ms;
  launch.limits.contest = 300ms;
  for (const bool sandbox : {false, true}) {
    launch.sandbox = sandbox && why_no_sandbox().empty();
    EXPECT_EQ(contest(launch).outcome, Outcome::out_of_steps);
  }
}

TEST(OwnTime, PassesForThoseThatSleepOnABusyMachine) {
  const test::BusyMachine busy;
  Launch launch = test::bad_program("hang at the start");
  launch.limits.start = 60ms;
  EXPECT_EQ(contest(launch).steps.back().action.reason, ForfeitReason::hung);
  launch = test::bad_program("hang");
  launch.limits.start = launch.limits.silence = 20s;
  launch.limits.contest = 60ms;
  EXPECT_EQ(contest(launch).steps.back().action.reason, ForfeitReason::out_of_time);
}

TEST(OwnTime, CountsTheWorkOfAllThatItStarted) {
  Launch launch;
  launch.words = {"/bin/bash", "-c", "(while :; do :; done) & wait"};
  launch.limits.start = 60ms;
  EXPECT_EQ(contest(launch).steps.back().action.reason, ForfeitReason::hung);
  launch.words = {"/bin/bash", "-c", "for i in 1 2 3; do (for ((i = 0; i < 20000; ++i)); do :; done); done; read line"};
  launch.limits.start = 20s;
  ExternalProcess process(launch);
  const auto before = process.tree_time().worked;
  while (process.wait(ExternalProcess::Clock::now() + 20ms) == ExternalEvent::timeout &&
         process.tree_time().worked < 50ms) {
  }
  // Of those that have ended, too.
  EXPECT_GT(process.tree_time().worked, before);
}

TEST(OwnTime, DoesNotJudgeWhatOnlyTheClockSays) {
  Launch launch = test::bad_program("wait for a disk");
  launch.limits.start = 30ms;
  EXPECT_EQ(contest(launch).steps.back().action.reason, ForfeitReason::not_judged);
  const MmsRun run = run_mms(launch, test::field(), {});
  EXPECT_EQ(run.outcome, MmsOutcome::not_judged);
  EXPECT_FALSE(is_scored(run));
}

}  // namespace
}  // namespace labmouse
