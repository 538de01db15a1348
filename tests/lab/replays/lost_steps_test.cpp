// Where contests lose their steps: what is lost in the cells adds up to what the score is above the bound.
#include "labmouse/lab/replays/lost_steps.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::data_of;
using test::error_of;
using test::json;
using test::Says;

int total(const std::vector<int>& steps) { return std::accumulate(steps.begin(), steps.end(), 0); }

RunRecord played(const Maze& maze, const Rules& rules, std::vector<Action> actions) {
  const auto mouse = std::make_unique<Script>(maze.size(), std::move(actions));
  return run(maze, rules, *mouse);
}

TEST(LostSteps, AreNoneWhereTheMazeIsKnown) {
  const Rules rules;
  for (const NamedMaze& maze : {test::hook(), test::loop(), test::corridor()}) {
    const RunRecord record = run(maze.maze, rules, *make_oracle(maze.maze, rules));
    const std::optional<LostSteps> lost = LossMeter(maze.maze, rules).lost(record);
    ASSERT_TRUE(lost) << maze.name;
    EXPECT_EQ(total(lost->search_run), 0) << maze.name;
    EXPECT_EQ(total(lost->speed), 0) << maze.name;
  }
}

/// Standing still at the start, before the search run and before the speed run, is lost there and nowhere else; so is
/// what follows on the first goal, in the goal.
TEST(LostSteps, AreLostWhereTheMouseStood) {
  const Rules rules;
  const NamedMaze maze = test::corridor();
  const std::vector<Action> way = shortest_run(maze.maze, rules);
  std::vector<Action> actions = {Action::step(0, 0), Action::step(0, 0)};
  actions.insert(actions.end(), way.begin(), way.end());
  actions.push_back(Action::step(0, 0));
  actions.push_back(Action::reset());
  actions.push_back(Action::reset());
  actions.insert(actions.end(), way.begin(), way.end());
  const RunRecord record = played(maze.maze, rules, actions);
  ASSERT_EQ(record.outcome, Outcome::finished);
  const LostSteps lost = *LossMeter(maze.maze, rules).lost(record);
  const Size size = maze.maze.size();
  const auto at = [&](Cell cell) { return static_cast<std::size_t>(size.index(cell)); };
  EXPECT_EQ(lost.search_run[at(maze.maze.start())], 2);
  EXPECT_EQ(lost.search_run[at(record.end.cell)], 1);
  EXPECT_EQ(lost.speed[at(maze.maze.start())], 1);
  std::vector<int> by_step(record.steps.size());
  by_step[0] = by_step[1] = by_step[2 + way.size()] = by_step[4 + way.size()] = 1;
  EXPECT_EQ(LossMeter(maze.maze, rules).by_step(record), by_step);
  EXPECT_EQ(total(lost.search_run), 3);
  EXPECT_EQ(total(lost.speed), 1);
}

TEST(LostSteps, AreOfFinishedContestsAlone) {
  const Rules rules;
  const NamedMaze maze = test::corridor();
  EXPECT_FALSE(LossMeter(maze.maze, rules).lost(played(maze.maze, rules, {})));
}

json losses(const json& maze, const json& contests) {
  return answer("losses", {{"maze", maze}, {"contests", contests}});
}

/// For mice of all kinds, stochastic and not, in mazes that are large enough to lose something in.
TEST(LostSteps, AddUpToTheScores) {
  for (const char* name : {"capstone-1", "contest-02"}) {
    const json maze = answer("builtin_maze", {{"name", name}})["maze"];
    for (const char* mouse : {"flood", "frontier", "ariadne", "random-move", "visit-counter"}) {
      json contests = json::array();
      for (int seed = 1; seed <= 3; ++seed) contests.push_back({{"mouse", mouse}, {"seed", seed}});
      const json found = losses(maze, contests);
      if (found["finished"] == 0) continue;
      double points = 0;
      for (std::size_t i = 0; i < found["points"].size(); ++i) {
        EXPECT_GE(found["search"][i], 0) << mouse;
        EXPECT_GE(found["speed"][i], 0) << mouse;
        points += found["points"][i].get<double>();
      }
      EXPECT_NEAR(points, found["mean_score"].get<double>() - found["bound"].get<double>(), 1e-9) << mouse << name;
    }
  }
}

TEST(LostSteps, OfManyAreThoseOfEach) {
  const json maze = answer("builtin_maze", {{"name", "capstone-1"}})["maze"];
  const json flood = {{"mouse", "flood"}, {"seed", 1}};
  const json ariadne = {{"mouse", "ariadne"}, {"seed", 1}};
  const json one = losses(maze, json::array({flood})), other = losses(maze, json::array({ariadne})),
             both = losses(maze, json::array({flood, ariadne}));
  EXPECT_EQ(both["contests"], 2);
  for (const char* run : {"search", "speed"})
    for (std::size_t i = 0; i < both[run].size(); ++i)
      EXPECT_EQ(both[run][i], one[run][i].get<int>() + other[run][i].get<int>());
}

TEST(LostSteps, AreAskedForInFull) {
  const json maze = data_of(test::corridor());
  const auto error = [&](const json& contests) { return error_of("losses", {{"maze", maze}, {"contests", contests}}); };
  EXPECT_THAT(error(json::array()), Says("contests", "empty"));
  EXPECT_THAT(error(json::array({3})), Says("object"));
  EXPECT_THAT(error(json::array({{{"mouse", "nobody"}, {"seed", 1}}})), Says("unknown mouse", "'nobody'"));
  EXPECT_THAT(error(json::array({json({{"mouse", "flood"}})})), Says("'seed'"));
  EXPECT_THAT(error(json::array({{{"mouse", "program:cat"}, {"seed", 1}}})), Says("cat"));
  EXPECT_THAT(error(json(6000, {{"mouse", "flood"}, {"seed", 1}})), Says("too many"));
  EXPECT_THAT(error(json::array({{{"mouse", "festina"}, {"seed", 1}}})), Says("'festina'", "steps"));
}

}  // namespace
}  // namespace labmouse
