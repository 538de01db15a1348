#include "labmouse/lab/bench/distance_speed.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/bench/plain_distance.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

using Clock = std::chrono::steady_clock;

/// Median over batches of the nanoseconds that one call takes; each batch calls work(i) once for each of `count` mazes.
template <class Work>
double median_ns(std::size_t count, int batches, Work work) {
  std::vector<double> times;
  for (int batch = 0; batch < batches; ++batch) {
    const auto begin = Clock::now();
    for (std::size_t i = 0; i < count; ++i) work(i);
    times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count() /
                    static_cast<double>(count));
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

std::vector<Maze> mazes_of(int side) {
  std::vector<Maze> mazes;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    const GeneratorOrder order{{side, side}, seed, 60};
    const Generator& generator = contest_generator.refuses(order).empty() ? contest_generator : depth_first_generator;
    mazes.push_back(generator.make(order));
  }
  return mazes;
}

DistanceSpeed measure_distance(int side) {
  const std::vector<Maze> mazes = mazes_of(side);
  const Size size{side, side};
  const Motion motion = strides();
  DistanceField rows(size, motion), portable_rows(size, motion, DistanceField::Path::portable);
  std::vector<RingSearch> rings;
  for (const Maze& maze : mazes) rings.emplace_back(size, motion.longest, maze.open_walls());
  const auto time = [&](int batches, auto work) { return median_ns(mazes.size(), batches, work); };
  DistanceSpeed speed;
  speed.rows = time(401, [&](std::size_t i) { rows.fill(mazes[i].open_walls(), mazes[i].goals()); });
  speed.portable_rows = time(401, [&](std::size_t i) { portable_rows.fill(mazes[i].open_walls(), mazes[i].goals()); });
  speed.queue = time(101, [&](std::size_t i) { rings[i].fill(mazes[i].goals()); });
  speed.plain =
      time(15, [&](std::size_t i) { plain_distances(size, motion, mazes[i].open_walls(), mazes[i].goals()); });
  return speed;
}

}  // namespace

DistanceSpeeds measure_distances() {
  DistanceSpeeds speeds;
  for (const int side : {16, 32, 64}) speeds[side] = measure_distance(side);
  return speeds;
}

Speed measure_speed() {
  Speed speed;
  speed.distance_ns = measure_distances();
  const std::vector<Maze> mazes = mazes_of(16);
  const Rules rules;
  for (const BuiltinMouse* mouse : builtin_mice()) {
    const double ns = median_ns(mazes.size(), 5, [&](std::size_t i) {
      const auto strategy = mouse->make(brief(mazes[i], rules, 1), Settings(mouse->parameters));
      run(mazes[i], rules, *strategy);
    });
    speed.contests_per_second[std::string(mouse->name)] = 1e9 / ns;
  }
  return speed;
}

}  // namespace labmouse
