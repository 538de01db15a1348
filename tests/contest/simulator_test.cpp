#include "labmouse/contest/simulator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <climits>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/script.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {

// Found by GoogleTest when it shows values.
void PrintTo(const Pose& pose, std::ostream* out) {
  *out << '(' << int{pose.cell.x} << ',' << int{pose.cell.y} << ") " << name_of(pose.heading);
}
void PrintTo(const Sighting& seen, std::ostream* out) { *out << seen.left << ' ' << seen.ahead << ' ' << seen.right; }
void PrintTo(Outcome outcome, std::ostream* out) { *out << name_of(outcome); }

namespace {

Action go(int cells) { return Action::step(0, cells); }
Action turn(int degrees, int cells = 0) { return Action::step(degrees, cells); }
const Action reset = Action::reset();

Pose at(int x, int y, Heading heading) { return {{x, y}, heading}; }
Pose east_at(int x) { return at(x, 0, Heading::east); }

/// A contest in which the mouse plays a prepared list and forfeits at its end.
class Played : public testing::Test {
 protected:
  explicit Played(Maze maze) : maze_(std::move(maze)) {}

  void play(const std::vector<Action>& actions) {
    Script mouse(maze_.size(), actions);
    record_ = run(maze_, rules_, mouse);
  }
  void play_for(int steps, const Action& action) { play(std::vector<Action>(static_cast<std::size_t>(steps), action)); }

  const StepRecord& step(int clock) const { return record_.steps.at(static_cast<std::size_t>(clock) - 1); }
  int steps() const { return static_cast<int>(record_.steps.size()); }
  Pose stands() const { return record_.end; }
  Outcome outcome() const { return record_.outcome; }
  Score score() const { return labmouse::score(record_, rules_); }

