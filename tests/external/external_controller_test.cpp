// External mice that drive a mouse themselves: how they are asked, and every way in which they can end.
#include "labmouse/external/external_controller.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/contest/code_contest.hpp"
#include "labmouse/external/controller_protocol.hpp"
#include "tests/external/bad_programs.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::HasParts;
using testing::HasSubstr;
using namespace std::chrono_literals;

struct Contest {
  PhysicalRecord record;
  std::string words;
  bool started = true;
};

Contest contest(const Launch& launch, MazeTime limit = 3600'000'000) {
  static const auto model = test::drive_model("kerise");
  DriveRules rules = find_rules("all-japan").rules;
  rules.time_limit = limit;
  PhysicalConditions conditions;
  conditions.trace_every = 1;
  ExternalController code(launch, "labmouse pilot 1\nbegin\n",
                          SpeedControl(*model->robot.hardware, model->tables.cell));
  Contest held;
  held.record = drive_by_code(test::ring(), rules, *model, conditions, 1, code);
  held.words = code.last_words();
  held.started = code.started();
  return held;
}

/// What a controller answers, line by line, as a shell script that also writes down what it is asked.
Launch scripted(const std::string& answers, const std::string& greeting = "labmouse pilot 1") {
  Launch launch;
  launch.words = {"sh", "-c",
                  "exec 3<&0; echo '" + greeting + "'; " + answers +
                      " | while read -r answer; do read -r line <&3; while [ \"${line%% *}\" != sense ]; do"
                      " [ \"${line%% *}\" = carried ] && echo \"$line\" >&2; read -r line <&3; done;"
                      " set -- $line; echo $# $2 >&2; echo \"$answer\"; done"};
  return launch;
}

TEST(ExternalController, ChoosesItsBatchByTheLengthOfItsAnswer) {
  // The words of a question: `sense`, and 13 numbers a tick, the number of the tick first.
  const Contest held = contest(scripted("(echo drive 1 2 3 4 5 6; echo drive 7 8; echo fast 9 9 9 9; echo forfeit)"));
  EXPECT_EQ(
      held.record.tape,
      (std::vector<ControllerTick>{
          {1, 2}, {3, 4}, {5, 6}, {7, 8}, {9, 9, ControllerWord::fast}, {9, 9}, {0, 0, ControllerWord::give_up}}));
  EXPECT_THAT(held.words, HasSubstr("14 1\n40 2\n14 5\n27 6"));
  EXPECT_EQ(held.record.drive.reason, ForfeitReason::gave_up);
}

TEST(ExternalController, MayAnswerWithSpeeds) {
  const std::string still = "drive 0 0 0 0 0 0 0 0", ahead = "drive 300 0 300 0 300 0 300 0";
  const std::string answers = "(for i in 1 2 3 4 5; do echo " + still + "; done; for i in $(seq 60); do echo " + ahead +
                              "; done; echo carry; echo " + still + "; echo forfeit)";
  const Contest held = contest(scripted(answers, "labmouse pilot 1 speeds"));
  const auto& tape = held.record.tape;
  ASSERT_GT(tape.size(), 262U) << held.words;
  for (std::size_t i = 0; i < 20; ++i) EXPECT_LT(std::abs(tape[i].left), 600) << i;
  EXPECT_GT(tape[20].left, 1000);
  const std::vector<TracePoint>& trace = held.record.trace;  // a point a tick
  EXPECT_NEAR(trace[258].truth.position.y - trace[208].truth.position.y, 15.0, 0.75);
  EXPECT_LT(std::abs(tape[261].left), 600) << "the loop was not put to rest";
  EXPECT_EQ(held.record.drive.reason, ForfeitReason::gave_up);
}

TEST(ExternalController, HoldsTheSameContestInBatchesOfAnyLength) {
  // Half a second of duties that turn it on the spot, cut otherwise each time.
  std::vector<std::string> duties;
  for (int i = 0; i < 500; ++i) duties.push_back(std::to_string(-i * 37 % 9000) + " " + std::to_string(i * 53 % 8000));
  const auto held = [&](int seed) {
    std::string answers = "(";
    for (std::size_t i = 0, size = 1; i < duties.size(); i += size) {
      size =
          seed == 0 ? 1 : std::min<std::size_t>(1 + (i * 7 + static_cast<std::size_t>(seed)) % 64, duties.size() - i);
      answers += "echo drive";
      for (std::size_t k = 0; k < size; ++k) answers += " " + duties[i + k];
      answers += "; ";
    }
    return contest(scripted(answers + "echo forfeit)")).record;
  };
  const PhysicalRecord one_by_one = held(0);
  EXPECT_EQ(one_by_one.tape.size(), 501U);
  ASSERT_EQ(one_by_one.trace.size(), 500U);
  EXPECT_NE(one_by_one.trace.back().truth.angle, one_by_one.trace.front().truth.angle);
  for (const int seed : {1, 2, 63}) EXPECT_TRUE(held(seed) == one_by_one) << seed;
}

