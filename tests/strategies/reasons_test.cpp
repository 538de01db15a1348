// What the reasons of every mouse of the list of built-in mice promise, where it has any.
#include <gtest/gtest.h>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/strategies/contract_mazes.hpp"
#include "tests/strategies/counting_mouse.hpp"
#include "tests/strategies/mouse_name.hpp"

namespace labmouse {
namespace {

using test::contract_mazes;
using test::ContractMaze;

class EveryReasoner : public testing::TestWithParam<const BuiltinMouse*> {
 protected:
  std::unique_ptr<Strategy> mouse_for(const Maze& maze, bool reasons) const {
    Briefing briefing = brief(maze, {}, 1);
    briefing.reasons = reasons;
    return GetParam()->make(briefing, Settings(GetParam()->parameters));
  }
};

TEST_P(EveryReasoner, WalksTheSameWhetherItKeepsThemOrNot) {
  for (const ContractMaze& maze : contract_mazes()) {
    SCOPED_TRACE(maze.name);
    const auto silent = mouse_for(maze.maze, false), telling = mouse_for(maze.maze, true);
    test::CountingMouse counted(*telling);
    const RunRecord without = run(maze.maze, {}, *silent);
    RunRecord with = run(maze.maze, {}, counted);
    EXPECT_TRUE(without.reasons.empty());
    with.reasons.clear();
    EXPECT_EQ(with, without);
    EXPECT_EQ(counted.allocations(), 0);
  }
}

/// What must hold of the reasons of one step; `unknown` is what the mouse had not seen after that step's reading.
void examine(const Reasons& reasons, const WallSet& unknown, Size size) {
  const int count = static_cast<int>(reasons.candidates.size());
  ASSERT_GE(reasons.chosen, -1);
  ASSERT_LT(reasons.chosen, count);
  for (const Candidate& candidate : reasons.candidates) {
    EXPECT_TRUE(candidate.goal || unknown.contains(candidate.wall));
    EXPECT_TRUE(size.contains(candidate.seen_from));
    if (!candidate.worth) continue;
    ASSERT_GE(reasons.chosen, 0);
    EXPECT_LE(reasons.candidates[static_cast<std::size_t>(reasons.chosen)].score, candidate.score);
  }
  EXPECT_TRUE(reasons.chosen < 0 || reasons.candidates[static_cast<std::size_t>(reasons.chosen)].worth);
}

TEST_P(EveryReasoner, ChoosesTheLowestScoreAmongUnseenWallsOfTheExploration) {
  for (const ContractMaze& maze : contract_mazes()) {
    SCOPED_TRACE(maze.name);
    const auto mouse = mouse_for(maze.maze, true);
    const RunRecord record = run(maze.maze, {}, *mouse);
    Knowledge knowledge(maze.maze.size());
    auto next = record.reasons.begin();
    for (const StepRecord& step : record.steps) {
      ASSERT_TRUE(knowledge.learn(step.pose, step.sighting));
      if (next == record.reasons.end() || next->step != step.step) continue;
      EXPECT_EQ(step.run, Run::search_run);
      examine(next->reasons, knowledge.unknown(), maze.maze.size());
      ++next;
    }
    EXPECT_EQ(next, record.reasons.end());
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltinMice, EveryReasoner, testing::ValuesIn(builtin_mice().begin(), builtin_mice().end()),
                         test::mouse_name);

}  // namespace
}  // namespace labmouse
