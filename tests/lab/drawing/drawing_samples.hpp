// What the tests of drawings draw.
#pragma once

#include <string_view>
#include <vector>

#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

/// Three by three cells: two walls lead from the start around the west of the goal in the middle.
//   o---o---o---o
//   |       |   |
//   o   o   o   o
//   |   | G     |
//   o   o---o   o
//   | S |       |
//   o---o---o---o
inline Maze ring() {
  MazeDraft draft({3, 3}, MazeDraft::Inside::open);
  draft.close({0, 0}, Heading::east);
  draft.close({0, 1}, Heading::east);
  draft.close({1, 1}, Heading::south);
  draft.close({1, 2}, Heading::east);
  return Maze(draft);
}

inline Maze empty(Size size) { return Maze(MazeDraft(size, MazeDraft::Inside::open)); }

/// From the start through (0,2) and (1,2) down to the goal.
inline std::vector<Pose> way_to_goal() {
  return {{{0, 0}, Heading::north}, {{0, 2}, Heading::north}, {{1, 2}, Heading::east}, {{1, 1}, Heading::south}};
}

/// The same way as a search run that goes back to (1,2) and on into the south-east from there.
inline SearchLegs search_run() {
  return {way_to_goal(),
          {{{1, 1}, Heading::south}, {{2, 1}, Heading::east}, {{2, 0}, Heading::south}, {{1, 0}, Heading::west}}};
}

/// Explored cells of the ring: six visited, eight discovered, nine reachable.
inline ExploredCells explored() {
  ExploredCells cells;
  cells.reachable = CellSet::all({3, 3});
  cells.discovered = CellSet::all({3, 3});
  cells.discovered.erase({2, 2});
  cells.visited = CellSet::all({3, 2});
  return cells;
}

inline int count(std::string_view text, std::string_view part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

}  // namespace labmouse