TEST(ExternalController, IsToldThatItWasCarried) {
  const Contest held = contest(scripted("(echo carry; echo drive 0 0 0 0; echo forfeit)"));
  // Nothing of what was read before, and the tick in which it was put down.
  EXPECT_THAT(held.words, HasSubstr("14 1\ncarried wish\n14 2\n27 3"));
  EXPECT_EQ(held.record.carried, 1);
}

TEST(ExternalController, LosesTheDutiesThatACrashLeft) {
  // Full ahead into the wall, 64 ticks at a time.
  const std::string full = "$(yes '30000 30000' | head -n 64 | tr '\\n' ' ' | sed 's/ $//')";
  const Contest held =
      contest(scripted("(for i in 1 2 3 4 5 6 7 8 9 10 11 12; do echo drive " + full + "; done; echo forfeit)"));
  EXPECT_GE(held.record.carried, 1);
  EXPECT_THAT(held.words, HasSubstr("carried crash\n14 "));
}

struct Misbehaviour {
  const char* how;
  ForfeitReason reason;
  std::vector<std::string> words;
};

void PrintTo(const Misbehaviour& m, std::ostream* out) { *out << m.how; }

class ABadController : public testing::TestWithParam<Misbehaviour> {};

TEST_P(ABadController, EndsUnderItsName) {
  const int before = test::open_descriptors(), children = test::children();
  Launch launch = test::bad_program(GetParam().how);
  // On a busy machine they wait for longer than they work.
  if (GetParam().reason == ForfeitReason::late) launch.limits.silence = 20s;
  const Contest held = contest(launch);
  EXPECT_EQ(held.record.drive.outcome, DriveOutcome::forfeit);
  EXPECT_EQ(name_of(held.record.drive.reason), name_of(GetParam().reason));
  EXPECT_EQ(held.record.tape.back().word, ControllerWord::give_up);
  EXPECT_THAT(held.words, HasParts(GetParam().words));
  EXPECT_EQ(test::tagged_processes(), 0);
  EXPECT_EQ(test::open_descriptors(), before);
  EXPECT_EQ(test::children(), children);
}

