#include "labmouse/strategies/phases/continuing.hpp"

#include <cassert>

#include "labmouse/mouse/optimistic_routes.hpp"
#include "labmouse/strategies/phases/goal_oriented.hpp"
#include "labmouse/strategies/phases/speed_run.hpp"
#include "labmouse/strategies/phases/unexplored.hpp"

namespace labmouse {
namespace {

class None final : public Continuing {
 public:
  std::optional<Action> next(const Knowledge&, Pose, const CellSet&) override { return std::nullopt; }
};

/// Enters the next goal cell ahead, left or right, until all are visited or explored.
class AllGoals final : public Continuing {
 public:
  explicit AllGoals(const Briefing& briefing) : goals_(briefing.goals) {}

  std::optional<Action> next(const Knowledge& knowledge, Pose pose, const CellSet& visited) override {
    CellSet rest = goals_;
    rest -= visited;
    CellSet unexplored = unexplored_cells(knowledge);
    unexplored &= rest;
    if (unexplored.empty()) return std::nullopt;
    for (const int quarters : {0, -1, 1}) {
      const Heading direction = turned(pose.heading, quarters);
      const bool open = knowledge.open().contains(wall_at(pose.cell, direction));
      if (open && rest.contains(neighbour(pose.cell, direction))) return Action::step(90 * quarters, 1);
    }
    return std::nullopt;
  }

 private:
  CellSet goals_;
};

/// Continues the search until a share of all cells, or every reachable cell, is explored.
class Coverage final : public Continuing {
 public:
  Coverage(const Briefing& briefing, const Settings& settings, Searching& searching)
      : searching_(searching),
        area_(briefing.size.area()),
        share_(settings.real("coverage")),
        field_(briefing.size, briefing.motion) {}

  std::optional<Action> next(const Knowledge& knowledge, Pose pose, const CellSet&) override {
    const CellSet unexplored = unexplored_cells(knowledge);
    if (area_ - unexplored.count() >= share_ * area_) return std::nullopt;
    field_.fill(knowledge.open(), unexplored);
    return field_.reaches(pose.cell) ? searching_.next(knowledge, pose) : std::nullopt;
  }

 private:
  Searching& searching_;
  int area_;
  double share_;
  DistanceField field_;
};

/// Explores only what can shorten the speed run: cells beside unknown walls on a shortest optimistic route, while that
/// route is shorter than the known one. So it skips parts of the maze with a single entrance.
class Worthwhile final : public Continuing {
 public:
  Worthwhile(const Briefing& briefing, const Settings& settings)
      : Worthwhile(briefing, settings, briefing_for_speed(briefing, settings)) {}

  std::optional<Action> next(const Knowledge& knowledge, Pose pose, const CellSet&) override {
    optimistic_.plan(knowledge);
    known_.fill(knowledge.open(), goals_);
    if (known_.at(start_) == optimistic_.length()) return std::nullopt;
    return walk_.towards(cells_beside(optimistic_.unknown_walls()), knowledge, pose);
  }

 private:
  Worthwhile(const Briefing& briefing, const Settings& settings, const Briefing& speed)
      : start_(briefing.start.cell),
        goals_(briefing.goals),
        optimistic_(speed),
        known_(briefing.size, speed.motion),
        walk_(briefing, settings) {}

  Cell start_;
  CellSet goals_;
  OptimisticRoutes optimistic_;
  DistanceField known_;
  GoalOriented walk_;
};

}  // namespace

std::unique_ptr<Continuing> make_continuing(const Briefing& briefing, const Settings& settings, Searching& searching) {
  const std::string_view name = settings.choice("continuing");
  if (name == "all-goals") return std::make_unique<AllGoals>(briefing);
  if (name == "coverage") return std::make_unique<Coverage>(briefing, settings, searching);
  if (name == "worthwhile") return std::make_unique<Worthwhile>(briefing, settings);
  assert(name == "none");
  return std::make_unique<None>();
}

}  // namespace labmouse
