#include "labmouse/strategies/move_mapper.hpp"

#include <algorithm>
#include <tuple>

namespace labmouse {

MoveMapper::MoveMapper(const Briefing& briefing, const Settings& settings)
    : Explorer(briefing),
      map_(briefing.size, briefing.motion.longest, cell_order(settings.choice("order"))),
      routes_(briefing.size, briefing.motion.longest, TieOrder("nesw")) {
  plan_.reserve(static_cast<std::size_t>(briefing.size.area()));
}

Action MoveMapper::explore() {
  look();
  if (goal_entered() && is_done()) {
    plan_.clear();
    return Action::reset();
  }
  // The start is a goal: it counts as entered only when a step ends there.
  if (!goal_entered() && briefing().goals.contains(pose().cell)) return Action::step(0, 0);
  return choose();
}

Action MoveMapper::race() {
  if (briefing().goals.contains(pose().cell)) return Action::step(0, 0);
  if (plan_.empty()) {
    const auto found = find_routes().found();
    const auto is_before = [&](Cell a, Cell b) {
      const auto rank = [&](Cell cell) { return std::tuple(!briefing().goals.contains(cell), cell.x, cell.y); };
      return rank(a) < rank(b);
    };
    plan_to(*std::min_element(found.begin(), found.end(), is_before));
  }
  return follow();
}

const SearchTree& MoveMapper::find_routes() {
  routes_.grow(map_, pose());
  return routes_;
}

void MoveMapper::plan_to(Cell target) {
  for (Cell cell = target; routes_.distance(cell) > 0; cell = routes_.before(cell)) plan_.push_back(cell);
}

Action MoveMapper::follow() {
  const Cell next = plan_.back();
  plan_.pop_back();
  return go_to(next);
}

Action MoveMapper::go_to(Cell cell) const {
  const Move move = move_between(pose().cell, cell);
  return move_in(pose().heading, move.direction, move.cells);
}

}  // namespace labmouse
