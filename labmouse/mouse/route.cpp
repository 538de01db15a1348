#include "labmouse/mouse/route.hpp"

namespace labmouse {
namespace {

/// The longest move in a direction that lies on a cheapest route; 0 where none does.
int cells_on_route(const DistanceField& field, const WallSet& passages, Cell from, Heading direction) {
  const Motion& motion = field.motion();
  const int distance = field.at(from);
  int longest = 0;
  Cell cell = from;
  for (int cells = 1; cells <= motion.longest && passages.contains(wall_at(cell, direction)); ++cells) {
    cell = neighbour(cell, direction);
    if (field.at(cell) + motion.cost[static_cast<unsigned>(cells)] == distance) longest = cells;
  }
  return longest;
}

}  // namespace

std::optional<Move> next_move(const DistanceField& field, const WallSet& passages, Pose pose) {
  if (!field.reaches(pose.cell)) return std::nullopt;
  for (const int quarters : {0, -1, 1, 2}) {
    const Heading direction = turned(pose.heading, quarters);
    if (const int cells = cells_on_route(field, passages, pose.cell, direction); cells > 0)
      return Move{direction, cells};
  }
  return std::nullopt;
}

Action step_along(const DistanceField& field, const WallSet& passages, Pose pose) {
  if (field.at(pose.cell) == 0) return Action::step(0, 0);
  const auto move = next_move(field, passages, pose);
  return move ? move_in(pose.heading, move->direction, move->cells) : Action::forfeit(ForfeitReason::no_route);
}

Action optimistic_step(const DistanceField& optimistic, const Knowledge& knowledge, Pose pose) {
  const auto move = next_move(optimistic, knowledge.possible(), pose);
  if (!move) return Action::forfeit(ForfeitReason::no_route);
  int known = 0;
  Cell cell = pose.cell;
  while (known < move->cells && knowledge.open().contains(wall_at(cell, move->direction))) {
    cell = neighbour(cell, move->direction);
    ++known;
  }
  // Only the wall behind can be unknown: the other three were just read.
  return known > 0 ? move_in(pose.heading, move->direction, known) : Action::step(90, 0);
}

}  // namespace labmouse
