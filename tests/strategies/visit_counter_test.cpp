#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "labmouse/mouse/textbook_search.hpp"
#include "labmouse/mouse/visits.hpp"
#include "labmouse/mouse/walked_passages.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/strategies/wanderers.hpp"

namespace labmouse {
namespace {

/// Counts as the report's mouse does, and says what it chooses where chance plays no part.
class Recount {
 public:
  explicit Recount(Size size) : size_(size), visits_(size) {}

  void arrive(Cell cell) { visits_.add(cell); }

  /// The turn that the mouse chooses; nothing where its table hides all that is free.
  std::optional<int> choice(const StepRecord& step) const {
    std::map<int, int> side_with;  // by count; the last of left, ahead, right stays
    std::multiset<int> counts;
    for (const int quarters : {-1, 0, 1}) {
      const Cell cell = neighbour(step.pose.cell, turned(step.pose.heading, quarters));
      const int count = size_.contains(cell) ? visits_.of(cell) : 1'000'000;
      side_with[count] = quarters;
      counts.insert(count);
    }
    const auto least = counts.begin();
    const int side = side_with.at(*least);
    if (step.sighting.towards(side) > 0) return side;
    if (counts.count(*least) > 1) return std::nullopt;
    const int next = *std::next(least);
    const int other = side_with.at(next);
    if (step.sighting.towards(other) > 0) return other;
    if (counts.count(next) > 1) return std::nullopt;
    return side_with.at(*std::prev(counts.end()));
  }

 private:
  Size size_;
  Visits visits_;
};

TEST(VisitCounter, GoesToTheNeighbourThatWasVisitedLeast) {
  int chosen = 0, hidden = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Maze maze = test::wandering_ground(seed);
    Recount recount(maze.size());
    test::in_search_run(test::wander(visit_counter_mouse, maze, seed, {{"random_share", "0"}, {"coverage", "1"}}, 300),
                        [&](const StepRecord& step) {
                          if (step.action.kind == Action::Kind::reset) return;
                          recount.arrive(step.pose.cell);
                          if (step.sighting == test::dead_end) {
                            ASSERT_EQ(step.action, Action::step(90, 0));
                            return;
                          }
                          ASSERT_EQ(step.action.movement, 1);
                          const std::optional<int> turn = recount.choice(step);
                          ++(turn ? chosen : hidden);
                          if (turn) {
                            ASSERT_EQ(step.action.rotation, 90 * *turn) << "step " << step.step;
                          }
                        });
  }
  EXPECT_GT(chosen, 1000);
  EXPECT_GT(hidden, 50);
}

TEST(VisitCounter, AmongEquallyVisitedNeighboursTakesTheLastOfLeftAheadAndRight) {
  const auto first = [](Heading heading, std::initializer_list<Heading> walls) {
    MazeDraft draft({5, 5}, MazeDraft::Inside::open);
    for (const Heading wall : walls) draft.close({2, 2}, wall);
    const Maze maze = Maze(draft).with_start({2, 2}, heading);
    return test::wander(visit_counter_mouse, maze, 1, {{"random_share", "0"}}, 1).steps.front().action;
  };
  EXPECT_EQ(first(Heading::north, {}), Action::step(90, 1));
  EXPECT_EQ(first(Heading::west, {}), Action::step(90, 1));
  EXPECT_EQ(first(Heading::north, {Heading::west}), Action::step(90, 1));
}

TEST(VisitCounter, LeavesASideToChanceThatHidesBehindAWall) {
  // All three sides have the same count, and the right one is behind a wall: the program picks it again and again.
  MazeDraft draft({5, 5}, MazeDraft::Inside::open);
  draft.close({2, 2}, Heading::east);
  const Maze maze = Maze(draft).with_start({2, 2}, Heading::north);
  int ahead = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const Action first = test::wander(visit_counter_mouse, maze, seed, {}, 1).steps.front().action;
    ASSERT_NE(first.rotation, 90);
    ahead += first.rotation == 0;
  }
  EXPECT_NEAR(ahead, 200, 50);
}

