// Strategies for the world of steps that drive in the worlds in seconds.
#include "labmouse/mouse/driven_steps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/failure_drive.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/lab/drive/failures_fixture.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using ::testing::ElementsAre;

/// What a strategy has seen and answered.
struct Talk {
  std::vector<Sighting> seen;
  std::vector<Action> answers;
};

/// Notes what another strategy sees and answers.
class Noted final : public Strategy {
 public:
  Noted(std::unique_ptr<Strategy> mouse, Talk& talk) : mouse_(std::move(mouse)), talk_(talk) {}
  Action decide(const Sighting& seen) override {
    talk_.seen.push_back(seen);
    talk_.answers.push_back(mouse_->decide(seen));
    return talk_.answers.back();
  }
  const Knowledge& knowledge() const override { return mouse_->knowledge(); }

 private:
  std::unique_ptr<Strategy> mouse_;
  Talk& talk_;
};

/// Gives these answers, then forfeits.
class Answers final : public Strategy {
 public:
  explicit Answers(std::vector<Action> answers) : answers_(std::move(answers)), knowledge_({1, 1}) {}
  Action decide(const Sighting&) override {
    return next_ < answers_.size() ? answers_[next_++] : Action::forfeit(ForfeitReason::finished);
  }
  const Knowledge& knowledge() const override { return knowledge_; }

 private:
  std::vector<Action> answers_;
  std::size_t next_ = 0;
  Knowledge knowledge_;
};

DriveRules rules() { return find_rules("all-japan").rules; }

Briefing near_sighted(const Maze& maze) {
  static const auto model = test::drive_model("kerise");
  Briefing briefing = brief(maze, rules(), *model, 1);
  briefing.sight = 1;
  return briefing;
}

std::unique_ptr<Strategy> in_steps(const char* mouse, const Maze& maze) {
  const BuiltinMouse& entry = *find_mouse(mouse);
  return entry.make(brief(maze, Rules(), 1), Settings(entry.parameters));
}

DrivenSteps driven(const Maze& maze, std::unique_ptr<Strategy> mouse, Talk& talk) {
  return {near_sighted(maze), maze.open_walls(), std::make_unique<Noted>(std::move(mouse), talk)};
}

/// The readings and answers up to the reset in the world of steps.
Talk talk_in_steps(const char* name, const Maze& maze) {
  Talk talk;
  Noted noted(in_steps(name, maze), talk);
  run(maze, Rules(), noted);
  std::size_t end = 0;
  while (end < talk.answers.size() && talk.answers[end].kind == Action::Kind::step) ++end;
  talk.answers.resize(std::min(end + 1, talk.answers.size()));
  talk.seen.resize(talk.answers.size());
  return talk;
}

TEST(DrivenSteps, SeesAndDecidesInSecondsAsInSteps) {
  const auto model = test::drive_model("kerise");
  Rng rng(5);
  for (int i = 0; i < 30; ++i) {
    const Maze maze = test::any_maze(rng, 12);
    for (const char* name : {"flood", "certify", "two-way", "phases"}) {
      SCOPED_TRACE(name + test::drawing_of(maze));
      Talk talk;
      DrivenSteps mouse = driven(maze, in_steps(name, maze), talk);
      const DriveRecord record = drive(maze, rules(), *model, mouse);
      const Talk steps = talk_in_steps(name, maze);
      ASSERT_LE(talk.answers.size(), steps.answers.size());
      // Time may be over first; the way home is begun before that.
      if (record.outcome == DriveOutcome::finished && talk.answers.back().kind == Action::Kind::reset) {
        ASSERT_EQ(talk.answers.size(), steps.answers.size());
      }
      for (std::size_t step = 0; step < talk.answers.size(); ++step) {
        ASSERT_EQ(talk.seen[step], steps.seen[step]) << step;
        ASSERT_EQ(talk.answers[step], steps.answers[step]) << step;
      }
    }
  }
}

