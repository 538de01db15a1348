#include "labmouse/mouse/cellwise_explorer.hpp"

#include "labmouse/mouse/drive/drive_fields.hpp"

namespace labmouse {
namespace {

/// A program that orders so often in a row nothing to drive does so for ever.
constexpr int most_idle = 10'000;

/// A wall that so many looks in a row did not show counts as closed.
constexpr int most_tries = 4;

}  // namespace

CellwiseExplorer::CellwiseExplorer(const Briefing& briefing) : DrivingExplorer(briefing), cell_(briefing.start.cell) {}

WallState CellwiseExplorer::state(Cell cell, Heading side) const {
  const Wall wall = wall_at(cell, side);
  return on_border(wall, briefing().size) ? WallState::closed : knowledge().state(wall);
}

Action CellwiseExplorer::explore() {
  settle();
  for (;;) {
    if (ended_) return end();
    if (pose().cell != cell_) return way_back();
    if (left_ > 0 && !is_blocked()) return move();
    const Order order = next_order();
    if (order.kind == Order::Kind::forfeit) return Action::forfeit(order.reason);
    idle_ = order.cells > 0 ? 0 : idle_ + 1;
    ended_ = order.kind == Order::Kind::end || idle_ > most_idle;
    direction_ = order.direction;
    left_ = order.cells;
    tries_ = 0;
  }
}

/// Counts the cells that the last action has driven: with a map whose walls can change, maybe fewer than it asked for.
void CellwiseExplorer::settle() {
  for (int cells = asked_; cells > 0; --cells)
    if (pose().cell == neighbour(cell_, direction_, cells)) {
      cell_ = pose().cell;
      left_ -= cells;
      tries_ = 0;
      break;
    }
  asked_ = 0;
}

bool CellwiseExplorer::is_blocked() const {
  return tries_ >= most_tries || state(cell_, direction_) == WallState::closed;
}

/// The cells that one action can drive: several where their walls are known, so that the mouse may dash.
int CellwiseExplorer::cells_ahead() const {
  int cells = 1;
  for (Cell next = neighbour(cell_, direction_); cells < left_; next = neighbour(next, direction_), ++cells)
    if (!knowledge().knows(next) || state(next, direction_) != WallState::open) break;
  return cells;
}

Action CellwiseExplorer::move() {
  ++tries_;
  // A wall behind a mouse at rest has not been seen: it turns to it and looks.
  const bool to_look = state(cell_, direction_) == WallState::unknown && pose().heading != direction_;
  asked_ = to_look ? 0 : cells_ahead();
  return search_step(pose().heading, direction_, asked_);
}

Action CellwiseExplorer::way_back() {
  SearchField& ways = briefing().drive.fields->ways();
  ways.fill(knowledge().open(), knowledge().known_cells(), CellSet::of(cell_));
  const Action step = ways.step(place());
  // If the map has changed and has no way to the program's cell, the contest mends the map.
  return step.kind == Action::Kind::step ? step : Action::forfeit(ForfeitReason::no_route);
}

/// A reset is only for a mouse that has entered a goal.
Action CellwiseExplorer::end() const {
  return goal_entered() ? Action::reset() : Action::forfeit(ForfeitReason::no_route);
}

}  // namespace labmouse
