#include "labmouse/external/process.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "tests/external/bad_programs.hpp"

namespace labmouse {
namespace {

using namespace std::chrono_literals;

/// Waits until there is no more output; returns what ended it.
ExternalEvent exhaust(ExternalProcess& process, int& lines) {
  const auto deadline = ExternalProcess::Clock::now() + 20s;
  for (;;) {
    const ExternalEvent event = process.wait(deadline);
    while (process.lines().next()) ++lines;
    if (event != ExternalEvent::output) return event;
  }
}

Launch launch_of(std::vector<std::string> words) {
  Launch launch;
  launch.words = std::move(words);
  return launch;
}

TEST(ExternalProcess, HandsOutAllThatAProgramSaidBeforeItEnded) {
  // More than pipes and single reads hold.
  ExternalProcess process(launch_of({"/bin/sh", "-c", "seq 1 100000; exit 7"}));
  int lines = 0;
  EXPECT_EQ(exhaust(process, lines), ExternalEvent::ended);
  EXPECT_EQ(lines, 100'000);
  EXPECT_EQ(process.status(), (ExitStatus{7, 0}));
}

TEST(ExternalProcess, HasLeftNothingBehindWhereAnotherHoldsItsOutput) {
  // As the keeper of another mouse does for a moment, if it is forked while the pipes of this one are opened.
  ExternalProcess process(launch_of({"/bin/sh", "-c", "echo $$; read line"}));
  ASSERT_EQ(process.wait(ExternalProcess::Clock::now() + 20s), ExternalEvent::output);
  const std::string output = "/proc/" + std::string(process.lines().next().value_or("")) + "/fd/1";
  const int held = open(output.c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_GE(held, 0);
  process.send("end\n");
  while (!process.status()) ASSERT_EQ(process.wait(ExternalProcess::Clock::now() + 1ms), ExternalEvent::timeout);
  EXPECT_EQ(process.wait(ExternalProcess::Clock::now() + 1ms), ExternalEvent::timeout);
  close(held);
  EXPECT_EQ(process.wait(ExternalProcess::Clock::now() + 20s), ExternalEvent::ended);
}

TEST(ExternalProcess, TakesMoreThanAPipeHolds) {
  ExternalProcess process(launch_of({"/bin/sh", "-c", "read first; wc -l >&2; echo done"}));
  std::string lines;
  for (int i = 0; i < 100'001; ++i) lines += "a line\n";
  process.send(lines);
  const auto deadline = ExternalProcess::Clock::now() + 20s;
  while (process.unsent() > 0) ASSERT_EQ(process.wait(deadline), ExternalEvent::output);
  process.end(20s);
  EXPECT_EQ(process.status(), ExitStatus());
  EXPECT_EQ(process.errors(), "100000\n");
}

TEST(ExternalProcess, LetsAProgramEndByItselfWhereThatIsAskedFor) {
  ExternalProcess patient(launch_of({"/bin/sh", "-c", "read line; echo noted >&2"}));
  patient.end(20s);
  EXPECT_EQ(patient.errors(), "noted\n");
  EXPECT_EQ(patient.status(), ExitStatus());
}

TEST(ExternalProcess, TellsAProgramNothingThatItEndsAtOnce) {
  ExternalProcess process(launch_of({"/bin/sh", "-c", "echo ready; read line; echo noted >&2"}));
  EXPECT_EQ(process.wait(ExternalProcess::Clock::now() + 20s), ExternalEvent::output);
  process.end(0ms);
  EXPECT_EQ(process.errors(), "");
  EXPECT_EQ(process.status(), (ExitStatus{0, SIGKILL}));
}

TEST(ExternalProcess, GivesAProgramTheSignalsOfAFreshStart) {
  // The tests' own program ignores broken pipes by now. Of the signals that cannot be set it may have inherited some.
  ExternalProcess process(launch_of({"/bin/sh", "-c", "sed -n 's/^Sig\\(Blk\\|Ign\\):.//p' /proc/self/status; echo"}));
  int lines = 0;
  EXPECT_EQ(process.wait(ExternalProcess::Clock::now() + 20s), ExternalEvent::output);
  const std::string masks(process.lines().rest());
  EXPECT_EQ(exhaust(process, lines), ExternalEvent::ended);
  const auto blocked = std::stoull(masks, nullptr, 16),
             ignored = std::stoull(masks.substr(masks.find('\n')), nullptr, 16);
  EXPECT_EQ(blocked, 0U);
  EXPECT_EQ(ignored >> (SIGPIPE - 1U) & 1U, 0U);
  EXPECT_EQ(ignored >> (SIGINT - 1U) & 1U, 0U);
}

TEST(ExternalProcess, StandsInAGroupAndASessionOfItsOwn) {
  ExternalProcess process(launch_of({"/bin/sh", "-c", "cut -d' ' -f5,6 /proc/$$/stat; echo $$"}));
  EXPECT_EQ(process.wait(ExternalProcess::Clock::now() + 20s), ExternalEvent::output);
  int lines = 0;
  std::string text(process.lines().rest());
  EXPECT_EQ(exhaust(process, lines), ExternalEvent::ended);
  const auto group = std::stoi(text), session = std::stoi(text.substr(text.find(' ')));
  EXPECT_NE(group, getpgrp());
  EXPECT_NE(session, getsid(0));
}

TEST(ExternalProcess, InheritsNothingButItsThreeStreams) {
  const ExternalProcess other(launch_of({"/bin/cat"}));
  ExternalProcess process(launch_of({"/bin/ls", "/proc/self/fd"}));
  int lines = 0;
  EXPECT_EQ(exhaust(process, lines), ExternalEvent::ended);
  EXPECT_EQ(lines, 4) << "the fourth is the folder that it lists";
}

TEST(ExternalProcess, SaysHowItEnded) {
  EXPECT_EQ(describe(ExitStatus{3, 0}), "exit code 3");
  EXPECT_EQ(describe(ExitStatus{0, SIGSEGV}), "signal 11 (Segmentation fault)");
}

}  // namespace
}  // namespace labmouse
