#include "labmouse/maze/inspect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/maze/wall_follower.hpp"
#include "tests/maze/problem_lines.hpp"
#include "tests/maze/random_maze.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;

Maze read(std::string_view drawing) { return test::maze_of(drawing_format, drawing); }

// The reason of one contest rule; "kept" when it is.
std::string rule(const Maze& maze, std::string_view name) {
  for (const RuleFinding& finding : check_contest_rules(maze)) {
    EXPECT_EQ(finding.passed, finding.reason.empty()) << finding.name;
    if (finding.name == name) return finding.passed ? "kept" : finding.reason;
  }
  return "no such rule";
}

Maze contest_maze(std::uint64_t seed) { return contest_generator.make({{16, 16}, seed, 0}); }

// A copy of the maze that can be changed.
MazeDraft draft_of(const Maze& maze) {
  MazeDraft draft(maze.size(), MazeDraft::Inside::closed);
  maze.open_walls().for_each([&](Wall wall) { draft.open(wall.cell, wall.side); });
  draft.set_start(maze.start(), maze.start_heading());
  maze.goals().for_each([&](Cell cell) { draft.add_goal(cell); });
  return draft;
}

constexpr std::string_view winding_way = R"(
o---o---o---o---o
|       |     G |
o   o   o   o---o
|   |           |
o   o---o---o---o
| S |           |
o---o---o---o---o
)";

TEST(Inspect, CountsOnlyWhatCanBeReached) {
  const auto found = inspect(read(winding_way));
  EXPECT_EQ(found.reachable.count(), 9);
  EXPECT_FALSE(found.reachable.contains({1, 0}));
  EXPECT_EQ(found.dead_ends, 3);  // start, goal, and the corner below the goal
  EXPECT_EQ(found.junctions, 1);
  EXPECT_EQ(found.loops, 0);
}

TEST(Inspect, MeasuresTheWayInCellsAndInStrides) {
  const auto found = inspect(read(winding_way));
  EXPECT_EQ(found.shortest_cells, 7);
  ASSERT_TRUE(found.shortest_strides);
  EXPECT_EQ(found.shortest_strides->strides, 6);  // 2 north, 1 east, 1 south, 1 east, 1 north, 1 east
  EXPECT_EQ(found.shortest_strides->count, 1U);
  EXPECT_EQ(inspect(read(winding_way), 1).shortest_strides->strides, 7);
}

TEST(Inspect, CountsIndependentLoops) {
  EXPECT_EQ(inspect(Maze(MazeDraft({3, 3}, MazeDraft::Inside::open))).loops, 4);
  EXPECT_EQ(inspect(Maze(MazeDraft({1, 9}, MazeDraft::Inside::open))).loops, 0);
}

TEST(Inspect, SplitsACorridorOfFourCellsInThreeWays) {
  MazeDraft draft({5, 1}, MazeDraft::Inside::open);
  draft.add_goal({4, 0});
  const auto runs = shortest_in_strides(Maze(draft));
  ASSERT_TRUE(runs);
  EXPECT_EQ(runs->strides, 2);
  EXPECT_EQ(runs->count, 3U);  // 1+3, 2+2, 3+1
}

TEST(Inspect, PassingThroughAGoalIsNoArrival) {
  MazeDraft draft({4, 2}, MazeDraft::Inside::open);
  draft.add_goal({2, 0});
  const auto runs = shortest_in_strides(Maze(draft));
  ASSERT_TRUE(runs);
  EXPECT_EQ(runs->strides, 1);
  EXPECT_EQ(runs->count, 1U);
}

TEST(Inspect, AStartInTheGoalIsOneStepAndNoCell) {
  const auto found = inspect(Maze(MazeDraft({1, 1}, MazeDraft::Inside::closed)));
  EXPECT_EQ(found.shortest_cells, 0);
  ASSERT_TRUE(found.shortest_strides);
  EXPECT_EQ(found.shortest_strides->strides, 1);
  EXPECT_EQ(found.shortest_strides->count, 1U);
  EXPECT_EQ(found.dead_ends, 0);
  EXPECT_EQ(found.loops, 0);
}

TEST(Inspect, AnUnreachableGoalHasNoDistance) {
  const auto found = inspect(Maze(MazeDraft({3, 3}, MazeDraft::Inside::closed)));
  EXPECT_EQ(found.reachable.count(), 1);
  EXPECT_FALSE(found.shortest_cells);
  EXPECT_FALSE(found.shortest_strides);
  EXPECT_FALSE(found.left_follower_arrives);
  EXPECT_FALSE(found.right_follower_arrives);
}

