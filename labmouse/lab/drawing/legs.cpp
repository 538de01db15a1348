#include "labmouse/lab/drawing/legs.hpp"

#include <cstdlib>

namespace labmouse::drawing {
namespace {

/// The direction from one cell to another in the same row or column.
std::optional<Heading> direction_between(Cell from, Cell to) {
  if (from == to || (from.x != to.x && from.y != to.y)) return std::nullopt;
  if (from.x == to.x) return to.y > from.y ? Heading::north : Heading::south;
  return to.x > from.x ? Heading::east : Heading::west;
}

Leg leg_between(const Maze& maze, Cell from, Cell to) {
  const auto direction = direction_between(from, to);
  const int length = std::abs(to.x - from.x) + std::abs(to.y - from.y);
  if (!direction || maze.corridor(from, *direction) < length) return {from, to, std::nullopt, 0};
  return {from, to, direction, length};
}

}  // namespace

std::vector<Leg> legs_of(const Maze& maze, const std::vector<Pose>& route) {
  std::vector<Leg> legs;
  for (std::size_t step = 1; step < route.size(); ++step)
    legs.push_back(leg_between(maze, route[step - 1].cell, route[step].cell));
  return legs;
}

int length_of(const std::vector<Leg>& legs) {
  int cells = 0;
  for (const Leg& leg : legs) cells += leg.length;
  return cells;
}

bool revisits(const std::vector<Leg>& legs) {
  CellSet seen;
  if (!legs.empty()) seen.insert(legs.front().from);
  for (const Leg& leg : legs) {
    for (int gone = 1; gone <= leg.length; ++gone) {
      const Cell cell = neighbour(leg.from, *leg.direction, gone);
      if (seen.contains(cell)) return true;
      seen.insert(cell);
    }
  }
  return false;
}

}  // namespace labmouse::drawing
