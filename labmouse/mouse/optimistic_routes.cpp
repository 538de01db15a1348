#include "labmouse/mouse/optimistic_routes.hpp"

#include <array>

namespace labmouse {

OptimisticRoutes::OptimisticRoutes(const Briefing& briefing)
    : size_(briefing.size),
      goals_(briefing.goals),
      field_(briefing.size, briefing.motion),
      start_costs_(static_cast<std::size_t>(briefing.size.area())),
      goal_costs_(static_cast<std::size_t>(briefing.size.area())) {
  start_.insert(briefing.start.cell);
}

void OptimisticRoutes::plan(const Knowledge& knowledge) {
  field_.fill(knowledge.possible(), start_);
  field_.copy_to(start_costs_);
  field_.fill(knowledge.possible(), goals_);
  field_.copy_to(goal_costs_);
  walls_ = WallSet();
  start_.for_each([&](Cell start) { length_ = goal_cost(start); });
  if (length_ == unreachable) return;
  for (int index = 0; index < size_.area(); ++index) {
    const Cell cell = size_.cell_at(index);
    if (start_cost(cell) + goal_cost(cell) != length_) continue;
    for (const Heading direction : all_headings) add_walls(knowledge, cell, direction);
  }
}

/// Adds the unknown walls of those straight moves from a cell that lie on a shortest route.
void OptimisticRoutes::add_walls(const Knowledge& knowledge, Cell from, Heading direction) {
  const Motion& motion = field_.motion();
  std::array<Wall, Motion::max_longest> passed;
  unsigned count = 0;
  Cell cell = from;
  for (int cells = 1; cells <= motion.longest; ++cells) {
    const Wall wall = wall_at(cell, direction);
    if (!knowledge.possible().contains(wall)) return;
    if (!knowledge.open().contains(wall)) passed[count++] = wall;
    cell = neighbour(cell, direction);
    if (start_cost(from) + motion.cost[static_cast<unsigned>(cells)] + goal_cost(cell) == length_)
      for (unsigned i = 0; i < count; ++i) walls_.insert(passed[i]);
  }
}

}  // namespace labmouse