TEST(Inspect, TheNumberOfRunsStopsAtTheLargestNumber) {
  const Maze maze = Maze(MazeDraft({64, 64}, MazeDraft::Inside::open));
  CellSet corner;
  corner.insert({63, 63});
  // In single cells there are 126 over 63 ways, far more than 64 bits can count.
  const auto runs = shortest_in_strides(maze.with_goals(corner), 1);
  ASSERT_TRUE(runs);
  EXPECT_EQ(runs->strides, 126);
  EXPECT_EQ(runs->count, std::numeric_limits<std::uint64_t>::max());
}

TEST(WallFollower, ArrivesInAMazeWithoutLoops) {
  const Maze maze = read(R"(
o---o---o---o
|           |
o   o---o   o
|   | G     |
o   o---o---o
| S |       |
o---o---o---o
)");
  EXPECT_TRUE(wall_follower_arrives(maze, Hand::left));
  EXPECT_TRUE(wall_follower_arrives(maze, Hand::right));
}

TEST(WallFollower, CirclesAroundAnIsland) {
  const Maze room = Maze(MazeDraft({5, 5}, MazeDraft::Inside::open));
  EXPECT_FALSE(wall_follower_arrives(room, Hand::left));
  EXPECT_FALSE(wall_follower_arrives(room, Hand::right));
}

TEST(WallFollower, OneHandMayArriveWhereTheOtherDoesNot) {
  // Without a wall beside it each hand turns around a post for ever: west of the start, or east of it.
  MazeDraft draft({3, 3}, MazeDraft::Inside::open);
  draft.set_start({1, 1}, Heading::north);
  draft.add_goal({0, 1});
  EXPECT_TRUE(wall_follower_arrives(Maze(draft), Hand::left));
  EXPECT_FALSE(wall_follower_arrives(Maze(draft), Hand::right));
}

TEST(Routes, ALoopBesideTheWayIsNoSecondRoute) {
  const Maze two_ways = read(R"(
o---o---o---o---o
|             G |
o   o   o---o---o
|       |       |
o---o   o   o   o
| S |   |       |
o   o   o---o---o
|               |
o---o---o---o---o
)");
  EXPECT_TRUE(has_several_routes(two_ways));
  const Maze lollipop = read(R"(
o---o---o---o
|           |
o   o---o   o
|           |
o   o---o---o
| S       G |
o---o---o---o
)");
  EXPECT_FALSE(has_several_routes(lollipop));
}

TEST(Routes, WalkingDifferentlyInsideTheGoalIsNoSecondRoute) {
  MazeDraft draft({4, 2}, MazeDraft::Inside::open);
  draft.close({0, 1}, Heading::south);
  draft.close({0, 1}, Heading::east);
  draft.close({1, 1}, Heading::south);
  draft.close({1, 1}, Heading::east);
  for (const Cell cell : {Cell{2, 0}, Cell{3, 0}, Cell{2, 1}, Cell{3, 1}}) draft.add_goal(cell);
  EXPECT_FALSE(has_several_routes(Maze(draft)));
  draft.open({1, 1}, Heading::south);
  draft.open({1, 1}, Heading::east);
  EXPECT_TRUE(has_several_routes(Maze(draft)));
}

// Whether another simple route exists, by walking all of them: only for tiny mazes.
int count_simple_routes(const Maze& maze, Cell cell, CellSet& walked) {
  if (maze.is_goal(cell)) return 1;
  walked.insert(cell);
  int routes = 0;
  for (const Heading heading : all_headings)
    if (const Cell next = neighbour(cell, heading); maze.is_open(cell, heading) && !walked.contains(next))
      routes += count_simple_routes(maze, next, walked);
  walked.erase(cell);
  return routes;
}

TEST(Routes, AgreesWithWalkingThemAll) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    const Maze maze = test::random_maze({4, 4}, seed, 5);
    CellSet walked;
    EXPECT_EQ(has_several_routes(maze), count_simple_routes(maze, maze.start(), walked) > 1) << seed;
  }
}

