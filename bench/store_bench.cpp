// Contests per second that are written to a store and read from it.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>

#include "bench_mazes.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/steps/steps_world.hpp"
#include "labmouse/lab/store/store.hpp"

namespace labmouse {
namespace {

constexpr std::size_t many = 50'000;

/// A race with `many` contests. Only one was run; the others are copies with other seeds.
Race large_race() {
  RaceOrder order;
  order.world = steps_world();
  Race race = hold_race(read_specs("flood").contestants, {{"maze", bench_mazes(16).front()}}, order);
  race.results.resize(many, race.results.front());
  for (std::size_t i = 0; i < many; ++i) race.results[i].seed = i;
  return race;
}

std::string store_path() {
  return (std::filesystem::temp_directory_path() / ("labmouse-bench-" + std::to_string(getpid()) + ".db")).string();
}

void remove_store() {
  for (const char* ending : {"", "-wal", "-shm"}) std::filesystem::remove(store_path() + ending);
}

const auto nothing = [](const ContestResult&) { return false; };
const auto everything = [](const ContestResult&) { return true; };

void keep_contests(benchmark::State& state) {
  Race race = large_race();
  for (auto _ : state) {
    state.PauseTiming();
    remove_store();
    state.ResumeTiming();
    Store store(store_path());
    store.recall(race, nothing);
    for (const ContestResult& contest : race.results) store.keep(race, contest);
    if (!store.finish().empty()) state.SkipWithError("the store failed");
  }
  remove_store();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(many));
}
BENCHMARK(keep_contests)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

void recall_contests(benchmark::State& state) {
  Race race = large_race();
  remove_store();
  Store store(store_path());
  store.recall(race, nothing);
  for (const ContestResult& contest : race.results) store.keep(race, contest);
  if (!store.finish().empty()) state.SkipWithError("the store failed");
  for (auto _ : state) store.recall(race, everything);
  remove_store();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(many));
}
BENCHMARK(recall_contests)->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace labmouse
