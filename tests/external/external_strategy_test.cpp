#include "labmouse/external/external_strategy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "labmouse/contest/simulator.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/external/bad_programs.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::HasParts;
using test::Says;
using testing::HasSubstr;
using namespace std::chrono_literals;

const Maze& corridor() {
  static const Maze maze = test::drawn(R"(
      o---o---o---o
      | S       G |
      o---o---o---o
  )");
  return maze;
}

RunRecord contest(const Launch& launch, int budget = 1000) {
  Rules rules;
  rules.budget = budget;
  ExternalStrategy strategy(launch, brief(corridor(), rules, 7));
  return run(corridor(), rules, strategy);
}

RunRecord contest(const std::string& how) { return contest(test::bad_program(how)); }

TEST(ExternalStrategy, PlaysToTheEndOfItsSteps) {
  const RunRecord record = contest(test::bad_program("turn"), 10);
  EXPECT_EQ(record.outcome, Outcome::out_of_steps);
  EXPECT_EQ(record.steps.size(), 10U);
  EXPECT_EQ(record.steps.back().action, Action::step(90, 0));
  EXPECT_EQ(record.last_words, "");
}

struct Misbehaviour {
  const char* how;
  ForfeitReason reason;
  std::vector<std::string> words;
};

void PrintTo(const Misbehaviour& m, std::ostream* out) { *out << m.how; }

class BadProgram : public testing::TestWithParam<Misbehaviour> {};