TEST(VisitCounter, MarksACellOnlyByChance) {
  // In the open nothing is hidden: without chance no cell is ever marked, and with nothing else all are.
  const Maze open = Maze(MazeDraft({6, 6}, MazeDraft::Inside::open)).with_start({2, 2}, Heading::north);
  const auto first_run = [&](const char* share) {
    int steps = 0;
    test::in_search_run(
        test::wander(visit_counter_mouse, open, 1, {{"random_share", share}, {"coverage", "0.3"}}, 2000),
        [&](const StepRecord&) { ++steps; });
    return steps;
  };
  EXPECT_LT(first_run("1"), first_run("0.2"));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Maze maze = test::wandering_ground(seed);
    test::expect_reset_at_coverage(
        maze, test::wander(visit_counter_mouse, maze, seed, {{"random_share", "1"}, {"coverage", "0.5"}}), 0.5);
  }
}

TEST(VisitCounter, RacesWhereItWalked) { test::expect_speed_runs_where_it_walked(visit_counter_mouse); }

/// What a search finds after the walk of a search run and one more step, where that is not {}.
std::pair<std::vector<Action>, int> planned(const Maze& maze, const RunRecord& record, std::string_view method,
                                            std::optional<int> last_turn) {
  WalkedPassages walked(maze.size(), 10'000);
  test::in_search_run(record, [&](const StepRecord& step) {
    if (step.action.movement > 0) walked.walk(step.pose.cell, after(step.pose, step.action).cell);
    if (step.action.kind == Action::Kind::reset && last_turn)
      walked.walk(step.pose.cell, neighbour(step.pose.cell, turned(step.pose.heading, *last_turn)));
  });
  TextbookSearch search(maze.size(), walked.most_edges(), search_method(method));
  EXPECT_TRUE(search.search(walked, maze.start(), maze.goals()));
  std::vector<Move> moves;
  merge_strides(search.way(), 3, moves);
  std::vector<Action> actions;
  Heading heading = maze.start_heading();
  for (const Move& move : moves) {
    actions.push_back(move_in(heading, move.direction, move.cells));
    heading = move.direction;
  }
  return {actions, search.found()};
}

TEST(VisitCounter, PlansOnWhatItWalkedAndCountsTheSearch) {
  const Maze maze = test::capstone_maze(1).value();
  for (const std::string_view method : {"breadth-first", "a-star", "dijkstra"}) {
    int finished = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const RunRecord record = test::wander(visit_counter_mouse, maze, seed, {{"search", method}, {"coverage", "0.7"}});
      if (record.outcome != Outcome::finished) continue;
      ++finished;
      std::vector<Action> raced;
      Sighting last;
      test::in_search_run(record, [&](const StepRecord& step) { last = step.sighting; });
      for (const StepRecord& step : record.steps)
        if (step.run == Run::speed) raced.push_back(step.action);
      ASSERT_EQ(record.counts.size(), 1U);
      EXPECT_EQ(record.counts.front().name, "nodes found");
      // The step that was drawn and not done is in its map: one of those that were free.
      bool as_planned = false;
      for (const int turn : {-1, 0, 1})
        if (last.towards(turn) > 0) {
          const auto [actions, found] = planned(maze, record, method, turn);
          as_planned |= actions == raced && found == record.counts.front().value;
        }
      EXPECT_TRUE(as_planned) << method << ' ' << seed;
    }
    EXPECT_GE(finished, 8);
  }
}

TEST(VisitCounter, CountsNothingBeforeItsSpeedRun) {
  EXPECT_TRUE(test::wander(visit_counter_mouse, test::wandering_ground(), 1, {}, 10).counts.empty());
}

TEST(VisitCounter, CoversFiveSixthsOfTestMaze1WithinTheBudget) {
  // Measured with the author's own program: always, in 628 steps.
  const Maze maze = test::capstone_maze(1).value();
  int finished = 0;
  double steps = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const RunRecord record = test::wander(visit_counter_mouse, maze, seed, {}, Rules().budget);
    if (record.outcome != Outcome::finished) continue;
    ++finished;
    test::in_search_run(record, [&](const StepRecord&) { ++steps; });
  }
  EXPECT_GE(finished, 195);
  EXPECT_NEAR(steps / finished, 628, 25);
}

}  // namespace
}  // namespace labmouse
