#include "labmouse/lab/mice/prior_learning.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

/// Number of contexts of the six neighbours that are not parallel walls: 3^6. The two parallel walls are the highest
/// base-three digits of a context, so `context % 729` leaves them out.
constexpr int contexts_of_six = 729;

/// Follows a search run and counts the unseen walls whose context has changed; at first all walls.
class Follower {
 public:
  Follower(const Maze& maze, PriorCounts& counts)
      : maze_(maze), counts_(counts), contexts_(maze.size()), unseen_(WallSet::all(maze.size())), changed_(unseen_) {
    unseen_.for_each([&](Wall wall) {
      const int goals = maze.is_goal(wall.cell) + maze.is_goal(neighbour(wall.cell, wall.side));
      if (goals == 1) rim_.insert(wall);
      if (goals == 2) inside_.insert(wall);
    });
    // Among shapes of four cells only the square has four inner walls.
    const bool room = maze.goals().count() == 4 && inside_.count() == 4;
    if (!room) rim_ = WallSet();
  }

  void follow(const StepRecord& step) {
    for (const int side : {-1, 0, 1}) see(step.pose.cell, turned(step.pose.heading, side), step.sighting.towards(side));
    changed_.for_each([&](Wall wall) {
      if (unseen_.contains(wall) && !inside_.contains(wall)) count(wall);
    });
    changed_ = WallSet();
  }

 private:
  bool is_open(Wall wall) const { return maze_.open_walls().contains(wall); }

  void see(Cell cell, Heading direction, int open_cells) {
    for (int passed = 0; passed <= open_cells; ++passed, cell = neighbour(cell, direction))
      if (const Wall wall = wall_at(cell, direction); unseen_.contains(wall)) learn(wall);
  }

  void learn(Wall wall) {
    unseen_.erase(wall);
    contexts_.learn(wall, is_open(wall), [&](Wall other) { changed_.insert(other); });
    if (!rim_.contains(wall)) return;
    ++(is_open(wall) ? rim_open_ : rim_closed_);
    changed_ |= rim_;
  }

  void count(Wall wall) {
    WallCount& found = rim_.contains(wall) ? counts_.rim[static_cast<unsigned>(rim_context(rim_open_, rim_closed_))]
                                           : counts_.walls[static_cast<unsigned>(folded_context(contexts_.of(wall)))];
    ++(is_open(wall) ? found.open : found.closed);
  }

  const Maze& maze_;
  PriorCounts& counts_;
  WallContexts contexts_;
  WallSet unseen_;
  WallSet changed_;  ///< since the last count
  WallSet rim_;      ///< of a goal room of 2×2 cells
  WallSet inside_;   ///< between two goal cells
  int rim_open_ = 0, rim_closed_ = 0;
};

WallCount& operator+=(WallCount& sum, const WallCount& count) {
  sum.open += count.open, sum.closed += count.closed;
  return sum;
}

/// The share of closed walls, with `weight` pseudo-counts that have the share of a wider class.
double share(const WallCount& count, double wider, double weight) {
  return (static_cast<double>(count.closed) + weight * wider) /
         (static_cast<double>(count.open + count.closed) + weight);
}

/// P(closed) for each number of a prior.
struct Shares {
  std::vector<double> walls;
  std::vector<double> rim;
};

Shares shares_of(const PriorCounts& counts) {
  constexpr double weight = 10, rim_weight = 2;
  std::vector<WallCount> of_six(contexts_of_six);
  WallCount all;
  for (int context = 0; context < wall_contexts; ++context) {
    const WallCount& count = counts.walls[static_cast<unsigned>(context)];
    of_six[static_cast<unsigned>(folded_context(context % contexts_of_six))] += count;
    all += count;
  }
  const double everywhere = share(all, 0.5, 1);
  Shares shares;
  for (int context = 0; context < wall_contexts; ++context) {
    const WallCount& six = of_six[static_cast<unsigned>(folded_context(context % contexts_of_six))];
    const WallCount& eight = counts.walls[static_cast<unsigned>(folded_context(context))];
    shares.walls.push_back(share(eight, share(six, everywhere, weight), weight));
  }
  for (const WallCount& count : counts.rim) shares.rim.push_back(share(count, everywhere, rim_weight));
  return shares;
}

/// -32 ln(1 - closed), rounded; `closed` is clamped to 0.999. It uses products of constants instead of a logarithm, so
/// that equal counts give equal priors on every platform.
std::uint8_t reluctance_of(double closed) {
  constexpr double half_step = 0.98449643700540842;  // exp(-0.5 / 32)
  constexpr double step = 0.96923323447634408;       // exp(-1 / 32)
  const double open = std::max(0.001, 1.0 - closed);
  std::uint8_t reluctance = 0;
  double limit = half_step;
  while (open <= limit) {
    limit *= step;
    ++reluctance;
  }
  return reluctance;
}

/// Sum of -ln P(actual state) over the walls of a count.
double surprise(const WallCount& count, double closed) {
  double sum = 0.0;
  if (count.open > 0) sum -= static_cast<double>(count.open) * std::log(1.0 - closed);
  if (count.closed > 0) sum -= static_cast<double>(count.closed) * std::log(closed);
  return sum;
}

Settings indifferent() {
  Settings settings(ariadne_mouse.parameters);
  settings.set("prior", "uniform");
  settings.set("model", "flat");
  return settings;
}

}  // namespace

void PriorCounts::add(const Maze& maze, const RunRecord& record) {
  Follower follower(maze, *this);
  for (const StepRecord& step : record.steps) {
    if (step.run == Run::speed) break;
    follower.follow(step);
  }
}

void PriorCounts::explore(const Maze& maze, const Rules& rules) {
  const auto strategy = ariadne_mouse.make(brief(maze, rules, 1), indifferent());
  add(maze, run(maze, rules, *strategy));
}

WallPrior prior_of(const PriorCounts& counts) {
  const Shares shares = shares_of(counts);
  WallPrior prior{};
  std::transform(shares.walls.begin(), shares.walls.end(), prior.walls.begin(), reluctance_of);
  std::transform(shares.rim.begin(), shares.rim.end(), prior.rim.begin(), reluctance_of);
  return prior;
}

PriorFit fit_of(const PriorCounts& counts) {
  const Shares shares = shares_of(counts);
  PriorFit fit;
  WallCount all;
  const auto add = [&](const WallCount& count, double closed) {
    all += count;
    fit.log_loss += surprise(count, closed);
  };
  for (unsigned i = 0; i < counts.walls.size(); ++i) add(counts.walls[i], shares.walls[i]);
  for (unsigned i = 0; i < counts.rim.size(); ++i) add(counts.rim[i], shares.rim[i]);
  fit.walls = all.open + all.closed;
  if (fit.walls == 0) return fit;
  const auto walls = static_cast<double>(fit.walls);
  fit.log_loss /= walls;
  fit.entropy = surprise(all, static_cast<double>(all.closed) / walls) / walls;
  return fit;
}

WallPrior learn_prior(std::span<const Maze* const> mazes, const Rules& rules, const std::atomic<bool>* stop) {
  PriorCounts counts;
  for (const Maze* maze : mazes)
    if (stop == nullptr || !stop->load()) counts.explore(*maze, rules);
  return prior_of(counts);
}

}  // namespace labmouse
