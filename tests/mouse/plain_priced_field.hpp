// Cheapest costs over walls that have prices, the plain way: what PricedField, and what is made of it, is tested
// against.
#pragma once

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/motion.hpp"
#include "labmouse/mouse/wall_prices.hpp"

namespace labmouse::test {

/// What it costs to go through a wall; WallPrices::closed where nobody can.
using PriceOf = std::function<int(Wall)>;

/// A world of straight moves with prices: size, moves, and what one unit of a move's cost comes to.
struct PricedWorld {
  Size size;
  Motion motion;
  int step_price = 30;
  PriceOf price;

  int through_walls(Wall wall) const { return on_border(wall, size) ? WallPrices::closed : price(wall); }
};

/// Calls visit(to, cost, walls) for each straight move from a cell, with what it costs and the walls that it crosses.
template <class Visit>
void for_each_move(const PricedWorld& world, Cell from, Visit visit) {
  for (const Heading direction : all_headings) {
    Cell to = from;
    int prices = 0;
    std::vector<Wall> walls;
    for (unsigned cells = 1; cells <= static_cast<unsigned>(world.motion.longest); ++cells) {
      walls.push_back(wall_at(to, direction));
      const int price = world.through_walls(walls.back());
      if (price == WallPrices::closed) break;
      prices += price;
      to = neighbour(to, direction);
      visit(to, world.motion.cost[cells] * world.step_price + prices, walls);
    }
  }
}

/// The cheapest cost from a set of cells to each, by size.index(cell); unreachable where none leads (Dijkstra 1959).
inline std::vector<int> plain_costs(const PricedWorld& world, const CellSet& from) {
  std::vector<int> costs(static_cast<std::size_t>(world.size.area()), unreachable);
  std::priority_queue<std::pair<int, int>, std::vector<std::pair<int, int>>, std::greater<>> queue;
  const auto reach = [&](Cell cell, int cost) {
    int& known = costs[static_cast<std::size_t>(world.size.index(cell))];
    if (cost >= known) return;
    known = cost;
    queue.emplace(cost, world.size.index(cell));
  };
  from.for_each([&](Cell cell) { reach(cell, 0); });
  while (!queue.empty()) {
    const auto [cost, index] = queue.top();
    queue.pop();
    if (cost > costs[static_cast<std::size_t>(index)]) continue;
    for_each_move(world, world.size.cell_at(index),
                  [&, here = cost](Cell to, int move, const auto&) { reach(to, here + move); });
  }
  return costs;
}

/// A number for each wall of a maze, inner and border.
class WallNumbers {
 public:
  WallNumbers(Size size, int number) : size_(size), numbers_(static_cast<std::size_t>(2 * size.area()), number) {}

  /// Of a wall whose cell lies inside.
  int& operator[](Wall wall) { return numbers_[index(wall)]; }
  int operator[](Wall wall) const { return numbers_[index(wall)]; }

 private:
  std::size_t index(Wall wall) const {
    return static_cast<std::size_t>(2 * size_.index(wall.cell) + (wall.side == Heading::east ? 1 : 0));
  }

  Size size_;
  std::vector<int> numbers_;
};

/// For each wall the cheapest run from start to goal through it: the minimum over all straight moves s -> t that cross
/// it of the weighted cost to s, what the move costs, and the cost from t to a goal. The weight is in 1/256, rounded
/// down; unreachable where no run leads through the wall.
inline WallNumbers plain_costs_through(const PricedWorld& world, Cell start, const CellSet& goals, int weight) {
  const std::vector<int> from_start = plain_costs(world, CellSet::of(start)), to_goal = plain_costs(world, goals);
  WallNumbers cheapest(world.size, unreachable);
  for (int s = 0; s < world.size.area(); ++s) {
    const int way = weight == 0 ? 0 : from_start[static_cast<std::size_t>(s)];
    if (way == unreachable) continue;
    for_each_move(world, world.size.cell_at(s), [&](Cell to, int move, const std::vector<Wall>& walls) {
      const int rest = to_goal[static_cast<std::size_t>(world.size.index(to))];
      if (rest == unreachable) return;
      for (const Wall wall : walls) cheapest[wall] = std::min(cheapest[wall], way * weight / 256 + move + rest);
    });
  }
  return cheapest;
}

}  // namespace labmouse::test
