#include "labmouse/strategies/cell_flood.hpp"

#include <cassert>

namespace labmouse {

CellFlood::CellFlood(const Briefing& briefing, TieOrder ties)
    : Explorer(briefing), ties_(ties), distance_(briefing.size, strides(1)) {
  for (int x = briefing.size.width - 1; x >= 0; --x)
    for (int y = 0; y < briefing.size.height; ++y)
      if (briefing.goals.contains({x, y})) goals_.push_back({x, y});
}

Action CellFlood::explore() {
  if (!goal_found_ && !goal_can_be_reached()) return Action::forfeit(ForfeitReason::no_route);
  if (!goal_found_ && pose().cell != goals_.back()) return step_towards(goals_.back());
  // The start may be the goal: it counts as entered only when a step ends there.
  if (!goal_entered()) return Action::step(0, 0);
  goal_found_ = true;
  return after_goal();
}

/// Drops goal cells that turned out to be unreachable. Returns whether one is left.
bool CellFlood::goal_can_be_reached() {
  const DistanceField& from_here = reachable();
  while (!goals_.empty() && !from_here.reaches(goals_.back())) goals_.pop_back();
  return !goals_.empty();
}

const DistanceField& CellFlood::reachable() {
  flood(knowledge().possible(), pose().cell);
  return distance_;
}

Action CellFlood::step_towards(Cell target) {
  const WallSet& passages = knowledge().possible();
  flood(passages, target);
  const auto [cell, heading] = pose();
  assert(cell != target);
  Heading best = opposite(heading);  // with walls on three sides it turns, too
  int least = unreachable + 1;       // without a way to the target, all directions are equal
  for (const Heading direction : ties_.from(heading)) {
    if (!passages.contains(wall_at(cell, direction)) || distance_.at(neighbour(cell, direction)) >= least) continue;
    least = distance_.at(neighbour(cell, direction));
    best = direction;
  }
  return best == opposite(heading) ? Action::step(90, 0) : move_in(heading, best, 1);
}

Action CellFlood::race() {
  const WallSet passages = map();
  flood(passages, goals_.back());
  if (distance_.at(pose().cell) == 0) return Action::step(0, 0);
  Move last;
  for (const Heading direction : ties_.from(pose().heading))
    if (const int cells = longest_descent(passages, direction); cells > 0) last = {direction, cells};
  assert(last.cells > 0);
  return move_in(pose().heading, last.direction, last.cells);
}

/// Cells of the longest move in a direction in which each cell is one nearer to the goal; 0 if there is none.
int CellFlood::longest_descent(const WallSet& passages, Heading direction) const {
  int cells = 0;
  for (Cell cell = pose().cell; cells < briefing().motion.longest; ++cells) {
    const Cell next = neighbour(cell, direction);
    if (!passages.contains(wall_at(cell, direction)) || distance_.at(next) + 1 != distance_.at(cell)) break;
    cell = next;
  }
  return cells;
}

void CellFlood::flood(const WallSet& passages, Cell from) {
  CellSet cells;
  cells.insert(from);
  distance_.fill(passages, cells);
}

WallSet passages_among(const CellSet& cells, const WallSet& passages) {
  WallSet among;
  passages.for_each([&](Wall wall) {
    if (cells.contains(wall.cell) && cells.contains(neighbour(wall.cell, wall.side))) among.insert(wall);
  });
  return among;
}

}  // namespace labmouse