INSTANTIATE_TEST_SUITE_P(
    All, ABadController,
    testing::Values(Misbehaviour{"pilot hang at the start", ForfeitReason::hung, {"0.4 s", "--start-limit", "flush"}},
                    Misbehaviour{
                        "pilot end at the start", ForfeitReason::ended_early, {"exit code 0", "'labmouse pilot 1'"}},
                    Misbehaviour{"pilot wrong greeting", ForfeitReason::invalid_answer, {"'hello'"}},
                    Misbehaviour{"turn", ForfeitReason::invalid_answer, {"'labmouse 1'", "program:COMMAND"}},
                    Misbehaviour{"pilot give up", ForfeitReason::gave_up, {"`forfeit`"}},
                    Misbehaviour{"pilot hang", ForfeitReason::hung, {"0.8 s", "--silence-limit"}},
                    Misbehaviour{"pilot hang within a line", ForfeitReason::hung, {"'drive 0'", "ending the line"}},
                    Misbehaviour{"pilot late", ForfeitReason::late, {"processor time", "0.4 s"}},
                    Misbehaviour{"pilot work", ForfeitReason::late, {"processor time", "0.4 s", "--decision-limit"}},
                    Misbehaviour{"pilot die", ForfeitReason::ended_early, {"exit code 3\none\ntwo\nthree: no way out"}},
                    Misbehaviour{"pilot crash", ForfeitReason::ended_early, {"signal 11 ", "\nabout to crash"}},
                    Misbehaviour{"pilot rubbish", ForfeitReason::invalid_answer, {"'what?'", "`drive`", "64"}},
                    Misbehaviour{"pilot bytes", ForfeitReason::invalid_answer, {"'\\0\\xff\\x1b[2J'"}},
                    Misbehaviour{"pilot many answers", ForfeitReason::flooded, {"'drive 0 0'", "more: 'drive 0 0'"}},
                    Misbehaviour{"pilot flood", ForfeitReason::flooded, {"wrote more"}},
                    Misbehaviour{"pilot long line", ForfeitReason::flooded, {"4096 bytes", "'aaa"}},
                    Misbehaviour{"pilot fork and leave", ForfeitReason::left, {"process", "started"}},
                    Misbehaviour{"pilot close output", ForfeitReason::closed, {"standard output"}},
                    Misbehaviour{"pilot close input", ForfeitReason::closed, {"standard input"}},
                    Misbehaviour{"pilot kill the keeper", ForfeitReason::ended_early, {"signal 9"}}),
    [](const auto& test) {
      std::string name = test.param.how;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

TEST(ExternalController, KeepsTheLimitsOfItsTree) {
  Launch launch = test::bad_program("pilot idlers");
  launch.limits.decision = launch.limits.silence = 20s;
  launch.limits.processes = 40;
  EXPECT_EQ(contest(launch).record.drive.reason, ForfeitReason::too_many_processes);
  launch = test::bad_program("pilot eat memory");
  launch.limits.decision = launch.limits.silence = 20s;
  launch.limits.memory = std::uint64_t{1} << 28U;
  EXPECT_EQ(contest(launch).record.drive.reason, ForfeitReason::too_much_memory);
}

TEST(ExternalController, EndsWithItsContest) {
  Launch launch = test::bad_program("pilot turn");
  launch.limits.contest = 100ms;
  const Contest held = contest(launch);
  EXPECT_EQ(held.record.drive.reason, ForfeitReason::out_of_time);
  EXPECT_TRUE(held.started);
}

TEST(ExternalController, SaysWhyItCouldNotBeStarted) {
  Launch launch = test::bad_program("pilot turn");
  launch.words.front() = "/no/such/program";
  const Contest held = contest(launch);
  EXPECT_EQ(held.record.drive.reason, ForfeitReason::not_started);
  EXPECT_THAT(held.words, HasSubstr("not found"));
  EXPECT_FALSE(held.started);
}

TEST(ExternalController, StandsUntilTheTimeOfTheContestIsOver) {
  const Contest held = contest(test::bad_program("pilot turn"), 1'000'000);
  EXPECT_EQ(held.record.drive.outcome, DriveOutcome::out_of_time);
  EXPECT_EQ(held.record.tape.size(), 1000U);
  EXPECT_EQ(held.words, "");
}

TEST(ControllerProtocol, TellsWhatWasRead) {
  Sense sense;
  sense.tick = 7;
  sense.counts = {-3, 400000};
  sense.gyro = -32767;
  sense.acceleration = {1, -2};
  sense.infrared = {10, 20, 30, 3650};
  sense.infrared_sensors = 4;
  sense.ranges[0] = {255, true};
  sense.range_sensors = 1;
  sense.millivolts = 3987;
  std::string text = "sense";
  add_sense(sense, text);
  EXPECT_EQ(text, "sense 7 -3 400000 -32767 1 -2 10 20 30 3650 255 1 3987");
}

TEST(ControllerProtocol, ReadsAnswers) {
  using Ticks = std::vector<ControllerTick>;
  EXPECT_EQ(read_duties("drive 1 -2"), (Ticks{{1, -2}}));
  EXPECT_EQ(read_duties("goal 32767 -32767 0 0"), (Ticks{{32767, -32767, ControllerWord::goal}, {0, 0}}));
  EXPECT_EQ(read_duties("fast 0 0")->front().word, ControllerWord::fast);
  EXPECT_EQ(read_duties("carry"), (Ticks{{0, 0, ControllerWord::carry}}));
  EXPECT_EQ(read_duties("forfeit"), (Ticks{{0, 0, ControllerWord::give_up}}));
  std::string line = "drive";
  for (int i = 0; i < 64; ++i) line += " 5 6";
  EXPECT_EQ(read_duties(line)->size(), 64U);
  EXPECT_FALSE(read_duties(line + " 5 6"));
}

TEST(ControllerProtocol, ReadsNothingElse) {
  for (const char* line :
       {"",           " ",           "drive",      "drive ",        "drive 1",        "drive 1 2 3",
        "drive 1 2 ", "drive  1 2",  " drive 1 2", "drive 32768 0", "drive 0 -32768", "drive 0 99999999999",
        "drive +1 2", "drive 1.5 2", "drive a b",  "drive 1 2 x y", "drive\t1 2",     "carry 0 0",
        "forfeit 1",  "Drive 1 2",   "drives 1 2", "home 1 2",      "carry ",         "goal",
        "fast 1"})
    EXPECT_FALSE(read_duties(line)) << line;
}

}  // namespace
}  // namespace labmouse