  Maze maze_;
  Rules rules_;
  RunRecord record_;
};

/// Seven cells in a row; the mouse looks along it.
class InACorridor : public Played {
 protected:
  InACorridor()
      : Played(test::drawn(R"(
          o---o---o---o---o---o---o---o
          | S               G         |
          o---o---o---o---o---o---o---o
        )")
                   .with_start({0, 0}, Heading::east)) {}
};

TEST_F(InACorridor, AStepMovesUpToThreeCells) {
  for (const int cells : {0, 1, 2, 3}) {
    play({go(cells)});
    EXPECT_EQ(stands(), east_at(cells));
    EXPECT_FALSE(step(1).blocked);
  }
}

TEST_F(InACorridor, ALongerMovementIsCutToThree) {
  for (const int cells : {4, 5, 1000, INT_MAX}) {
    play({go(cells)});
    EXPECT_EQ(stands(), east_at(3));
    EXPECT_FALSE(step(1).blocked);
  }
}

TEST_F(InACorridor, BackwardsKeepsTheHeading) {
  play({go(3), go(-2)});
  EXPECT_EQ(stands(), east_at(1));
}

TEST_F(InACorridor, ALongerMovementBackwardsIsCutToThree) {
  for (const int cells : {-4, -1000, INT_MIN}) {
    play({go(3), go(2), go(cells)});
    EXPECT_EQ(stands(), east_at(2));
    EXPECT_FALSE(step(3).blocked);
  }
}

TEST_F(InACorridor, MovementStopsAtAWallAndIsBlocked) {
  play({go(3), go(2), go(3)});
  EXPECT_EQ(stands(), east_at(6));
  EXPECT_TRUE(step(3).blocked);
}

TEST_F(InACorridor, MovementThatEndsAtAWallIsNotBlocked) {
  play({go(3), go(3)});
  EXPECT_EQ(stands(), east_at(6));
  EXPECT_FALSE(step(2).blocked);
}

TEST_F(InACorridor, BackwardsStopsAtAWallToo) {
  play({go(1), go(-3)});
  EXPECT_EQ(stands(), east_at(0));
  EXPECT_TRUE(step(2).blocked);
}

TEST_F(InACorridor, QuarterTurnsArePerformed) {
  play({turn(90)});
  EXPECT_EQ(stands(), at(0, 0, Heading::south));
  play({turn(-90)});
  EXPECT_EQ(stands(), at(0, 0, Heading::north));
}

TEST_F(InACorridor, AnotherRotationIsNotPerformedButTheMovementIs) {
  for (const int degrees : {1, 45, -45, 89, 91, 180, -180, 270, -270, 360, INT_MAX, INT_MIN}) {
    play({turn(degrees, 2)});
    EXPECT_EQ(stands(), east_at(2)) << degrees;
    EXPECT_FALSE(step(1).blocked);
  }
}

TEST_F(InACorridor, TheActionIsRecordedAsAsked) {
  play({turn(45, 1000)});
  EXPECT_EQ(step(1).action, turn(45, 1000));
}

TEST_F(InACorridor, TheTurnComesBeforeTheMovement) {
  play({go(3), turn(90, 2)});
  EXPECT_EQ(stands(), at(3, 0, Heading::south));
  EXPECT_TRUE(step(2).blocked);
}

TEST_F(InACorridor, AStepThatEndsInTheGoalAllowsTheReset) {
  play({go(3), go(1), reset});
  EXPECT_EQ(stands(), east_at(0));
  EXPECT_EQ(step(4).run, Run::speed);
}

TEST_F(InACorridor, PassingThroughTheGoalDoesNotCount) {
  play({go(3), go(3), reset});
  EXPECT_EQ(stands(), east_at(6));
  EXPECT_EQ(step(4).run, Run::search_run);
}

TEST_F(InACorridor, PassingThroughTheGoalDoesNotEndTheSpeedRun) {
  play({go(3), go(1), reset, go(3), go(3), go(-2)});
  EXPECT_EQ(outcome(), Outcome::finished);
  EXPECT_EQ(score().speed_steps, 3);
}

TEST_F(InACorridor, TheGoalMayBeLeftBeforeTheReset) {
  play({go(3), go(1), go(2), reset});
  EXPECT_EQ(stands(), east_at(0));
}

TEST_F(InACorridor, AResetBeforeTheGoalCostsAStepAndDoesNothing) {
  play({go(2), reset, go(2), reset, go(2), go(2)});
  EXPECT_EQ(step(3).pose, east_at(2));
  EXPECT_EQ(step(3).run, Run::search_run);
  EXPECT_EQ(outcome(), Outcome::finished);
  EXPECT_EQ(score().search_steps, 4);
}

TEST_F(InACorridor, AResetInTheSpeedRunCostsAStepAndDoesNothing) {
  play({go(2), go(2), reset, go(2), reset, go(2)});
  EXPECT_EQ(step(6).pose, east_at(2));
  EXPECT_EQ(outcome(), Outcome::finished);
  EXPECT_EQ(score().speed_steps, 3);
}

TEST_F(InACorridor, TheResetsOwnStepBelongsToTheExploration) {
  play({go(3), go(1), reset, go(3), go(1)});
  EXPECT_EQ(step(3).run, Run::search_run);
  EXPECT_EQ(score().search_steps, 3);
  EXPECT_EQ(score().speed_steps, 2);
}

TEST_F(InACorridor, TheResetRestoresTheStartHeading) {
  play({go(3), go(1), turn(90), turn(90), reset});
  EXPECT_EQ(stands(), east_at(0));
}

TEST_F(InACorridor, TheFirstReadingOfTheSpeedRunIsMadeAtTheStart) {
  play({go(3), go(1), reset});
  EXPECT_EQ(step(4).pose, east_at(0));
  EXPECT_EQ(step(4).sighting, (Sighting{0, 6, 0}));
}

TEST_F(InACorridor, TheSpeedRunEndsWithTheStepThatEndsInTheGoal) {
  play({go(3), go(1), reset, go(3), go(1), go(1), go(1)});
  EXPECT_EQ(outcome(), Outcome::finished);
  EXPECT_EQ(steps(), 5);
  EXPECT_EQ(stands(), east_at(4));
}

TEST_F(InACorridor, TheClockCountsOverBothRuns) {
  play({go(3), go(1), reset, go(3), go(1)});
  for (int clock = 1; clock <= 5; ++clock) EXPECT_EQ(step(clock).step, clock);
}

TEST_F(InACorridor, TurningOnTheSpotInTheGoalCounts) {
  maze_ = maze_.with_start({4, 0}, Heading::east);
  play({turn(90), reset, turn(-90)});
  EXPECT_EQ(outcome(), Outcome::finished);
}

TEST_F(InACorridor, StartingInTheGoalIsNotEnteringIt) {
  maze_ = maze_.with_start({4, 0}, Heading::east);
  play({reset, reset});
  EXPECT_EQ(step(3).run, Run::search_run);
}

TEST_F(InACorridor, AThousandStepsAreAllowed) {
  std::vector<Action> actions(995, go(0));
  actions.insert(actions.end(), {go(3), go(1), reset, go(3), go(1)});
  play(actions);
  EXPECT_EQ(outcome(), Outcome::finished);
  EXPECT_EQ(steps(), 1000);
}

TEST_F(InACorridor, TheStepAfterTheThousandthIsNotMade) {
  std::vector<Action> actions(996, go(0));
  actions.insert(actions.end(), {go(3), go(1), reset, go(3), go(1)});
  play(actions);
  EXPECT_EQ(outcome(), Outcome::speed_run_unfinished);
  EXPECT_EQ(steps(), 1000);
  EXPECT_EQ(score().value, std::nullopt);
}

TEST_F(InACorridor, OutOfStepsWhereTheGoalWasNeverEntered) {
  play_for(2000, go(0));
  EXPECT_EQ(outcome(), Outcome::out_of_steps);
  EXPECT_EQ(steps(), 1000);
}

TEST_F(InACorridor, NeverResetWhereTheGoalWasEntered) {
  maze_ = maze_.with_start({4, 0}, Heading::east);
  play_for(2000, go(0));
  EXPECT_EQ(outcome(), Outcome::never_reset);
}

TEST_F(InACorridor, AResetWithTheLastStepLeavesASpeedRunUnfinished) {
  rules_.budget = 3;
  play({go(3), go(1), reset});
  EXPECT_EQ(outcome(), Outcome::speed_run_unfinished);
  EXPECT_EQ(stands(), east_at(0));
}

TEST_F(InACorridor, AForfeitEndsTheContestWithItsReason) {
  play({go(1), Action::forfeit(ForfeitReason::lost), go(1)});
  EXPECT_EQ(outcome(), Outcome::forfeit);
  EXPECT_EQ(step(2).action.reason, ForfeitReason::lost);
  EXPECT_EQ(steps(), 2);
  EXPECT_EQ(stands(), east_at(1));
}

TEST_F(InACorridor, BudgetAndStrideAreFieldsOfTheRules) {
  rules_.budget = 2;
  rules_.stride = 5;
  play({go(7), go(-7), go(1)});
  EXPECT_EQ(step(2).pose, east_at(5));
  EXPECT_EQ(steps(), 2);
}

/// A place with something to see on every side.
class AtACrossing : public Played {
 protected:
  AtACrossing()
      : Played(test::drawn(R"(
          o---o---o---o---o---o
          |     G |           |
          o   o---o   o---o---o
          |                   |
          o---o   o---o   o---o
          |     S             |
          o   o---o---o---o   o
          |                   |
          o---o---o---o---o---o
        )")) {}
};

TEST_F(AtACrossing, AReadingCountsOpenCellsLeftAheadAndRight) {
  EXPECT_EQ(look(maze_, at(1, 1, Heading::north)), (Sighting{1, 1, 3}));
  EXPECT_EQ(look(maze_, at(1, 1, Heading::east)), (Sighting{1, 3, 0}));
  EXPECT_EQ(look(maze_, at(1, 1, Heading::south)), (Sighting{3, 0, 1}));
  EXPECT_EQ(look(maze_, at(1, 1, Heading::west)), (Sighting{0, 1, 1}));
}

TEST_F(AtACrossing, EachStepIsRecordedWithPoseReadingAndAction) {
  play({go(1), turn(90, 2), turn(-90, 1)});
  EXPECT_EQ(step(1), (StepRecord{Run::search_run, 1, at(1, 1, Heading::north), {1, 1, 3}, go(1), false}));
  EXPECT_EQ(step(2), (StepRecord{Run::search_run, 2, at(1, 2, Heading::north), {1, 0, 3}, turn(90, 2), false}));
  EXPECT_EQ(step(3), (StepRecord{Run::search_run, 3, at(3, 2, Heading::east), {0, 1, 1}, turn(-90, 1), true}));
}

TEST_F(AtACrossing, TheBriefingTellsAllButTheWalls) {
  rules_.stride = 2;
  rules_.budget = 500;
  const Briefing told = brief(maze_, rules_, 7);
  EXPECT_EQ(told.size, (Size{5, 4}));
  EXPECT_EQ(told.start, at(1, 1, Heading::north));
  EXPECT_EQ(told.goals, maze_.goals());
  EXPECT_EQ(told.motion, strides(2));
  EXPECT_EQ(told.budget, 500);
  EXPECT_EQ(told.seed, 7U);
}

TEST(Scoring, AThirtiethOfTheExplorationIsAdded) {
  EXPECT_DOUBLE_EQ(score_of(18, 17, Rules()), 17.6);
  EXPECT_DOUBLE_EQ(score_of(30, 10, Rules()), 11.0);
}

TEST(Scoring, TheFactorIsAFieldOfTheRules) {
  Rules rules;
  rules.search_factor = 4;
  EXPECT_DOUBLE_EQ(score_of(10, 1, rules), 3.5);
}

TEST_F(InACorridor, AFinishedContestScores) {
  play({go(3), go(1), reset, go(3), go(1)});
  EXPECT_DOUBLE_EQ(score().value.value(), 2.1);
}

TEST_F(InACorridor, AFailedContestHasNoScoreButItsStepsAreCounted) {
  play({go(3), go(1), reset, go(3)});
  EXPECT_EQ(score().outcome, Outcome::forfeit);
  EXPECT_EQ(score().value, std::nullopt);
  EXPECT_EQ(score().search_steps, 3);
  EXPECT_EQ(score().speed_steps, 2);
}

/// Stays where it is and counts how often it was asked.
class Counting final : public Strategy {
 public:
  explicit Counting(Size size) : knowledge_(size) {}

