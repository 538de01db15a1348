// When a searching mouse must go home, by a clock that remembers runs and by one that does not.
#include "labmouse/mouse/drive/search_clock.hpp"

#include <gtest/gtest.h>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

/// Walls become known, and some turn over.
void learn_a_little(const Maze& maze, Knowledge& knowledge, Rng& rng) {
  for (int cells = rng.below(12); cells > 0; --cells) {
    const Cell cell = maze.size().cell_at(rng.below(maze.size().area()));
    for (const Heading heading : all_headings) {
      const Wall wall = wall_at(cell, heading);
      if (on_border(wall, maze.size())) continue;
      const bool open = maze.is_open(cell, heading) != rng.chance(1, 6);
      if (knowledge.state(wall) != WallState::unknown) knowledge.forget(wall);
      knowledge.learn(wall, open);
    }
  }
}

TEST(SearchClock, SaysTheSameWhetherItRemembersRunsOrNot) {
  Rng rng(51);
  int late = 0, early = 0;
  const DriveModel model = make_drive_model(published_robot());
  for (int round = 0; round < test::tenth(60); ++round) {
    const Maze maze = test::any_maze(rng, 8);
    DriveRules rules;
    rules.time_limit = 60'000'000;
    DriveFields fields = DriveFields::in_own_memory(maze.size(), model);
    Briefing briefing = brief(maze, rules, model, 1);
    briefing.drive.fields = &fields;
    SearchClock clock(briefing);
    Knowledge knowledge(maze.size(), 1);
    for (int all = 0; all < 12; ++all) learn_a_little(maze, knowledge, rng);
    for (int step = 0; step < 40; ++step) {
      learn_a_little(maze, knowledge, rng);
      const SearchPlace place = {{maze.size().cell_at(rng.below(maze.size().area())), maze.start_heading()}, true};
      const Action look = Action::step(90, 0);
      const auto too_late_at = [&](SearchClock& asked, std::int64_t time) {
        asked.set(time);
        return asked.is_too_late_after(look, knowledge, place);
      };
      // The last moment that is not too late, by clocks that remember nothing.
      std::int64_t before = 0, behind = rules.time_limit;
      for (int halving = 0; halving < 16; ++halving) {
        SearchClock anew(briefing);
        (too_late_at(anew, (before + behind) / 2) ? behind : before) = (before + behind) / 2;
      }
      for (const std::int64_t time : {before, behind}) {
        SearchClock anew(briefing);
        const bool too_late = too_late_at(anew, time);
        ASSERT_EQ(too_late_at(clock, time), too_late);
        ++(too_late ? late : early);
      }
    }
  }
  EXPECT_GT(late, 50);
  EXPECT_GT(early, 50);
}

}  // namespace
}  // namespace labmouse
