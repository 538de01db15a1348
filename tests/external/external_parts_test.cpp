// Parts of the controller that are another program: how they are asked, and every way in which they can end.
#include "labmouse/external/external_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/external/controller_protocol.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/external/bad_programs.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"
#include "tests/says.hpp"

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

/// A contest of flood-return in the ring.
Contest contest(const Launch& launch, MazeTime limit = 3600'000'000) {
  static const auto model = test::drive_model("kerise");
  DriveRules rules = find_rules("all-japan").rules;
  rules.time_limit = limit;
  Briefing briefing = brief(test::ring(), rules, *model, 1);
  briefing.sight = 1;
  const BuiltinMouse& entry = *find_mouse("flood-return");
  const auto strategy = entry.drive(briefing, Settings(entry.parameters));
  ExternalParts program(launch, "labmouse pilot 1\nbegin\n");
  Contest held;
  held.record = drive_physically(test::ring(), rules, *model, {}, 1, *strategy, program.parts());
  held.words = program.last_words();
  held.started = program.started();
  return held;
}

/// A program that offers parts and then gives these answers, one to each question. It saves the lines that it gets.
Launch scripted(const std::string& parts, const std::string& answers) {
  Launch launch;
  launch.words = {"sh", "-c",
                  "exec 3<&0; echo 'labmouse pilot 1 " + parts + "'; (" + answers +
                      ") | while read -r answer; do while read -r line <&3; do echo \"$line\" >&2;"
                      " case \"${line%% *}\" in estimate|read|follow) break;; esac; done; echo \"$answer\"; done"};
  return launch;
}

TEST(ExternalParts, AreAskedOnceATickForEachPartOfferedAfterTheirEvents) {
  const std::string pose = "estimate 45 45 0 1 0 0 0 1 0 0 1 0 0.0003";
  const Contest held =
      contest(scripted("tracker estimator reader", "for i in 1 2; do echo " + pose +
                                                       "; echo evidence 1 -2 3; echo drive 5 -6; done; echo forfeit"));
  EXPECT_EQ(held.record.drive.reason, ForfeitReason::gave_up);
  std::vector<std::string> words;
  std::istringstream lines(held.words);
  for (std::string line; std::getline(lines, line);) {
    const auto numbers = std::count(line.begin(), line.end(), ' ');
    words.push_back(line.substr(0, line.find(' ')) + " " + std::to_string(numbers));
  }
  // 13 readings; a target has 8 numbers, an estimate has 13.
  EXPECT_THAT(words,
              testing::ElementsAre(testing::_, "labmouse 2", "begin 0", "put 4", "rest 0", "look 3", "estimate 21",
                                   "read 26", "follow 34", "estimate 21", "read 26", "follow 34", "estimate 21"));
  EXPECT_THAT(held.words, HasSubstr("\nput 45 45 0 1\nrest\nlook 0 0 north\nestimate 1 "));
  // What it answered comes back.
  EXPECT_THAT(held.words, HasSubstr(" 45 45 0 1 0 0 0 1 0 0 1 0 0.0003\nfollow "));
}

TEST(ExternalParts, HaveContestsThatAreMarked) {
  for (const char* how : {"part give up", "part end at the start"}) {
    const Contest held = contest(test::bad_program(how));
    EXPECT_TRUE(held.record.foreign_parts) << how;
    EXPECT_TRUE(held.record.drive.runs.empty()) << how;
  }
}

struct Misbehaviour {
  const char* how;
  ForfeitReason reason;
  std::vector<std::string> words;
};

void PrintTo(const Misbehaviour& m, std::ostream* out) { *out << m.how; }

class ABadPart : public testing::TestWithParam<Misbehaviour> {};

TEST_P(ABadPart, EndsUnderItsName) {
  const int before = test::open_descriptors(), children = test::children();
  Launch launch = test::bad_program(GetParam().how);
  // On a busy machine they wait for longer than they work.
  if (GetParam().reason == ForfeitReason::late) launch.limits.silence = 20s;
  const Contest held = contest(launch);
  EXPECT_EQ(held.record.drive.outcome, DriveOutcome::forfeit);
  EXPECT_EQ(name_of(held.record.drive.reason), name_of(GetParam().reason));
  EXPECT_THAT(held.words, HasParts(GetParam().words));
  EXPECT_EQ(test::tagged_processes(), 0);
  EXPECT_EQ(test::open_descriptors(), before);
  EXPECT_EQ(test::children(), children);
}

