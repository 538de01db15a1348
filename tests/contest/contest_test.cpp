// A contest that goes on an action at a time, beside the one that runs to its end.
#include "labmouse/contest/contest.hpp"

#include <gtest/gtest.h>

#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

Maze corner() {
  return test::drawn(R"(
      o---o---o---o
      |       | G |
      o   o---o   o
      | S         |
      o---o---o---o
  )");
}

const std::vector<Action> actions = {
    Action::step(0, 3), Action::reset(),     Action::step(90, 0), Action::step(90, 1), Action::step(0, -1),
    Action::step(0, 1), Action::step(0, 1),  Action::step(90, 1), Action::step(90, 2), Action::step(-90, 1),
    Action::reset(),    Action::step(90, 2), Action::step(-90, 1)};

RunRecord in_pieces(const Maze& maze, const Rules& rules) {
  Contest contest(maze, rules);
  for (std::size_t next = 0; !contest.ended(); ++next)
    contest.act(next < actions.size() ? actions[next] : Action::forfeit(ForfeitReason::finished));
  return contest.take_record();
}

TEST(Contest, IsTheSameInPieces) {
  const Maze maze = corner();
  for (const int budget : {1, 4, 10, 12, 13, 1000}) {
    Rules rules;
    rules.budget = budget;
    Script mouse(maze.size(), actions);
    EXPECT_EQ(in_pieces(maze, rules), run(maze, rules, mouse)) << budget;
  }
}

TEST(Contest, ShowsWhatIsReadBeforeEachAction) {
  const Maze maze = corner();
  Contest contest(maze, Rules());
  EXPECT_EQ(contest.sighting(), (Sighting{0, 1, 2}));
  contest.act(Action::step(90, 2));
  EXPECT_EQ(contest.sighting(), (Sighting{1, 0, 0}));
  EXPECT_EQ(contest.record().steps.back().sighting, (Sighting{0, 1, 2}));
  EXPECT_FALSE(contest.ended());
}

TEST(Contest, WithoutStepsHasEnded) {
  const Maze maze = corner();
  Rules rules;
  rules.budget = 0;
  const Contest contest(maze, rules);
  EXPECT_TRUE(contest.ended());
  EXPECT_EQ(contest.record().outcome, Outcome::out_of_steps);
}

}  // namespace
}  // namespace labmouse
