// Time to compute the least costs of routes from all cells, where unseen walls have prices (priced_field.hpp): with a
// ring of buckets (ours) and with a plain priority queue. As early in a search run, walls near the start are known, and
// all others have a guessed price.
#include <benchmark/benchmark.h>

#include <queue>

#include "bench_mazes.hpp"
#include "labmouse/mouse/priced_field.hpp"

namespace labmouse {
namespace {

constexpr int step_price = 30;

/// Walls in the half of a maze near the start are known. All others have a price from 5 to 40 that depends on the
/// place.
WallPrices half_known(const Maze& maze) {
  WallPrices prices(maze.size());
  WallSet::all(maze.size()).for_each([&](Wall wall) {
    const bool known = wall.cell.x + wall.cell.y < maze.size().width;
    const int guess = 5 + (wall.cell.x * 7 + wall.cell.y * 13) % 36;
    prices.set(wall, !known ? guess : maze.open_walls().contains(wall) ? 0 : WallPrices::closed);
  });
  return prices;
}

struct Setting {
  std::vector<Maze> mazes;
  std::vector<WallPrices> prices;

  explicit Setting(int side) : mazes(bench_mazes(side)) {
    for (const Maze& maze : mazes) prices.push_back(half_known(maze));
  }
};

void priced_buckets(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  const Setting setting(side);
  PricedField field({side, side}, strides(), step_price);
  std::size_t i = 0;
  for (auto _ : state) {
    field.fill(setting.prices[i], setting.mazes[i].goals());
    benchmark::DoNotOptimize(field);
    i = i + 1 < setting.mazes.size() ? i + 1 : 0;
  }
}
BENCHMARK(priced_buckets)->Arg(16)->Arg(32)->Arg(64);

/// Dijkstra's algorithm with std::priority_queue.
std::vector<int> plain_costs(const WallPrices& prices, const CellSet& from) {
  const Size size = prices.size();
  std::vector<int> costs(static_cast<std::size_t>(size.area()), unreachable);
  using Entry = std::pair<int, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](Cell cell, int cost) {
    int& best = costs[static_cast<std::size_t>(size.index(cell))];
    if (cost >= best) return;
    best = cost;
    queue.emplace(cost, size.index(cell));
  };
  from.for_each([&](Cell cell) { reach(cell, 0); });
  while (!queue.empty()) {
    const auto [cost, index] = queue.top();
    queue.pop();
    if (cost > costs[static_cast<std::size_t>(index)]) continue;
    for (const Heading direction : all_headings) {
      Cell cell = size.cell_at(index);
      int price = 0;
      for (int cells = 1; cells <= strides().longest; ++cells) {
        const Wall wall = wall_at(cell, direction);
        if (on_border(wall, size) || !prices.passable(wall)) break;
        price += prices.of(wall);
        cell = neighbour(cell, direction);
        reach(cell, cost + step_price + price);
      }
    }
  }
  return costs;
}

void priced_plain(benchmark::State& state) {
  const Setting setting(static_cast<int>(state.range(0)));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(plain_costs(setting.prices[i], setting.mazes[i].goals()));
    i = i + 1 < setting.mazes.size() ? i + 1 : 0;
  }
}
BENCHMARK(priced_plain)->Arg(16)->Arg(32)->Arg(64);

}  // namespace
}  // namespace labmouse