TEST(Routes, TheShortestWayIsAWay) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Maze maze = test::random_maze({9, 7}, seed, 5);
    const auto way = shortest_way(maze);
    ASSERT_EQ(way.empty(), !shortest_in_cells(maze));
    if (way.empty()) continue;
    EXPECT_EQ(static_cast<int>(way.size()) - 1, shortest_in_cells(maze));
    EXPECT_EQ(way.front(), maze.start());
    EXPECT_TRUE(maze.is_goal(way.back()));
  }
}

TEST(ContestRules, EachIsListedOnce) {
  std::vector<std::string_view> names;
  for (const RuleFinding& finding : check_contest_rules(contest_maze(1))) names.push_back(finding.name);
  EXPECT_THAT(names, testing::ElementsAre("size", "border", "start", "goal room", "entrance", "posts", "goal reachable",
                                          "left wall follower", "right wall follower", "routes"));
}

TEST(ContestRules, OtherSizesFail) {
  EXPECT_THAT(rule(Maze(MazeDraft({12, 16}, MazeDraft::Inside::open)), "size"), Says("12x16", "16x16", "32x32"));
  EXPECT_EQ(rule(contest_maze(1), "size"), "kept");
}

TEST(ContestRules, TheStartIsACornerWithThreeWalls) {
  MazeDraft draft = draft_of(contest_maze(1));
  draft.open({0, 0}, Heading::east);
  EXPECT_THAT(rule(Maze(draft), "start"), Says("(0,0)", "2 walls", "3"));
  EXPECT_THAT(rule(contest_maze(1).with_start({0, 5}, Heading::north), "start"), Says("(0,5)", "corner"));
}

TEST(ContestRules, AWallInTheGoalRoomIsNamed) {
  MazeDraft draft = draft_of(contest_maze(1));
  draft.close({7, 8}, Heading::south);
  EXPECT_THAT(rule(Maze(draft), "goal room"), Says("inside", "north of (7,7)"));
  CellSet elsewhere;
  elsewhere.insert({3, 3});
  EXPECT_THAT(rule(contest_maze(1).with_goals(elsewhere), "goal room"), Says("goals", "2x2", "centre"));
}

TEST(ContestRules, EveryEntranceIsNamed) {
  MazeDraft draft = draft_of(contest_maze(1));
  for (const Cell cell : {Cell{7, 7}, Cell{8, 7}}) {
    for (const Heading side : {Heading::south, Heading::east, Heading::west})
      if (!centre_of({16, 16}).contains(neighbour(cell, side))) draft.close(cell, side);
  }
  for (const Cell cell : {Cell{7, 8}, Cell{8, 8}}) {
    for (const Heading side : {Heading::north, Heading::east, Heading::west})
      if (!centre_of({16, 16}).contains(neighbour(cell, side))) draft.close(cell, side);
  }
  EXPECT_EQ(rule(Maze(draft), "entrance"), "none");
  EXPECT_THAT(rule(Maze(draft), "goal reachable"), Says("no way", "(0,0)"));
  draft.open({7, 7}, Heading::south);
  EXPECT_EQ(rule(Maze(draft), "entrance"), "kept");
  draft.open({8, 8}, Heading::east);
  EXPECT_THAT(rule(Maze(draft), "entrance"), Says("2", "one", "south of (7,7), east of (8,8)"));
}

TEST(ContestRules, APostWithoutWallIsNamed) {
  MazeDraft draft = draft_of(contest_maze(1));
  draft.open({3, 3}, Heading::west);
  draft.open({3, 3}, Heading::south);
  draft.open({2, 2}, Heading::north);
  draft.open({2, 2}, Heading::east);
  EXPECT_THAT(rule(Maze(draft), "posts"), Says("(3,3)"));
  EXPECT_THAT(rule(Maze(MazeDraft({16, 16}, MazeDraft::Inside::open)), "posts"),
              Says("no wall", "south-west", "(1,1), (2,1), (3,1), (4,1) ", "220 more"));
}

TEST(ContestRules, FollowersAndRoutesAreJudged) {
  const Maze perfect = depth_first_generator.make({{16, 16}, 1, 0});
  EXPECT_THAT(rule(perfect, "left wall follower"), Says("reaches the goal"));
  EXPECT_THAT(rule(perfect, "right wall follower"), Says("reaches the goal"));
  EXPECT_THAT(rule(perfect, "routes"), Says("two routes"));
  EXPECT_FALSE(keeps_contest_rules(perfect));
  EXPECT_TRUE(keeps_contest_rules(contest_maze(1)));
}

}  // namespace
}  // namespace labmouse