  Action decide(const Sighting&) override {
    ++counters_[0].value;
    return go(0);
  }
  const Knowledge& knowledge() const override { return knowledge_; }
  StrategyReport report() override { return {.counters = counters_}; }

 private:
  Knowledge knowledge_;
  std::array<Counter, 2> counters_ = {Counter{"questions", 0}, Counter{"answers", 42}};
};

TEST(Counts, AreThoseOfTheMouseAtTheEndSortedByName) {
  const Maze maze(MazeDraft({3, 3}, MazeDraft::Inside::open));
  Counting mouse(maze.size());
  Rules rules;
  rules.budget = 7;
  EXPECT_EQ(run(maze, rules, mouse).counts, (std::vector<Count>{{"answers", 42}, {"questions", 7}}));
}

/// Goes on and has a reason in every second step, whether it was asked to keep them or not; forfeits in the end.
class Reasoning final : public Strategy {
 public:
  explicit Reasoning(Size size) : knowledge_(size) {}

  Action decide(const Sighting&) override {
    reasons_.known = ++step_;
    return step_ < 5 ? go(1) : Action::forfeit(ForfeitReason::lost);
  }
  const Knowledge& knowledge() const override { return knowledge_; }
  const Reasons* reasons() const override { return step_ % 2 == 1 ? &reasons_ : nullptr; }

 private:
  Knowledge knowledge_;
  Reasons reasons_;
  int step_ = 0;
};

TEST_F(InACorridor, ReasonsAreThoseOfTheStepsThatHaveSome) {
  Reasoning mouse(maze_.size());
  record_ = run(maze_, rules_, mouse);
  ASSERT_EQ(record_.reasons.size(), 3U);
  for (unsigned i = 0; i < 3; ++i) {
    EXPECT_EQ(record_.reasons[i].step, 1 + 2 * static_cast<int>(i));
    EXPECT_EQ(record_.reasons[i].reasons.known, record_.reasons[i].step);
  }
}

TEST_F(InACorridor, AMouseWithoutReasonsLeavesNone) {
  play({go(3), go(1), reset, go(3), go(1)});
  EXPECT_TRUE(record_.reasons.empty());
}

}  // namespace
}  // namespace labmouse
