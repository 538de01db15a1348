// Contests of programs of somebody else's: what of runs, crashes and time is seen from outside.
#include "labmouse/contest/code_contest.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/taped_code.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"

namespace labmouse {
namespace {

using Kind = DriveRun::Kind;

/// It starts facing a way of two cells to the goal, and three behind that.
const Maze& corridor() {
  static const Maze maze = test::drawn(R"(
    o---o---o---o---o---o---o
    | S       G             |
    o---o---o---o---o---o---o
  )")
                               .with_start({0, 0}, Heading::east);
  return maze;
}

/// The start lies between two dead ends.
const Maze& passage() {
  static const Maze maze = test::drawn(R"(
    o---o---o---o---o---o---o---o---o---o
    | G               S                 |
    o---o---o---o---o---o---o---o---o---o
  )")
                               .with_start({4, 0}, Heading::east);
  return maze;
}

/// Prompted what a function says, by the number of the tick since it was put down.
class Prompted final : public ControllerCode {
 public:
  using Say = std::function<ControllerTick(int tick, const Prompted& self)>;
  explicit Prompted(Say say) : say_(std::move(say)) {}

  ControllerTick tick(const Sense& sense) override {
    const double travel = (sense.counts[0] + sense.counts[1]) * 0.5;
    if (tick_ == 0) from_ = travel;
    way = travel - from_;
    return say_(tick_++, *this);
  }
  void carried(bool crashed) override {
    tick_ = 0;
    ++(crashed ? crashes : wishes);
  }

  double way = 0.0;  ///< counts since it was put down
  int crashes = 0, wishes = 0;

