#include <gtest/gtest.h>

#include "labmouse/mouse/near_walls.hpp"
#include "labmouse/mouse/textbook_search.hpp"
#include "labmouse/mouse/visits.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/strategies/wanderers.hpp"

namespace labmouse {
namespace {

/// Runs that ended well, of ten.
std::vector<RunRecord> solved_runs(const Maze& maze, std::string_view search) {
  std::vector<RunRecord> runs;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    RunRecord record = test::wander(visit_counter_mouse, maze, seed, {{"search", search}});
    if (record.outcome == Outcome::solved) runs.push_back(std::move(record));
  }
  EXPECT_FALSE(runs.empty());
  return runs;
}

TEST(VisitCounter, GoesToTheNeighbourThatWasVisitedLeast) {
  const Maze maze = test::wandering_ground();
  Visits visits(maze.size());
  for (const StepRecord& step : test::wander(visit_counter_mouse, maze, 1, {{"random_share", "0"}}, 300).steps) {
    if (step.action.kind == Action::Kind::reset) break;
    visits.add(step.pose.cell);
    if (step.sighting == Sighting{0, 0, 0}) {
      ASSERT_EQ(step.action, Action::step(90, 0));
      continue;
    }
    ASSERT_EQ(step.action.movement, 1);
    const Cell next = after(step.pose, step.action).cell;
    for (const int quarters : {-1, 0, 1})
      if (step.sighting.towards(quarters) > 0) {
        ASSERT_LE(visits.of(next), visits.of(neighbour(step.pose.cell, turned(step.pose.heading, quarters))));
      }
  }
}

TEST(VisitCounter, AmongEquallyVisitedNeighboursTakesTheFirstOfItsOrder) {
  const Maze open = Maze(MazeDraft({5, 5}, MazeDraft::Inside::open)).with_start({2, 2}, Heading::north);
  const auto first = [&](const char* ties) {
    return test::wander(visit_counter_mouse, open, 1, {{"random_share", "0"}, {"ties", ties}}).steps.front().action;
  };
  EXPECT_EQ(first("nesw"), Action::step(0, 1));
  EXPECT_EQ(first("swen"), Action::step(-90, 1));  // south is behind
  EXPECT_EQ(first("ralb"), Action::step(90, 1));
}

TEST(VisitCounter, MovesAtRandomAsOftenAsItIsTold) {
  // Only a random step stands still outside of a dead end, or goes more than a cell.
  const Maze maze = test::wandering_ground();
  const auto random_steps = [&](const char* share) {
    int count = 0;
    const RunRecord record = test::wander(visit_counter_mouse, maze, 1, {{"random_share", share}, {"coverage", "1"}});
    for (const StepRecord& step : record.steps)
      count += step.run == Run::exploration && step.sighting != Sighting{0, 0, 0} &&
               step.action.kind == Action::Kind::step && step.action.movement != 1;
    return count;
  };
  EXPECT_EQ(random_steps("0"), 0);
  EXPECT_GT(random_steps("0.2"), 5);
  // With nothing but chance it is random-move; one throw a step decides on that.
  int stays = 0, steps = 0;
  for (const StepRecord& step : test::wander(visit_counter_mouse, maze, 1, {{"random_share", "1"}}).steps) {
    if (step.run == Run::speed) break;
    ++steps;
    stays += step.action.movement == 0;
  }
  EXPECT_GT(stays, steps / 3);
}

TEST(VisitCounter, NeverRunsIntoAWall) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const StepRecord& step : test::wander(visit_counter_mouse, test::wandering_ground(seed), seed).steps)
      ASSERT_FALSE(step.blocked);
}

TEST(VisitCounter, ResetsAfterTheGoalAtItsCoverage) {
  const Maze maze = test::wandering_ground();
  for (const char* coverage : {"0", "0.5", "0.8333", "1"}) {
    const RunRecord record = test::wander(visit_counter_mouse, maze, 1, {{"coverage", coverage}});
    EXPECT_EQ(record.outcome, Outcome::solved);
    test::expect_reset_at_coverage(maze, record, std::stod(coverage));
  }
}

TEST(VisitCounter, RacesOnlyWhereItWasAndWhatLiesBetween) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const char* search : {"breadth-first", "a-star", "dijkstra"})
      test::expect_speed_run_over_near_walls(test::wander(visit_counter_mouse, test::wandering_ground(seed), seed,
                                                          {{"search", search}, {"coverage", "0.3"}}));
}

TEST(VisitCounter, PlansOnTheWallsNextToItAndCountsTheSearch) {
  const Maze maze = test::capstone_maze(1).value();
  for (const std::string_view method : {"breadth-first", "a-star", "dijkstra"})
    for (const RunRecord& record : solved_runs(maze, method)) {
      NearWalls walls(maze.start());
      std::vector<Action> raced;
      for (const StepRecord& step : record.steps) {
        if (step.run == Run::exploration) walls.arrive(step.pose, step.sighting);
        if (step.run == Run::speed) raced.push_back(step.action);
      }
      TextbookSearch search(maze.size(), search_method(method), TieOrder("esnw"));
      ASSERT_TRUE(search.search(walls.open(), {maze.start(), maze.start_heading()}, maze.goals()));
      std::vector<Move> moves;
      merge_strides(search.way(), 3, moves);
      EXPECT_EQ(raced.size(), moves.size());
      EXPECT_EQ(record.counts,
                (std::vector<Count>{{"nodes expanded", search.expanded()}, {"nodes found", search.found()}}));
    }
}

TEST(VisitCounter, CountsNothingBeforeItsSpeedRun) {
  EXPECT_TRUE(test::wander(visit_counter_mouse, test::wandering_ground(), 1, {}, 10).counts.empty());
}

TEST(VisitCounter, CoversFiveSixthsOfTestMaze1WithinTheBudget) {
  // Reported: always, in 565 steps.
  const Maze maze = test::capstone_maze(1).value();
  int solved = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
    solved += test::wander(visit_counter_mouse, maze, seed, {}, Rules().budget).outcome == Outcome::solved;
  EXPECT_GE(solved, 97);
}

}  // namespace
}  // namespace labmouse
