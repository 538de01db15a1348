// Time to plan a fastest route in seconds: reading the walls, computing the times, writing the route.
// median_us, p95_us, max_us and worst_maze_us: in turn over different mazes, as in a search run whose walls change
// (branch predictors learn a maze that is repeated). warm_us: one maze many times. field_us: in turn, with the times
// from all places and not only those that the route from the start needs. plain_us: the plain search.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "bench_mazes.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "tests/mouse/plain_fastest.hpp"

namespace labmouse {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration time) { return std::chrono::duration<double, std::micro>(time).count(); }

Pose start_of(const Maze& maze) { return {maze.start(), maze.start_heading()}; }

std::vector<Maze> mazes_of(int side, bool empty) {
  if (empty) return {Maze(MazeDraft({side, side}, MazeDraft::Inside::open))};
  return bench_mazes(side);
}

/// Times of calls in microseconds. Returns the sorted medians per maze, or the sorted times of all calls.
class Latencies {
 public:
  explicit Latencies(std::size_t mazes) : of_maze_(mazes) {}

  template <class Work>
  void measure(std::size_t maze, Work work) {
    const auto begin = Clock::now();
    work();
    of_maze_[maze].push_back(microseconds(Clock::now() - begin));
  }
  std::vector<double> medians() {
    std::vector<double> medians;
    for (auto& times : of_maze_) {
      if (times.empty()) continue;
      std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
      medians.push_back(times[times.size() / 2]);
    }
    std::sort(medians.begin(), medians.end());
    return medians;
  }
  std::vector<double> all() const {
    std::vector<double> all;
    for (const auto& times : of_maze_) all.insert(all.end(), times.begin(), times.end());
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  std::vector<std::vector<double>> of_maze_;
};

double share(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1) + 0.5)];
}

/// The model of a robot, made once and kept for the whole run.
const DriveModel& model_of(const char* name) {
  static std::vector<std::pair<std::string, std::unique_ptr<DriveModel>>> models;
  for (const auto& [known, model] : models)
    if (known == name) return *model;
  models.emplace_back(name, std::make_unique<DriveModel>(find_robot(name).model));
  return *models.back().second;
}

void route(benchmark::State& state, const char* robot, bool empty) {
  const auto mazes = mazes_of(static_cast<int>(state.range(0)), empty);
  const DriveTables& tables = model_of(robot).tables;
  FastestRoutes routes(mazes[0].size(), tables);
  DriveRoute found;
  const auto plan = [&](const Maze& maze) {
    routes.fill_for(start_of(maze), maze.open_walls(), maze.goals());
    routes.route_from(start_of(maze), found);
    benchmark::DoNotOptimize(found);
  };
  const auto plan_all = [&](const Maze& maze) {
    routes.fill(maze.open_walls(), maze.goals());
    routes.route_from(start_of(maze), found);
    benchmark::DoNotOptimize(found);
  };
  Latencies in_turn(mazes.size()), all(mazes.size()), warm(mazes.size()), plain(mazes.size());
  std::size_t calls = 0;
  for (auto _ : state) {
    const std::size_t i = calls++ % mazes.size();
    in_turn.measure(i, [&] { plan(mazes[i]); });
  }
  for (std::size_t call = 0; call < calls; ++call)
    all.measure(call % mazes.size(), [&] { plan_all(mazes[call % mazes.size()]); });
  for (std::size_t i = 0; i < mazes.size(); ++i) {
    for (int round = 0; round < 3; ++round)
      plain.measure(i, [&] {
        const test::PlainFastest search(mazes[i].size(), tables, mazes[i].open_walls(), mazes[i].goals());
        benchmark::DoNotOptimize(search.time_from(start_of(mazes[i])));
      });
    for (int round = 0; round < 31; ++round) warm.measure(i, [&] { plan(mazes[i]); });
  }
  const auto calls_in_turn = in_turn.all(), turn = in_turn.medians(), field = all.medians(), again = warm.medians(),
             slow = plain.medians();
  state.counters["mazes"] = static_cast<double>(mazes.size());
  state.counters["median_us"] = share(turn, 0.5);
  state.counters["p95_us"] = share(calls_in_turn, 0.95);
  state.counters["max_us"] = calls_in_turn.back();
  state.counters["worst_maze_us"] = turn.back();
  state.counters["field_us"] = share(field, 0.5);
  state.counters["warm_us"] = share(again, 0.5);
  state.counters["plain_us"] = share(slow, 0.5);
  state.counters["plain/ours"] = share(slow, 0.5) / share(turn, 0.5);
  state.counters["plain/field"] = share(slow, 0.5) / share(field, 0.5);
}
BENCHMARK_CAPTURE(route, mm2021, "mm2021", false)->Arg(16)->Arg(32)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(route, mm2021_empty, "mm2021", true)->Arg(16)->Arg(32)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(route, classic, "classic", false)->Arg(16)->Arg(32)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(route, classic_empty, "classic", true)->Arg(16)->Arg(32)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace labmouse
