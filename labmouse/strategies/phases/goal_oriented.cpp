#include "labmouse/strategies/phases/goal_oriented.hpp"

#include <cassert>

#include "labmouse/mouse/manhattan.hpp"

namespace labmouse {
namespace {

GoalOriented::Heuristic heuristic_of(std::string_view name) {
  using enum GoalOriented::Heuristic;
  if (name == "manhattan") return manhattan;
  if (name == "edges") return edges;
  if (name == "optimistic") return optimistic;
  assert(name == "none");
  return none;
}

int explored_edges(const Knowledge& knowledge, Cell cell) {
  int explored = 0;
  for (const Heading side : all_headings)
    if (knowledge.state(wall_at(cell, side)) != WallState::unknown) ++explored;
  return explored;
}

}  // namespace

GoalOriented::GoalOriented(const Briefing& briefing, const Settings& settings)
    : goals_(briefing.goals),
      heuristic_(heuristic_of(settings.choice("heuristic"))),
      tree_(briefing.size, briefing.motion.longest, TieOrder(settings.choice("ties")),
            SearchTree::Reach::farthest_first),
      optimistic_(briefing.size, briefing.motion) {}

std::optional<Action> GoalOriented::towards(const CellSet& candidates, const Knowledge& knowledge, Pose pose) {
  tree_.grow(knowledge.open(), pose);
  if (heuristic_ == Heuristic::optimistic) optimistic_.fill(knowledge.possible(), goals_);
  const auto target = most_promising(candidates, knowledge);
  if (!target) return std::nullopt;
  if (*target == pose.cell) return Action::step(90, 0);
  // The route is searched from its end: among equally short ones it is another than the one that found the target.
  tree_.grow(knowledge.open(), {*target, Heading::north});
  const Move move = move_between(pose.cell, tree_.before(pose.cell));
  return move_in(pose.heading, move.direction, move.cells);
}

std::optional<Cell> GoalOriented::most_promising(const CellSet& candidates, const Knowledge& knowledge) const {
  std::optional<Cell> best;
  int least = 0;
  for (const Cell cell : tree_.found()) {
    if (!candidates.contains(cell)) continue;
    const int cost = tree_.distance(cell) + heuristic(knowledge, cell);
    // Of equals the one found last.
    if (best && cost > least) continue;
    best = cell;
    least = cost;
  }
  return best;
}

int GoalOriented::heuristic(const Knowledge& knowledge, Cell cell) const {
  switch (heuristic_) {
    case Heuristic::none:
      return 0;
    case Heuristic::manhattan:
      return manhattan_to(goals_, cell);
    case Heuristic::edges:
      return manhattan_to(goals_, cell) + explored_edges(knowledge, cell);
    case Heuristic::optimistic:
      return optimistic_.at(cell);
  }
  return 0;
}

}  // namespace labmouse
