#include "labmouse/mouse/drive/run_costs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

RunPrices any_prices(Rng& rng) {
  return {20 + rng.below(80), 20 + rng.below(300), 20 + rng.below(100), 20 + rng.below(300)};
}

WallPrices any_walls(const Maze& maze, Rng& rng) {
  WallPrices walls(maze.size());
  WallSet::all(maze.size()).for_each([&](Wall wall) {
    const bool open = maze.open_walls().contains(wall);
    const bool seen = rng.chance(1, 2);
    walls.set(wall, seen ? (open ? 0 : WallPrices::closed) : 4 * (1 + rng.below(25)));
  });
  return walls;
}

/// x, y, the direction in which the cell was entered, the turn before it: 0, -1 (left) or 1.
using Edge = std::tuple<int, int, int, int>;

/// The least costs of runs through each cell, by relaxing all edges until nothing changes (Bellman 1958, Ford 1956).
class PlainRuns {
 public:
  PlainRuns(const RunPrices& run, const WallPrices& walls, const RunTolls& tolls, Pose start, const CellSet& goals)
      : run_(run), walls_(walls), tolls_(tolls) {
    std::map<Edge, int> from_start, to_goal;
    const auto first = toll(start.cell, static_cast<int>(start.heading));
    const Cell next = neighbour(start.cell, start.heading);
    if (first) from_start[{next.x, next.y, static_cast<int>(start.heading), 0}] = run.straight + *first;
    relax(from_start, [&](auto lower) {
      for (const Step& step : steps()) lower(step.from, step.to, step.cost);
    });
    for (const Step& step : steps())
      for (const Edge& edge : {step.from, step.to})
        if (goals.contains({std::get<0>(edge), std::get<1>(edge)})) to_goal[edge] = 0;
    relax(to_goal, [&](auto lower) {
      for (const Step& step : steps()) lower(step.to, step.from, step.cost);
    });
    for (const auto& [edge, cost] : from_start)
      if (to_goal.count(edge) > 0) {
        const std::pair<int, int> cell = {std::get<0>(edge), std::get<1>(edge)};
        const int sum = cost + to_goal.at(edge);
        const auto [found, is_new] = through_.emplace(cell, sum);
        if (!is_new) found->second = std::min(found->second, sum);
      }
  }

