#include "labmouse/maze/wall_follower.hpp"

#include <array>
#include <optional>

namespace labmouse {
namespace {

std::optional<Heading> next_heading(const Maze& maze, Cell cell, Heading heading, Hand hand) {
  const int towards = hand == Hand::left ? -1 : 1;
  for (const int quarters : {towards, 0, -towards, 2})
    if (const Heading side = turned(heading, quarters); maze.is_open(cell, side)) return side;
  return std::nullopt;
}

}  // namespace

bool wall_follower_arrives(const Maze& maze, Hand hand) {
  Cell cell = maze.start();
  Heading heading = maze.start_heading();
  std::array<CellSet, 4> been;  // visited cells by heading
  while (!maze.is_goal(cell)) {
    CellSet& been_so = been[static_cast<unsigned>(heading)];
    if (been_so.contains(cell)) return false;
    been_so.insert(cell);
    const auto next = next_heading(maze, cell, heading, hand);
    if (!next) return false;
    heading = *next;
    cell = neighbour(cell, heading);
  }
  return true;
}

}  // namespace labmouse
