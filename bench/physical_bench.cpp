// Simulated seconds in the physical world per second of processor time.
#include <benchmark/benchmark.h>

#include "bench_mazes.hpp"
#include "labmouse/contest/known_drive.hpp"
#include "labmouse/hardware/sense.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

DriveModel kerise() {
  DriveModel model = find_robot("kerise").model;
  share_route_tables(model);
  return model;
}

/// Body and controller on known routes with all noise: each millisecond has four infrared beams, the accelerometer and
/// the covariance of the estimator.
void known_way(benchmark::State& state, KnownWay way) {
  const DriveModel model = kerise();
  const auto mazes = bench_mazes(16);
  PhysicalConditions conditions;
  conditions.controller.search_speed = 330.0;
  std::uint64_t seed = 0;
  double seconds = 0.0;
  for (auto _ : state) {
    const auto drive = drive_known_way(mazes[seed % mazes.size()], model, conditions, way, seed);
    if (drive) seconds += static_cast<double>(drive->ticks) * tick_seconds;
    ++seed;
  }
  state.counters["simulated_seconds_a_second"] = benchmark::Counter(seconds, benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(known_way, search, KnownWay::search);
BENCHMARK_CAPTURE(known_way, fast, KnownWay::fast);

}  // namespace
}  // namespace labmouse
