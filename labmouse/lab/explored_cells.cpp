#include "labmouse/lab/explored_cells.hpp"

#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

/// Adds the cells that a reading shows from a pose.
void add_shown(Size size, const StepRecord& step, CellSet& cells) {
  for (const int side : {-1, 0, 1}) {
    const Heading direction = turned(step.pose.heading, side);
    Cell cell = step.pose.cell;
    for (int shown = 0; shown < step.sighting.towards(side); ++shown) {
      cell = neighbour(cell, direction);
      if (!size.contains(cell)) break;
      cells.insert(cell);
    }
  }
}

}  // namespace

std::vector<int> exploration_visits(Size size, const RunRecord& record) {
  std::vector<int> visits(static_cast<std::size_t>(size.area()));
  const auto visit = [&](Cell cell) { ++visits[static_cast<std::size_t>(size.index(cell))]; };
  for (std::size_t i = 0; i < record.steps.size() && record.steps[i].run == Run::exploration; ++i) {
    const StepRecord& step = record.steps[i];
    if (i == 0) visit(step.pose.cell);
    if (step.action.kind != Action::Kind::step) continue;
    const Pose next = i + 1 < record.steps.size() ? record.steps[i + 1].pose : record.end;
    const Heading direction = step.action.movement < 0 ? opposite(next.heading) : next.heading;
    for (Cell cell = step.pose.cell; cell != next.cell;) {
      cell = neighbour(cell, direction);
      if (!size.contains(cell)) break;
      visit(cell);
    }
  }
  return visits;
}

ExploredCells explored_cells(const Maze& maze, const RunRecord& record) {
  ExploredCells cells;
  cells.reachable = reachable_cells(maze);
  const auto visits = exploration_visits(maze.size(), record);
  for (int index = 0; index < maze.size().area(); ++index)
    if (visits[static_cast<std::size_t>(index)] > 0) cells.visited.insert(maze.size().cell_at(index));
  cells.discovered = cells.visited;
  for (const StepRecord& step : record.steps)
    if (step.run == Run::exploration) add_shown(maze.size(), step, cells.discovered);
  return cells;
}

}  // namespace labmouse
