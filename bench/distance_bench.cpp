// Time of one distance field with movements of up to three cells: rows of bits (ours), a ring queue, and a plain
// search.
#include <benchmark/benchmark.h>

#include <chrono>

#include "bench_mazes.hpp"
#include "labmouse/lab/bench/plain_distance.hpp"
#include "labmouse/mouse/distance.hpp"

namespace labmouse {
namespace {

using Clock = std::chrono::steady_clock;

/// Calls work(i) for one maze after the other, and measures the time of one call.
template <class Work>
void for_each_maze(benchmark::State& state, std::size_t mazes, Work work) {
  std::size_t i = 0;
  for (auto _ : state) {
    work(i);
    i = i + 1 < mazes ? i + 1 : 0;
  }
  state.counters["mazes"] = static_cast<double>(mazes);
}

void rows(benchmark::State& state, DistanceField::Path path) {
  const int side = static_cast<int>(state.range(0));
  const auto mazes = bench_mazes(side);
  DistanceField field({side, side}, strides(), path);
  for_each_maze(state, mazes.size(), [&](std::size_t i) {
    field.fill(mazes[i].open_walls(), mazes[i].goals());
    benchmark::DoNotOptimize(field);
  });
}
BENCHMARK_CAPTURE(rows, widest, DistanceField::Path::widest)->Arg(16)->Arg(32)->Arg(64);
BENCHMARK_CAPTURE(rows, portable, DistanceField::Path::portable)->Arg(16)->Arg(32)->Arg(64);

void ring_queue(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  const auto mazes = bench_mazes(side);
  std::vector<RingSearch> searches;
  for (const Maze& maze : mazes) searches.emplace_back(maze.size(), strides().longest, maze.open_walls());
  const auto begin = Clock::now();
  for_each_maze(state, mazes.size(),
                [&](std::size_t i) { benchmark::DoNotOptimize(searches[i].fill(mazes[i].goals())); });
  const auto spent = Clock::now() - begin;
  // The speed-up of the rows of bits, measured directly afterwards.
  DistanceField field({side, side}, strides());
  const auto calls = static_cast<std::size_t>(state.iterations());
  const auto rows_begin = Clock::now();
  for (std::size_t call = 0; call < calls; ++call) {
    field.fill(mazes[call % mazes.size()].open_walls(), mazes[call % mazes.size()].goals());
    benchmark::DoNotOptimize(field);
  }
  state.counters["times_rows"] =
      static_cast<double>(spent.count()) / static_cast<double>((Clock::now() - rows_begin).count());
}
BENCHMARK(ring_queue)->Arg(16)->Arg(32)->Arg(64);

void plain(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  const auto mazes = bench_mazes(side);
  for_each_maze(state, mazes.size(), [&](std::size_t i) {
    benchmark::DoNotOptimize(plain_distances(mazes[i].size(), strides(), mazes[i].open_walls(), mazes[i].goals()));
  });
}
BENCHMARK(plain)->Arg(16)->Arg(32)->Arg(64);

}  // namespace
}  // namespace labmouse
