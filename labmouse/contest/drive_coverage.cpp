#include "labmouse/contest/drive_coverage.hpp"

#include <algorithm>
#include <cstdlib>

namespace labmouse {
namespace {

/// Inserts the cells on the straight line between two cells, without the first.
void insert_way(Cell from, Cell to, CellSet& cells) {
  const auto sign = [](int value) { return (value > 0) - (value < 0); };
  const int dx = sign(to.x - from.x), dy = sign(to.y - from.y);
  for (int i = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)); i > 0; --i) {
    from = {from.x + dx, from.y + dy};
    cells.insert(from);
  }
}

}  // namespace

Coverage coverage_of(const DriveRecord& record, const Maze& maze, const CellSet& reachable) {
  CellSet visited;
  visited.insert(maze.start());
  MazeTime end = 0;
  for (const DriveRun& run : record.runs) {
    if (run.has_route()) break;
    end = run.end;
    for (const SearchMove& move : run.moves) insert_way(move.from.cell, move.to.cell, visited);
  }
  CellSet discovered = visited;
  for (const WallSeen& seen : record.walls) {
    if (!seen.open || seen.time > end) continue;
    discovered.insert(seen.wall.cell);
    discovered.insert(neighbour(seen.wall.cell, seen.wall.side));
  }
  return coverage_of({discovered, visited, reachable});
}

}  // namespace labmouse
