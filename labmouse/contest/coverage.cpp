#include "labmouse/contest/coverage.hpp"

#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

bool explores(const StepRecord& step) { return step.run == Run::search_run; }

/// The cells of the corridors that a reading shows.
void insert_seen(const StepRecord& step, Size size, CellSet& cells) {
  for (const int side : {-1, 0, 1}) {
    const Heading heading = turned(step.pose.heading, side);
    Cell cell = neighbour(step.pose.cell, heading);
    for (int open = step.sighting.towards(side); open > 0 && size.contains(cell); --open) {
      cells.insert(cell);
      cell = neighbour(cell, heading);
    }
  }
}

ExploredCells explored_cells(const RunRecord& record, Size size, const CellSet& reachable) {
  ExploredCells cells;
  for (const Cell cell : explored_way(record, size)) cells.visited.insert(cell);
  cells.discovered = cells.visited;
  for (const StepRecord& step : record.steps)
    if (explores(step)) insert_seen(step, size, cells.discovered);
  cells.reachable = reachable;
  return cells;
}

double share(CellSet part, const CellSet& whole) {
  part &= whole;
  return part.count() / static_cast<double>(whole.count());
}

}  // namespace

std::vector<Cell> entered_cells(const StepRecord& step, const Pose& next, Size size) {
  std::vector<Cell> cells;
  if (step.action.kind != Action::Kind::step) return cells;
  const Heading direction = step.action.movement < 0 ? opposite(next.heading) : next.heading;
  for (Cell cell = step.pose.cell; cell != next.cell && size.contains(cell);)
    if (size.contains(cell = neighbour(cell, direction))) cells.push_back(cell);
  return cells;
}

std::vector<Cell> explored_way(const RunRecord& record, Size size) {
  std::vector<Cell> way;
  for (std::size_t i = 0; i < record.steps.size() && explores(record.steps[i]); ++i) {
    const StepRecord& step = record.steps[i];
    if (i == 0 && size.contains(step.pose.cell)) way.push_back(step.pose.cell);
    const Pose next = i + 1 < record.steps.size() ? record.steps[i + 1].pose : record.end;
    for (const Cell cell : entered_cells(step, next, size)) way.push_back(cell);
  }
  return way;
}

Coverage coverage_of(const ExploredCells& cells) {
  return {share(cells.discovered, cells.reachable), share(cells.visited, cells.reachable)};
}

Coverage coverage_of(const RunRecord& record, Size size, const CellSet& reachable) {
  return coverage_of(explored_cells(record, size, reachable));
}

ExploredCells explored_cells(const RunRecord& record, const Maze& maze) {
  return explored_cells(record, maze.size(), reachable_cells(maze));
}

Coverage coverage_of(const RunRecord& record, const Maze& maze) {
  return coverage_of(record, maze.size(), reachable_cells(maze));
}

}  // namespace labmouse
