#include "labmouse/strategies/phases/goal_oriented.hpp"

#include <cassert>

#include "labmouse/mouse/manhattan.hpp"

namespace labmouse {
namespace {

GoalOriented::Heuristic heuristic_of(std::string_view name) {
  using enum GoalOriented::Heuristic;
  if (name == "manhattan") return manhattan;
  if (name == "edges") return edges;
  if (name == "manhattan-edges") return manhattan_edges;
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
    : start_(briefing.start),
      goals_(briefing.goals),
      heuristic_(heuristic_of(settings.choice("heuristic"))),
      cell_by_cell_(briefing.size, 1, TieOrder(settings.choice("ties"))),
      reached_(briefing.size, cell_order(settings.choice("order")), CellTable::set, CellKey::column_row),
      tree_(briefing.size, briefing.motion.longest, TieOrder(settings.choice("ties"))),
      optimistic_(briefing.size, briefing.motion) {}

std::optional<Action> GoalOriented::towards(const CellSet& candidates, const Knowledge& knowledge, Pose pose) {
  list_reached(knowledge);
  tree_.grow(knowledge.open(), pose);
  if (heuristic_ == Heuristic::optimistic) optimistic_.fill(knowledge.possible(), goals_);
  const auto target = most_promising(candidates, knowledge);
  if (!target) return std::nullopt;
  if (*target == pose.cell) return Action::step(90, 0);
  const Move move = move_between(pose.cell, tree_.first_towards(*target));
  return move_in(pose.heading, move.direction, move.cells);
}

/// Lists the reachable cells in the order of a search from the start.
void GoalOriented::list_reached(const Knowledge& knowledge) {
  cell_by_cell_.grow(knowledge.open(), start_);
  reached_.clear();
  for (const Cell cell : cell_by_cell_.found()) reached_.insert(cell);
}

std::optional<Cell> GoalOriented::most_promising(const CellSet& candidates, const Knowledge& knowledge) const {
  std::optional<Cell> best;
  int least = 0;
  reached_.for_each([&](Cell cell) {
    if (!candidates.contains(cell)) return;
    const int cost = tree_.distance(cell) + heuristic(knowledge, cell);
    // Ties go to the first on the list.
    if (best && cost >= least) return;
    best = cell;
    least = cost;
  });
  return best;
}

int GoalOriented::heuristic(const Knowledge& knowledge, Cell cell) const {
  switch (heuristic_) {
    case Heuristic::none:
      return 0;
    case Heuristic::manhattan:
      return manhattan_to(goals_, cell);
    case Heuristic::edges:
      return explored_edges(knowledge, cell);
    case Heuristic::manhattan_edges:
      return manhattan_to(goals_, cell) + explored_edges(knowledge, cell);
    case Heuristic::optimistic:
      return optimistic_.at(cell);
  }
  return 0;
}

}  // namespace labmouse