INSTANTIATE_TEST_SUITE_P(
    All, ABadPart,
    testing::Values(Misbehaviour{"part hang at the start", ForfeitReason::hung, {"0.4 s", "--start-limit", "flush"}},
                    Misbehaviour{"part end at the start", ForfeitReason::ended_early, {"exit code 0", "PART..."}},
                    Misbehaviour{"part wrong greeting", ForfeitReason::invalid_answer, {"'hello'", "estimator"}},
                    Misbehaviour{"pilot turn", ForfeitReason::invalid_answer, {"'labmouse pilot 1'", "controller:"}},
                    Misbehaviour{"part give up", ForfeitReason::gave_up, {"`forfeit`"}},
                    Misbehaviour{"part hang", ForfeitReason::hung, {"0.8 s", "--silence-limit"}},
                    Misbehaviour{"part hang within a line", ForfeitReason::hung, {"'drive 0'", "ending the line"}},
                    Misbehaviour{"part late", ForfeitReason::late, {"processor time", "0.4 s"}},
                    Misbehaviour{"part work", ForfeitReason::late, {"processor time", "0.4 s", "--decision-limit"}},
                    Misbehaviour{"part die", ForfeitReason::ended_early, {"exit code 3\none\ntwo\nthree: no way out"}},
                    Misbehaviour{"part crash", ForfeitReason::ended_early, {"signal 11 ", "\nabout to crash"}},
                    Misbehaviour{"part rubbish", ForfeitReason::invalid_answer, {"'what?'", "`drive`", "2 duties"}},
                    Misbehaviour{"part bytes", ForfeitReason::invalid_answer, {"'\\0\\xff\\x1b[2J'"}},
                    Misbehaviour{"part many answers", ForfeitReason::flooded, {"'drive 0 0'", "more: 'drive 0 0'"}},
                    Misbehaviour{"part flood", ForfeitReason::flooded, {"wrote more"}},
                    Misbehaviour{"part long line", ForfeitReason::flooded, {"4096 bytes", "'aaa"}},
                    Misbehaviour{"part fork and leave", ForfeitReason::left, {"process", "started"}},
                    Misbehaviour{"part close output", ForfeitReason::closed, {"standard output"}},
                    Misbehaviour{"part close input", ForfeitReason::closed, {"standard input"}},
                    Misbehaviour{"part kill the keeper", ForfeitReason::ended_early, {"signal 9"}}),
    [](const auto& test) {
      std::string name = test.param.how;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

TEST(ExternalParts, ForfeitByAnAnswerThatIsNone) {
  const std::string rest = " 45 0 1 0 0 0 1 0 0 1 0 0.0003";
  for (const char* number : {"nan", "NaN", "inf", "-inf", "1e7", "1e999", "0x1p3", "+1", "1,5", ""}) {
    const Contest held = contest(scripted("estimator", std::string("echo 'estimate ") + number + rest + "'"));
    EXPECT_EQ(held.record.drive.reason, ForfeitReason::invalid_answer) << number;
    EXPECT_EQ(held.record.drive.outcome, DriveOutcome::forfeit) << number;
    EXPECT_THAT(held.words, HasParts(std::vector<std::string>{"'estimate ", "13 numbers"})) << number;
  }
  const std::string turned = "echo 'estimate 45 45 0 1 ", still = " 0 0 1 0 0 1 0 0.0003'";
  EXPECT_EQ(contest(scripted("estimator", turned + "1.01" + still)).record.drive.reason, ForfeitReason::invalid_answer);
  EXPECT_NE(contest(scripted("estimator", turned + "-0.99" + still)).record.drive.reason,
            ForfeitReason::invalid_answer);
  for (const char* answer : {"evidence 128 0 0", "evidence 0 0", "evidence 0 0 0 0", "evidence 0.5 0 0", "drive 0 0"})
    EXPECT_THAT(contest(scripted("reader", std::string("echo ") + answer)).words, HasSubstr("-127 to 127")) << answer;
  for (const char* answer : {"drive 0 32768", "drive 0 0 0 0", "fast 0 0", "goal 0 0", "carry"})
    EXPECT_THAT(contest(scripted("tracker", std::string("echo ") + answer)).words, HasSubstr("2 duties")) << answer;
}

TEST(ExternalParts, EndWithTheirContestAndByTheirLimits) {
  Launch launch = test::bad_program("part slow");
  launch.limits.contest = 300ms;
  const Contest held = contest(launch);
  EXPECT_EQ(held.record.drive.reason, ForfeitReason::out_of_time);
  EXPECT_TRUE(held.started);
  launch = test::bad_program("part idlers");
  launch.limits.decision = launch.limits.silence = 20s;
  launch.limits.processes = 40;
  EXPECT_EQ(contest(launch).record.drive.reason, ForfeitReason::too_many_processes);
  launch = test::bad_program("part turn");
  launch.words.front() = "/no/such/program";
  const Contest none = contest(launch);
  EXPECT_EQ(none.record.drive.reason, ForfeitReason::not_started);
  EXPECT_FALSE(none.started);
  // It is asked, and stands, until the time is over.
  const Contest whole = contest(test::bad_program("part turn"), 1'000'000);
  EXPECT_EQ(whole.record.drive.reason, ForfeitReason::none);
  EXPECT_EQ(whole.record.drive.outcome, DriveOutcome::out_of_time);
}

TEST(ExternalParts, AreStoppedWithTheRace) {
  std::atomic<bool> stop = false;
  Launch launch = test::bad_program("part hang");
  launch.limits.decision = launch.limits.silence = 20s;
  launch.stop = &stop;
  std::thread user([&] {
    std::this_thread::sleep_for(200ms);
    stop = true;
  });
  EXPECT_EQ(contest(launch).record.drive.reason, ForfeitReason::interrupted);
  user.join();
}

TEST(PartsProtocol, ReadsGreetings) {
  EXPECT_EQ(read_parts_greeting("labmouse pilot 1 estimator"), (OfferedParts{true, false, false}));
  EXPECT_EQ(read_parts_greeting("labmouse pilot 1 tracker reader"), (OfferedParts{false, true, true}));
  for (const char* line : {"", "labmouse pilot 1", "labmouse pilot 1 ", "labmouse pilot 2 reader", "labmouse 1 reader",
                           "labmouse pilot 1 reader reader", "labmouse pilot 1 reader ", "labmouse pilot 1  reader",
                           "labmouse pilot 1 readers", "labmouse pilot 1reader"})
    EXPECT_FALSE(read_parts_greeting(line)) << line;
  // Each kind of program says what it is raced as.
  EXPECT_THAT(judge_controller_greeting("labmouse pilot 1 reader").verdict->sentence, HasSubstr("MOUSE:parts=COMMAND"));
  EXPECT_THAT(judge_parts_greeting("labmouse pilot 1").verdict->sentence, HasSubstr("controller:COMMAND"));
}

TEST(PartsProtocol, PassesNumbersWithAllTheirBits) {
  PoseEstimate estimate;
  estimate.position = {1.0 / 3.0, -2e-7};
  estimate.ahead = {0.6, 0.8};
  estimate.slip = -0.0;
  estimate.speed = 123456.789012345678;
  estimate.turning = 5e-324;
  estimate.covariance = {{{1.1, 2.2, 3.3}, {0.0, 4.4, 5.5}, {0.0, 0.0, 6.6}}};
  std::string line = "estimate";
  add_estimate(estimate, line);
  const auto read = read_estimate(line);
  ASSERT_TRUE(read) << line;
  EXPECT_EQ(read->position, estimate.position);
  EXPECT_EQ(read->ahead.sine, 0.6);
  EXPECT_EQ(read->ahead.cosine, 0.8);
  EXPECT_TRUE(std::signbit(read->slip));
  EXPECT_EQ(read->speed, estimate.speed);
  EXPECT_EQ(read->turning, 0.0) << "too small for anything";
  EXPECT_EQ(read->covariance, estimate.covariance);
  Target target;
  target.position = {1.5, 2.5};
  target.ahead = {1.0, 0.0};
  target.speed = 3.5, target.speeding = 4.5, target.turning = 5.5, target.twisting = 6.5;
  std::string said;
  add_target(target, said);
  EXPECT_EQ(said, " 1.5 2.5 0 1 3.5 4.5 5.5 6.5");
}

}  // namespace
}  // namespace labmouse
