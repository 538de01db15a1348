#include "labmouse/lab/prior_learning.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

/// Follows an exploration and counts.
class Counting {
 public:
  Counting(const Maze& maze, PriorCounts& counts)
      : maze_(maze), counts_(counts), contexts_(maze.size()), unseen_(WallSet::all(maze.size())), changed_(unseen_) {
    unseen_.for_each([&](Wall wall) {
      const int goals = maze.is_goal(wall.cell) + maze.is_goal(neighbour(wall.cell, wall.side));
      if (goals == 1) rim_.insert(wall);
      if (goals == 2) inside_.insert(wall);
    });
    room_ = maze.goals().count() == 4 && inside_.count() == 4;
    if (!room_) rim_ = WallSet();
  }

  void learn(Pose pose, const Sighting& seen) {
    for (const int side : {-1, 0, 1}) {
      const Heading direction = turned(pose.heading, side);
      Cell cell = pose.cell;
      for (int passed = 0; passed <= seen.towards(side); ++passed, cell = neighbour(cell, direction))
        if (const Wall wall = wall_at(cell, direction); unseen_.contains(wall)) learn(wall);
    }
  }

  /// Counts the unseen walls whose surroundings have changed.
  void count() {
    changed_.for_each([&](Wall wall) {
      if (!unseen_.contains(wall) || inside_.contains(wall)) return;
      if (rim_.contains(wall))
        add(counts_.rim[static_cast<unsigned>(rim_context(rim_open_, rim_closed_))], wall);
      else
        add(counts_.walls[static_cast<unsigned>(folded_context(contexts_.of(wall)))], wall);
    });
    changed_ = WallSet();
  }

 private:
  bool open(Wall wall) const { return maze_.open_walls().contains(wall); }
  void add(WallCount& count, Wall wall) const { ++(open(wall) ? count.open : count.closed); }

  void learn(Wall wall) {
    unseen_.erase(wall);
    contexts_.learn(wall, open(wall), [&](Wall other) { changed_.insert(other); });
    if (!rim_.contains(wall)) return;
    ++(open(wall) ? rim_open_ : rim_closed_);
    changed_ |= rim_;
  }

  const Maze& maze_;
  PriorCounts& counts_;
  WallContexts contexts_;
  WallSet unseen_;
  WallSet changed_;
  WallSet rim_;
  WallSet inside_;
  bool room_ = false;
  int rim_open_ = 0, rim_closed_ = 0;
};

double share(const WallCount& count, double wider, double weight) {
  return (static_cast<double>(count.closed) + weight * wider) /
         (static_cast<double>(count.open + count.closed) + weight);
}

std::uint8_t reluctance_of(double closed) {
  return static_cast<std::uint8_t>(std::lround(-32.0 * std::log(std::max(0.001, 1.0 - closed))));
}

}  // namespace

void PriorCounts::add(const Maze& maze, const RunRecord& record) {
  Counting counting(maze, *this);
  for (const StepRecord& step : record.steps) {
    if (step.run == Run::speed) break;
    counting.learn(step.pose, step.sighting);
    counting.count();
  }
}

WallPrior prior_of(const PriorCounts& counts) {
  constexpr int six = 729;
  constexpr double weight = 10;
  std::vector<WallCount> of_six(six);
  WallCount all;
  for (int context = 0; context < wall_contexts; ++context) {
    const WallCount& count = counts.walls[static_cast<unsigned>(context)];
    WallCount& wider = of_six[static_cast<unsigned>(folded_context(context % six))];
    wider.open += count.open, wider.closed += count.closed;
    all.open += count.open, all.closed += count.closed;
  }
  const double everywhere = share(all, 0.5, 1);
  WallPrior prior{};
  for (int context = 0; context < wall_contexts; ++context) {
    const double wider = share(of_six[static_cast<unsigned>(folded_context(context % six))], everywhere, weight);
    prior.walls[static_cast<unsigned>(context)] =
        reluctance_of(share(counts.walls[static_cast<unsigned>(folded_context(context))], wider, weight));
  }
  for (unsigned i = 0; i < prior.rim.size(); ++i) prior.rim[i] = reluctance_of(share(counts.rim[i], everywhere, 2));
  return prior;
}

WallPrior learn_prior(std::span<const Maze> mazes, const Rules& rules) {
  const RosterEntry& mouse = ariadne_mouse;
  Settings settings(mouse.parameters);
  settings.set("prior", "uniform");
  settings.set("model", "flat");
  PriorCounts counts;
  for (const Maze& maze : mazes) {
    const auto mind = mouse.make(brief(maze, rules, 1), settings);
    counts.add(maze, run(maze, rules, *mind));
  }
  return prior_of(counts);
}

}  // namespace labmouse
