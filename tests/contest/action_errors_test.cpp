#include "labmouse/contest/action_errors.hpp"

#include <gtest/gtest.h>

#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

/// Five cells in a row, the start heading north and the goal at the other end.
Maze row() {
  return test::drawn(R"(
      o---o---o---o---o---o
      | S               G |
      o---o---o---o---o---o
  )");
}

/// The action errors of a mouse with these actions, which then gives up.
ActionErrors after(std::vector<Action> actions, const Rules& rules = {}) {
  Script script({5, 1}, std::move(actions));
  return action_errors_of(run(row(), rules, script), rules);
}

TEST(ActionErrors, AMouseWhoseStepsArePerformedHasNone) {
  EXPECT_EQ(after({}), ActionErrors());
  EXPECT_EQ(after({Action::step(90, 3), Action::step(90, 0), Action::step(-90, 1), Action::reset(), Action::step(90, 3),
                   Action::step(0, 1)}),
            ActionErrors());
  EXPECT_EQ(after({Action::step(90, 3), Action::step(0, -3)}), ActionErrors());
}

TEST(ActionErrors, CountBlockedStepsFromTheFirst) {
  const ActionErrors found = after({Action::step(90, 3), Action::step(0, 2), Action::step(-90, 1), Action::step(0, 0)});
  EXPECT_EQ(found.blocked, (ActionErrorCount{2, 2}));
  EXPECT_EQ(found.void_rotations, ActionErrorCount());
  EXPECT_EQ(found.cut_movements, ActionErrorCount());
}

TEST(ActionErrors, CountRotationsThatTurnNothing) {
  EXPECT_EQ(after({Action::step(0, 0), Action::step(180, 0), Action::step(-90, 0), Action::step(1, 0),
                   Action::step(-180, 0), Action::step(270, 0)})
                .void_rotations,
            (ActionErrorCount{4, 2}));
}

TEST(ActionErrors, CountMovementsBeyondTheStrideOfTheRules) {
  const std::vector<Action> actions = {Action::step(90, 2), Action::step(0, -2), Action::step(0, 4),
                                       Action::step(0, -4)};
  EXPECT_EQ(after(actions).cut_movements, (ActionErrorCount{2, 3}));
  Rules shorter, longer;
  shorter.stride = 1;
  longer.stride = 4;
  EXPECT_EQ(after(actions, shorter).cut_movements, (ActionErrorCount{4, 1}));
  EXPECT_EQ(after(actions, longer).cut_movements, ActionErrorCount());
}

TEST(ActionErrors, AStepCanBeOfSeveralKinds) {
  const ActionErrors found = after({Action::step(45, 9)});
  EXPECT_EQ(found, (ActionErrors{{1, 1}, {1, 1}, {1, 1}, {}}));
}

TEST(ActionErrors, CountResetsThatDoNothing) {
  const std::vector<Action> actions = {Action::step(90, 3), Action::reset(), Action::step(0, 1),
                                       Action::reset(),     Action::reset(), Action::reset()};
  EXPECT_EQ(after(actions).idle_resets, (ActionErrorCount{3, 2}));
  EXPECT_EQ(after({Action::reset()}).idle_resets, (ActionErrorCount{1, 1}));
}

TEST(ActionErrors, AResetInTheLastStepIsIdleOnlyWhereNoGoalWasEntered) {
  Rules rules;
  rules.budget = 3;
  EXPECT_EQ(after({Action::step(90, 3), Action::step(0, 1), Action::reset()}, rules).idle_resets, ActionErrorCount());
  EXPECT_EQ(after({Action::step(90, 3), Action::step(0, 0), Action::reset()}, rules).idle_resets,
            (ActionErrorCount{1, 3}));
  rules.budget = 4;
  EXPECT_EQ(after({Action::step(90, 3), Action::step(0, 1), Action::reset(), Action::reset()}, rules).idle_resets,
            (ActionErrorCount{1, 4}));
}

/// The hits of a mouse with these actions in a maze with a bend: from the start two cells north, then one east.
int hits_after(std::vector<Action> actions) {
  const Maze bend = test::drawn(R"(
      o---o---o
      |     G |
      o   o---o
      |       |
      o   o---o
      | S     |
      o---o---o
  )");
  Script script({2, 3}, std::move(actions));
  const RunRecord record = run(bend, {}, script);
  return known_wall_hits(record, bend.size());
}

TEST(KnownWallHits, CountStepsIntoWallsThatWereSeen) {
  EXPECT_EQ(hits_after({Action::step(0, 2), Action::step(90, 1)}), 0);
  EXPECT_EQ(hits_after({Action::step(0, 3)}), 1);
  EXPECT_EQ(hits_after({Action::step(-90, 1), Action::step(0, 1)}), 2);
  EXPECT_EQ(hits_after({Action::step(0, 3), Action::step(90, 2)}), 2);
}

TEST(KnownWallHits, CountTheBorderBehindAMouse) { EXPECT_EQ(hits_after({Action::step(0, -1)}), 1); }

TEST(KnownWallHits, LeaveOutWallsThatTheMouseHasNotSeen) {
  const Maze above = test::drawn(R"(
      o---o---o
      | S   G |
      o---o---o
      |       |
      o---o---o
  )");
  const auto hits = [&](std::vector<Action> actions) {
    Script script({2, 2}, std::move(actions));
    return known_wall_hits(run(above, {}, script), above.size());
  };
  EXPECT_EQ(hits({Action::step(0, -1)}), 0);
  // Once it looks east, the wall is on its right.
  EXPECT_EQ(hits({Action::step(90, 0), Action::step(90, 1)}), 1);
  EXPECT_EQ(hits({Action::step(90, 0), Action::step(-90, -1)}), 1);
}

TEST(ActionErrors, AResetOrAForfeitHasNoRotation) {
  EXPECT_FALSE(has_void_rotation(Action::reset()));
  EXPECT_FALSE(has_void_rotation({Action::Kind::forfeit, 45, 9, ForfeitReason::no_route}));
  EXPECT_TRUE(has_void_rotation(Action::step(91, 0)));
  for (const int degrees : {-90, 0, 90}) EXPECT_FALSE(has_void_rotation(Action::step(degrees, 0)));
}

}  // namespace
}  // namespace labmouse