 private:
  Say say_;
  double from_ = 0.0;
  int tick_ = 0;
};

constexpr ControllerTick ahead(int duty, ControllerWord word = ControllerWord::drive) {
  return {static_cast<std::int16_t>(duty), static_cast<std::int16_t>(duty), word};
}
constexpr int slow = 2000;  // some 250 mm/s

struct Contest {
  PhysicalRecord record;
  DriveScore score;
};

PhysicalConditions errors(double scale) {
  PhysicalConditions conditions;
  conditions.errors = {.noise = scale, .variation = scale};
  return conditions;
}

Contest contest(ControllerCode& code, const Maze& maze = corridor(), const std::string& rules = "all-japan") {
  static const auto model = test::drive_model("kerise");
  const DriveRules by = find_rules(rules).rules;
  Contest held = {drive_by_code(maze, by, *model, errors(0.0), 1, code), {}};
  held.score = score(held.record.drive, by);
  return held;
}

double cells(const Prompted& code) { return code.way * 0.00077 / 90.0; }

TEST(CodeContest, EndsWithTheTimeOfOneThatStands) {
  Prompted code([](int, const Prompted&) { return ahead(0); });
  const Contest held = contest(code);
  EXPECT_EQ(held.record.drive.outcome, DriveOutcome::out_of_time);
  EXPECT_TRUE(held.record.drive.runs.empty());
  EXPECT_EQ(held.record.tape.size(), 300'000U);
}

TEST(CodeContest, TimesARunFromGateToGateByTheTrueMouse) {
  Prompted code(
      [](int, const Prompted& self) { return cells(self) < 2.2 ? ahead(slow) : ahead(0, ControllerWord::give_up); });
  const Contest held = contest(code);
  ASSERT_EQ(held.record.drive.runs.size(), 1U);
  const DriveRun& run = held.record.drive.runs[0];
  EXPECT_EQ(run.kind, Kind::search);
  EXPECT_EQ(held.record.ends[0], RunEnd::done);
  EXPECT_EQ(held.record.drive.outcome, DriveOutcome::finished);
  // It was asked for a cell and a half in between.
  EXPECT_LT(run.begin, *run.gate_out);
  EXPECT_LT(*run.gate_out, *run.gate_in);
  EXPECT_LT(*run.gate_in, *run.centre);
  EXPECT_EQ(held.score.value(), *run.gate_in - *run.gate_out);
}

TEST(CodeContest, BeginsARunWhereItLastStood) {
  Prompted code([](int tick, const Prompted& self) {
    return cells(self) > 1.0 ? ahead(0, ControllerWord::give_up) : ahead(tick < 1000 ? 0 : slow);
  });
  const Contest held = contest(code);
  ASSERT_EQ(held.record.drive.runs.size(), 1U);
  EXPECT_GE(held.record.drive.runs[0].begin, 1'000'000);
  EXPECT_LE(held.record.drive.runs[0].begin, 1'100'000);
  EXPECT_EQ(held.record.drive.outcome, DriveOutcome::forfeit);
  EXPECT_EQ(held.record.drive.reason, ForfeitReason::gave_up);
  EXPECT_EQ(held.record.ends[0], RunEnd::given_up);
}

TEST(CodeContest, CarriesAMouseThatCrashedUntilItsRunsAreOver) {
  Prompted code([](int, const Prompted&) { return ahead(slow); });
  const Contest held = contest(code);
  const auto& runs = held.record.drive.runs;
  ASSERT_EQ(runs.size(), 5U);
  EXPECT_EQ(code.crashes, 4);
  EXPECT_EQ(held.record.carried, 4);
  EXPECT_EQ(held.record.touches.size(), 5U);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    // It went on behind the goal, as a search may, and crashed there; yet it has been in the goal.
    EXPECT_EQ(held.record.ends[i], RunEnd::position_lost);
    EXPECT_TRUE(runs[i].gate_in);
    EXPECT_EQ(runs[i].touched, i > 0);
    if (i > 0) {
      EXPECT_GE(runs[i].begin, runs[i - 1].end + 5'000'000);
    }
  }
  EXPECT_EQ(held.record.drive.outcome, DriveOutcome::finished);
}

TEST(CodeContest, IsOverForASpeedRunOnceItIsInTheGoal) {
  Prompted code(
      [](int tick, const Prompted&) { return ahead(slow, tick == 0 ? ControllerWord::fast : ControllerWord::drive); });
  const Contest held = contest(code);
  ASSERT_EQ(held.record.drive.runs.size(), 5U);
  EXPECT_EQ(held.record.drive.runs[0].kind, Kind::speed);
  EXPECT_EQ(held.record.ends[0], RunEnd::done);
}

TEST(CodeContest, CarriesAMouseThatWantsIt) {
  Prompted code([](int, const Prompted& self) {
    if (self.wishes == 1) return ahead(0, ControllerWord::give_up);
    return cells(self) < 1.0 ? ahead(slow) : ahead(0, ControllerWord::carry);
  });
  const Contest held = contest(code);
  EXPECT_EQ(code.crashes, 0);
  EXPECT_EQ(held.record.carried, 1);
  EXPECT_EQ(held.record.ends[0], RunEnd::given_up);
  EXPECT_TRUE(held.record.touches.empty());
}

TEST(CodeContest, LetsNobodyBeCarriedForEver) {
  Prompted code([](int, const Prompted&) { return ahead(0, ControllerWord::carry); });
  static const auto model = test::drive_model("kerise");
  DriveRules rules = find_rules("all-japan").rules;
  rules.time_limit = 1'000'000;
  PhysicalConditions conditions = errors(1.0);
  conditions.handling = 0;
  const PhysicalRecord record = drive_by_code(corridor(), rules, *model, conditions, 1, code);
  EXPECT_EQ(record.drive.outcome, DriveOutcome::out_of_time);
  EXPECT_EQ(record.carried, 1000);
}

TEST(CodeContest, TellsTheWayHomeFromTheRun) {
  // Into the goal, says so, and back to where it came from, where it stays.
  bool back = false;
  int stands = 0;
  Prompted code([&](int, const Prompted& self) {
    if (cells(self) > 2.2) back = true;
    if (back && cells(self) < 0.4) return ahead(0, ++stands > 1000 ? ControllerWord::give_up : ControllerWord::drive);
    return back ? ahead(-slow, ControllerWord::goal) : ahead(slow);
  });
  const Contest held = contest(code);
  ASSERT_EQ(held.record.drive.runs.size(), 2U);
  EXPECT_EQ(held.record.drive.runs[0].kind, Kind::search);
  EXPECT_EQ(held.record.drive.runs[1].kind, Kind::home);
  EXPECT_EQ(held.record.drive.runs[1].begin, held.record.drive.runs[0].end);
  EXPECT_EQ(held.record.ends[0], RunEnd::done);
  EXPECT_EQ(held.record.ends[1], RunEnd::done);
}

TEST(CodeContest, DoesNotTakeThePassingOfTheStartForANewRun) {
  // To the east, back through the start without a stop, and into the goal in the west.
  bool back = false;
  Prompted code([&](int, const Prompted& self) {
    if (cells(self) > 2.0) back = true;
    if (cells(self) < -4.0) return ahead(0, ControllerWord::give_up);
    return ahead(back ? -slow : slow);
  });
  const Contest held = contest(code, passage());
  ASSERT_EQ(held.record.drive.runs.size(), 1U);
  EXPECT_TRUE(held.record.drive.runs[0].gate_in);
}

TEST(CodeContest, IsOverWithTheLastRunThatTheRulesAllow) {
  static const auto model = test::drive_model("kerise");
  DriveRules rules = find_rules("all-japan").rules;
  rules.most_runs = 1;
  Prompted code([](int, const Prompted& self) { return ahead(cells(self) < 2.2 ? slow : 0, ControllerWord::goal); });
  const PhysicalRecord record = drive_by_code(corridor(), rules, *model, errors(0.0), 1, code);
  EXPECT_EQ(record.drive.runs.size(), 1U);
  EXPECT_EQ(record.ends[0], RunEnd::done);
  EXPECT_LT(record.tape.size(), 5000U);
}

TEST(CodeContest, IsTheSameFromItsTape) {
  Rng rng(5);
  for (const double level : {0.0, 1.0, 3.0}) {
    // Anything at all.
    ControllerTick last;
    Prompted code([&](int tick, const Prompted&) {
      if (tick % 40 == 0)
        last = {static_cast<std::int16_t>(rng.bits()), static_cast<std::int16_t>(rng.bits()), ControllerWord::drive};
      last.left = std::max<std::int16_t>(last.left, -ControllerTick::full);
      last.right = std::max<std::int16_t>(last.right, -ControllerTick::full);
      last.word = rng.bits() % 500 == 0 ? static_cast<ControllerWord>(rng.bits() % 4) : ControllerWord::drive;
      return last;
    });
    const auto model = test::drive_model("kerise");
    const DriveRules rules = find_rules("apec").rules;
    PhysicalConditions conditions = errors(level);
    conditions.trace_every = 100;
    const PhysicalRecord record = drive_by_code(test::ring(), rules, *model, conditions, 9, code);
    TapedCode tape(record.tape, record.drive.reason);
    EXPECT_EQ(drive_by_code(test::ring(), rules, *model, conditions, 9, tape), record);
  }
}

}  // namespace
}  // namespace labmouse