  /// Nothing where no run leads through the cell.
  std::optional<int> through(Cell cell) const {
    const auto found = through_.find({cell.x, cell.y});
    return found == through_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  struct Step {
    Edge from, to;
    int cost;
  };

  std::optional<int> toll(Cell cell, int direction) const {
    const Wall wall = wall_at(cell, all_headings[static_cast<unsigned>(direction)]);
    if (on_border(wall, walls_.size()) || walls_.of(wall) >= tolls_.closed) return std::nullopt;
    const int price = walls_.of(wall);
    return price == 0 ? 0 : tolls_.base + price * tolls_.per_nat / 32;
  }

  const std::vector<Step>& steps() {
    if (!steps_.empty()) return steps_;
    CellSet::all(walls_.size()).for_each([&](Cell cell) {
      for (int direction = 0; direction < 4; ++direction)
        for (int turn = -1; turn <= 1; ++turn)
          for (int next = -1; next <= 1; ++next) {
            const int heading = (direction + next + 4) % 4;
            const auto extra = toll(cell, heading);
            if (!extra) continue;
            const Cell to = neighbour(cell, all_headings[static_cast<unsigned>(heading)]);
            const int cost = next == 0      ? run_.straight
                             : turn == 0    ? run_.turn
                             : turn == next ? run_.again
                                            : run_.opposite;
            steps_.push_back({{cell.x, cell.y, direction, turn}, {to.x, to.y, heading, next}, cost + *extra});
          }
    });
    return steps_;
  }

  template <class Steps>
  static void relax(std::map<Edge, int>& costs, Steps steps) {
    bool changed = true;
    while (changed) {
      changed = false;
      steps([&](const Edge& from, const Edge& to, int cost) {
        const auto found = costs.find(from);
        if (found == costs.end()) return;
        const int sum = found->second + cost;
        const auto [there, is_new] = costs.emplace(to, sum);
        if (!is_new && there->second <= sum) return;
        there->second = sum;
        changed = true;
      });
    }
  }

  RunPrices run_;
  const WallPrices& walls_;
  RunTolls tolls_;
  std::vector<Step> steps_;
  std::map<std::pair<int, int>, int> through_;
};

TEST(RunCosts, AreThoseOfAPlainSearchInAnyMaze) {
  Rng rng(21);
  for (int round = 0; round < test::tenth(40); ++round) {
    const Maze maze = test::any_maze(rng, 7);
    const WallPrices walls = any_walls(maze, rng);
    const RunPrices run = any_prices(rng);
    const RunTolls tolls = {rng.below(200), rng.below(20), 4 * (8 + rng.below(25))};
    const Pose start = {maze.start(), maze.start_heading()};
    std::vector<std::byte> memory(RunCosts::bytes_for(maze.size()));
    RunCosts costs(maze.size(), memory);
    costs.aim(run, start, maze.goals());

    const PlainRuns known(run, walls, {0, 0, 1}, start, maze.goals());
    int best = RunCosts::no_run;
    maze.goals().for_each([&](Cell goal) { best = std::min(best, known.through(goal).value_or(RunCosts::no_run)); });
    EXPECT_EQ(costs.known(walls), maze.is_goal(maze.start()) ? 0 : best);

    const int limit = 300 + rng.below(3000);
    costs.plan(walls, tolls, limit);
    const PlainRuns plain(run, walls, tolls, start, maze.goals());
    CellSet::all(maze.size()).for_each([&](Cell cell) {
      const auto found = costs.through(cell);
      const auto expected = plain.through(cell);
      ASSERT_EQ(found.has_value(), expected && *expected < limit);
      if (found) {
        // The sum of tolls is rounded wall by wall, the price of all at once.
        EXPECT_NEAR(found->time + found->price * tolls.per_nat / 32, *expected, 1);
      }
    });
  }
}

TEST(RunCosts, TellTimeFromPrices) {
  WallPrices walls({1, 4});
  walls.set(wall_at({0, 0}, Heading::north), 0);
  walls.set(wall_at({0, 1}, Heading::north), 32);
  walls.set(wall_at({0, 2}, Heading::north), 64);
  std::vector<std::byte> memory(RunCosts::bytes_for({1, 4}));
  RunCosts costs({1, 4}, memory);
  costs.aim({70, 200, 60, 150}, {{0, 0}, Heading::north}, CellSet::of({0, 3}));
  EXPECT_EQ(costs.known(walls), RunCosts::no_run);
  costs.plan(walls, {10, 0}, RunCosts::no_run);
  const auto run = costs.through({0, 1});
  ASSERT_TRUE(run);
  EXPECT_EQ(run->time, 210);
  EXPECT_EQ(run->price, 96);
  costs.plan(walls, {10, 0}, 240);
  EXPECT_FALSE(costs.through({0, 1})) << "a run that costs the limit is none";
}

/// How far the sums are from the times of fastest routes, in the mean of many mazes.
TEST(RunPrices, ExplainTheTimesOfRuns) {
  LABMOUSE_SKIP_SANITIZED();
  for (const Robot& robot : {published_robot(), small_robot()}) {
    const DriveModel model = make_drive_model(robot);
    FastestRoutes corridors({run_prices_side, run_prices_side}, route_tables_of(model));
    const RunPrices prices = run_prices_of(corridors);
    EXPECT_GT(prices.turn, prices.straight);
    double off = 0;
    constexpr int mazes = 20;
    for (std::uint64_t seed = 1; seed <= mazes; ++seed) {
      const Maze maze = find_generator("contest")->make({{16, 16}, seed, 0});
      const Pose start = {maze.start(), maze.start_heading()};
      FastestRoutes routes(maze.size(), route_tables_of(model));
      routes.fill_for(start, maze.open_walls(), maze.goals());
      WallPrices walls(maze.size());
      maze.open_walls().for_each([&](Wall wall) { walls.set(wall, 0); });
      std::vector<std::byte> memory(RunCosts::bytes_for(maze.size()));
      RunCosts costs(maze.size(), memory);
      costs.aim(prices, start, maze.goals());
      off += std::abs(costs.known(walls) * 1000.0 / routes.time_from(start) - 1);
    }
    EXPECT_LT(off / mazes, 0.12) << robot.name;
  }
}

}  // namespace
}  // namespace labmouse