TEST(DrivenSteps, FinishesWithASpeedRunByTheFastestKnownRoute) {
  const auto model = test::drive_model("kerise");
  Talk talk;
  DrivenSteps mouse = driven(test::ring(), in_steps("flood", test::ring()), talk);
  const DriveRecord record = drive(test::ring(), rules(), *model, mouse);
  EXPECT_EQ(record.outcome, DriveOutcome::finished);
  ASSERT_EQ(record.runs.size(), 3U);
  EXPECT_EQ(record.runs[1].kind, DriveRun::Kind::home);
  EXPECT_EQ(record.runs[2].kind, DriveRun::Kind::speed);
  EXPECT_EQ(record.runs[2].route.time, record.runs[2].known);
}

/// A corridor of four cells to the north, with the goal at its end.
const Maze& corridor() {
  static const Maze maze = test::drawn(R"(
    o---o---o
    | G     |
    o   o---o
    |       |
    o   o---o
    |   |   |
    o   o   o
    | S |   |
    o---o---o
  )");
  return maze;
}

Talk talk_of(std::vector<Action> answers, DriveRecord* record = nullptr) {
  const auto model = test::drive_model("kerise");
  Talk talk;
  DrivenSteps mouse = driven(corridor(), std::make_unique<Answers>(std::move(answers)), talk);
  const DriveRecord done = drive(corridor(), rules(), *model, mouse);
  if (record != nullptr) *record = done;
  return talk;
}

TEST(DrivenSteps, MovesAsInTheWorldOfSteps) {
  // Ahead is the number of open cells; a movement ends at a wall, and is cut to three cells.
  EXPECT_THAT(talk_of({Action::step(0, 9), Action::step(0, 3)}).seen,
              ElementsAre(Sighting{0, 3, 0}, Sighting{0, 0, 1}, Sighting{0, 0, 1}));
  // It turns without moving, and moves backwards with its heading kept.
  EXPECT_THAT(
      talk_of({Action::step(0, 2), Action::step(90, 0), Action::step(90, -2), Action::step(0, 1)}).seen,
      ElementsAre(Sighting{0, 3, 0}, Sighting{0, 1, 1}, Sighting{1, 1, 2}, Sighting{1, 3, 0}, Sighting{1, 2, 0}));
  // A half turn is none.
  EXPECT_THAT(talk_of({Action::step(180, 1)}).seen, ElementsAre(Sighting{0, 3, 0}, Sighting{0, 2, 0}));
}

TEST(DrivenSteps, MayResetOnlyBehindAGoal) {
  DriveRecord record;
  talk_of({Action::step(0, 1), Action::reset(), Action::step(0, 3), Action::reset()}, &record);
  EXPECT_EQ(record.outcome, DriveOutcome::finished);
  EXPECT_EQ(record.runs.back().kind, DriveRun::Kind::speed);
  // The first reset did nothing.
  EXPECT_EQ(record.runs.front().moves.size(), 3U);
}

TEST(DrivenSteps, ForfeitsWithTheReasonOfTheStrategy) {
  DriveRecord record;
  talk_of({Action::step(0, 1), Action::forfeit(ForfeitReason::hung)}, &record);
  EXPECT_EQ(record.outcome, DriveOutcome::forfeit);
  EXPECT_EQ(record.reason, ForfeitReason::hung);
}

