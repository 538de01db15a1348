// Time of a whole contest in the world of steps, for each built-in mouse, in mazes of 16x16 cells.
#include <benchmark/benchmark.h>

#include "bench_mazes.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

void contest(benchmark::State& state) {
  const BuiltinMouse& mouse = *builtin_mice()[static_cast<std::size_t>(state.range(0))];
  const auto mazes = bench_mazes(16);
  const Rules rules;
  std::size_t i = 0;
  for (auto _ : state) {
    const auto strategy = mouse.make(brief(mazes[i], rules, 1), Settings(mouse.parameters));
    benchmark::DoNotOptimize(run(mazes[i], rules, *strategy));
    i = i + 1 < mazes.size() ? i + 1 : 0;
  }
  state.SetLabel(std::string(mouse.name));
}
BENCHMARK(contest)->DenseRange(0, static_cast<int>(builtin_mice().size()) - 1);

}  // namespace
}  // namespace labmouse