TEST_P(BadProgram, EndsUnderItsName) {
  const int before = test::open_descriptors(), children = test::children();
  constexpr int endless = 1'000'000;  // steps: none of them ends for want of these
  Launch launch = test::bad_program(GetParam().how);
  // On a busy machine they wait for longer than they work.
  if (GetParam().reason == ForfeitReason::late) launch.limits.silence = 20s;
  const RunRecord record = contest(launch, endless);
  EXPECT_EQ(record.outcome, Outcome::forfeit);
  EXPECT_EQ(name_of(record.steps.back().action.reason), name_of(GetParam().reason));
  EXPECT_THAT(record.last_words, HasParts(GetParam().words));
  EXPECT_EQ(test::tagged_processes(), 0);
  EXPECT_EQ(test::open_descriptors(), before);
  EXPECT_EQ(test::children(), children);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadProgram,
    testing::Values(Misbehaviour{"hang at the start", ForfeitReason::hung, {"0.4 s", "--start-limit", "flush"}},
                    Misbehaviour{"hang within a line", ForfeitReason::hung, {"'move 0'", "ending the line"}},
                    Misbehaviour{"end at the start", ForfeitReason::ended_early, {"exit code 0", "'labmouse 1'"}},
                    Misbehaviour{"wrong greeting", ForfeitReason::invalid_answer, {"'hello'"}},
                    Misbehaviour{"mms", ForfeitReason::invalid_answer, {"mms:COMMAND"}},
                    Misbehaviour{"other version", ForfeitReason::invalid_answer, {"'labmouse 2'", "'labmouse 1'"}},
                    Misbehaviour{"daemon at the start", ForfeitReason::invalid_answer, {"'rubbish'"}},
                    Misbehaviour{"give up", ForfeitReason::gave_up, {"`forfeit`"}},
                    Misbehaviour{"hang", ForfeitReason::hung, {"0.8 s", "--silence-limit"}},
                    Misbehaviour{"late", ForfeitReason::late, {"processor time", "0.4 s", "--decision-limit"}},
                    Misbehaviour{"work", ForfeitReason::late, {"processor time", "0.4 s", "--decision-limit"}},
                    Misbehaviour{"die", ForfeitReason::ended_early, {"exit code 3\none\ntwo\nthree: no way out"}},
                    Misbehaviour{"end", ForfeitReason::ended_early, {"exit code 0"}},
                    Misbehaviour{"crash", ForfeitReason::ended_early, {"signal 11 ", "\nabout to crash"}},
                    Misbehaviour{"rubbish", ForfeitReason::invalid_answer, {"'what?'"}},
                    Misbehaviour{"bytes", ForfeitReason::invalid_answer, {"'\\0\\xff\\x1b[2J'"}},
                    Misbehaviour{
                        "marked greeting", ForfeitReason::invalid_answer, {"'\\ufefflabmouse 1'", "byte-order mark"}},
                    Misbehaviour{"many answers", ForfeitReason::flooded, {"answer 'move 90 0'", "more: 'move 90 0'"}},
                    Misbehaviour{"flood", ForfeitReason::flooded, {"wrote more"}},
                    Misbehaviour{"long line", ForfeitReason::flooded, {"4096 bytes", "'aaa"}},
                    Misbehaviour{"flood errors", ForfeitReason::late, {"again and again"}},
                    Misbehaviour{"fork and leave", ForfeitReason::left, {"process", "started"}},
                    Misbehaviour{"leave answering", ForfeitReason::left, {"process", "started"}},
                    Misbehaviour{"close output", ForfeitReason::closed, {"standard output"}},
                    Misbehaviour{"close input", ForfeitReason::closed, {"standard input"}},
                    Misbehaviour{"close all", ForfeitReason::closed, {"closed"}},
                    Misbehaviour{"stop the keeper", ForfeitReason::invalid_answer, {"'what?'"}},
                    Misbehaviour{"kill the keeper", ForfeitReason::ended_early, {"signal 9"}}),
    [](const auto& test) {
      std::string name = test.param.how;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

TEST(ExternalStrategy, MayWriteErrorsWithoutEnd) {
  // More than a pipe holds: nobody would answer if nobody read them.
  const RunRecord record = contest(test::bad_program("errors beside"), 1);
  EXPECT_EQ(record.steps.back().action, Action::step(90, 0));
}

TEST(ExternalStrategy, KeepsWhatItWroteToItsErrorsInAnyContest) {
  const RunRecord record = contest(test::bad_program("write notes"), 2);
  EXPECT_EQ(record.outcome, Outcome::out_of_steps);
  EXPECT_EQ(record.last_words, "a note\na note\n");
}

/// Results that have these words are the same each time.
TEST(ExternalStrategy, HasTheSameWordsHoweverMuchItIsTooSlow) {
  const auto words_of = [](const char* how) {
    Launch launch = test::bad_program(how);
    launch.limits.silence = 20s;
    return contest(launch).last_words;
  };
  EXPECT_EQ(words_of("late"), words_of("work"));
}

TEST(ExternalStrategy, KeepsOnlyTheLastErrors) {
  const RunRecord record = contest("flood errors");
  EXPECT_LT(record.last_words.size(), ExternalLimits().kept_errors + 100);
}

TEST(ExternalStrategy, IsDeniedMuchMoreMemoryThanAllowed) {
  Launch launch = test::bad_program("ask for memory");
  launch.limits.memory = std::uint64_t{1} << 28U;
  launch.limits.decision = launch.limits.silence = 10s;
  const RunRecord record = contest(launch);
  EXPECT_EQ(record.steps.back().action.reason, ForfeitReason::ended_early);
  EXPECT_THAT(record.last_words, HasSubstr("bad_alloc"));
}

TEST(ExternalStrategy, IsDeniedMoreProcessorTimeThanAllowed) {
  Launch launch = test::bad_program("burn");
  launch.limits.processor_seconds = 1;
  launch.limits.decision = launch.limits.silence = 20s;
  const RunRecord record = contest(launch);
  EXPECT_EQ(record.steps.back().action.reason, ForfeitReason::ended_early);
  EXPECT_THAT(record.last_words, HasSubstr("CPU time limit exceeded"));
}

TEST(ExternalStrategy, MayBeDeafToTheSignalOfItsLimit) {
  Launch launch = test::bad_program("burn on");
  launch.limits.processor_seconds = 1;
  launch.limits.decision = launch.limits.silence = 20s;
  EXPECT_THAT(contest(launch).last_words, HasSubstr("CPU time limit exceeded"));
}

TEST(ExternalStrategy, EndsWithItsContest) {
  Launch launch = test::bad_program("turn");
  launch.limits.contest = 100ms;
  const RunRecord record = contest(launch, 1'000'000'000);
  EXPECT_EQ(record.steps.back().action.reason, ForfeitReason::out_of_time);
  EXPECT_THAT(record.last_words, Says("contest", "0.1 s"));
}

TEST(ExternalStrategy, EndsWhenItIsStopped) {
  std::atomic<bool> stop = false;
  Launch launch = test::bad_program("hang");
  launch.limits.start = launch.limits.silence = 20s;
  launch.stop = &stop;
  RunRecord record;
  std::thread other([&] { record = contest(launch); });
  stop = true;
  other.join();
  EXPECT_EQ(record.steps.back().action.reason, ForfeitReason::interrupted);
  EXPECT_EQ(test::tagged_processes(), 0);
}

TEST(ExternalStrategy, SaysWhyItCouldNotBeStarted) {
  Launch launch = test::bad_program("turn");
  launch.words.front() = "/no/such/program";
  EXPECT_THAT(contest(launch).last_words, Says("not found", "'/no/such/program'"));
  launch = test::bad_program("turn");
  launch.directory = "/no/such/folder";
  const RunRecord record = contest(launch);
  EXPECT_EQ(record.steps.back().action.reason, ForfeitReason::not_started);
  EXPECT_THAT(record.last_words, HasSubstr("No such file or directory"));
}

TEST(ExternalStrategy, LeavesNothingBehindAThousandPrograms) {
  const int descriptors = test::open_descriptors(), children = test::children();
  const std::vector<std::string> ways = {
      "die", "rubbish", "daemon at the start", "many answers", "wrong greeting", "crash", "long line", "flood"};
  const auto of_every_kind = [&](int first) {
    for (int i = first; i < (test::thorough ? 1000 : 100); i += 4) {
      const RunRecord record = contest(ways[static_cast<std::size_t>(i) / 4 % ways.size()]);
      EXPECT_EQ(record.outcome, Outcome::forfeit);
    }
  };
  std::vector<std::thread> threads;
  for (int first = 0; first < 4; ++first) threads.emplace_back(of_every_kind, first);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(test::open_descriptors(), descriptors);
  EXPECT_EQ(test::children(), children);
  EXPECT_EQ(test::tagged_processes(), 0);
}

}  // namespace
}  // namespace labmouse