TEST(DrivenSteps, EndsItsSearchIfItDoesNothingForEver) {
  DriveRecord record;
  std::vector<Action> answers(20'000, Action::step(90, 0));
  talk_of(answers, &record);
  EXPECT_EQ(record.reason, ForfeitReason::out_of_time);
  answers.insert(answers.begin(), Action::step(0, 3));
  talk_of(answers, &record);
  EXPECT_EQ(record.outcome, DriveOutcome::finished);
}

TEST(DrivenSteps, DrivesBackToTheCellOfTheStrategyAfterACrash) {
  // One turn in five ends in a crash, and no wall is read wrongly.
  const FailureRates rates = test::with([](FailureRatesByBrightness& some) {
    for (std::size_t level = 0; level < position_error_levels; ++level)
      test::at(some, Manoeuvre::turn, level).crash = 0.2;
  });
  const auto model = test::drive_model("kerise");
  Rng rng(9);
  int crashes = 0, finished = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Maze maze = test::any_maze(rng, 6);
    for (const MapKind map : {MapKind::first, MapKind::log_odds}) {
      SCOPED_TRACE(test::drawing_of(maze));
      PhysicalConditions conditions = test::at_errors(1.0);
      conditions.map = map;
      Talk talk;
      DrivenSteps mouse = driven(maze, in_steps("flood", maze), talk);
      const PhysicalRecord record = drive_with_failures(maze, rules(), *model, conditions, rates, seed, mouse);
      const Talk steps = talk_in_steps("flood", maze);
      crashes += record.carried;
      finished += record.drive.outcome == DriveOutcome::finished ? 1 : 0;
      // A log-odds map takes a passage in which the mouse crashed for closed.
      if (record.wrong_walls > 0) continue;
      ASSERT_LE(talk.answers.size(), steps.answers.size());
      for (std::size_t step = 0; step < talk.answers.size(); ++step) {
        ASSERT_EQ(talk.seen[step], steps.seen[step]) << step;
        ASSERT_EQ(talk.answers[step], steps.answers[step]) << step;
      }
    }
  }
  EXPECT_GT(crashes, 20);
  EXPECT_GT(finished, 20);
}

/// A mouse with a log-odds map, driven by hand through corridor().
class ByHand {
 public:
  explicit ByHand(std::vector<Action> answers)
      : map_(corridor().size(), MapKind::log_odds),
        mouse_(near_sighted(corridor()), corridor().open_walls(), std::make_unique<Answers>(std::move(answers))) {}

  /// Reads the walls of a cell, and asks there.
  Action ask(Cell cell) {
    for (const Heading side : all_headings)
      if (const Wall wall = wall_at(cell, side); !on_border(wall, corridor().size()))
        map_.add(wall, corridor().is_open(cell, side) ? -LogOddsMap::most : LogOddsMap::most);
    return mouse_.consider(map_, {{cell, Heading::north}, cell == corridor().start()}, time_ += 1000);
  }
  /// After a crash, when its map has lost that wall.
  Action ask_at_the_start_without(Wall lost) {
    mouse_.carried(time_ += 1000);
    map_.forget(lost);
    return mouse_.consider(map_, {{corridor().start(), Heading::north}, true}, time_ += 1000);
  }

 private:
  LogOddsMap map_;
  DrivenSteps mouse_;
  std::int64_t time_ = 0;
};

TEST(DrivenSteps, LooksForTheWayBackThatItsMapHasLost) {
  ByHand mouse({Action::step(0, 1), Action::step(0, 1), Action::step(0, 1)});
  mouse.ask({0, 0});
  mouse.ask({0, 1});
  mouse.ask({0, 2});
  EXPECT_EQ(mouse.ask_at_the_start_without(wall_at({0, 1}, Heading::north)).kind, Action::Kind::step);
}

TEST(DrivenSteps, GoesToTheGoalAgainIfItsMapHasLostTheRoute) {
  ByHand mouse({Action::step(0, 1), Action::step(0, 1), Action::step(0, 1), Action::reset()});
  mouse.ask({0, 0});
  mouse.ask({0, 1});
  mouse.ask({0, 2});
  EXPECT_EQ(mouse.ask({0, 3}), Action::reset());
  EXPECT_EQ(mouse.ask_at_the_start_without(wall_at({0, 1}, Heading::north)).kind, Action::Kind::step);
}

}  // namespace
}  // namespace labmouse
