#include "labmouse/mouse/cellwise_explorer.hpp"

#include "labmouse/mouse/drive/drive_fields.hpp"

namespace labmouse {
namespace {

/// A program that orders so often in a row nothing to drive does so for ever.
constexpr int most_idle = 10'000;

/// A wall counts as closed after so many actions in a row that did not lead through it.
constexpr int most_tries = 4;

}  // namespace

CellwiseExplorer::CellwiseExplorer(const Briefing& briefing)
    : DrivingExplorer(briefing), cell_(briefing.start.cell), was_in_goal_(briefing.goals.contains(cell_)) {}

WallState CellwiseExplorer::state(Cell cell, Heading side) const {
  const Wall wall = wall_at(cell, side);
  return on_border(wall, briefing().size) ? WallState::closed : knowledge().state(wall);
}

Action CellwiseExplorer::explore() {
  settle();
  for (;;) {
    if (ended_) return end();
    if (pose().cell != cell_) return way_to(CellSet::of(cell_));
    if (left_ > 0 && !is_blocked()) return move();
    const Order order = next_order();
    if (order.kind == Order::Kind::forfeit) return Action::forfeit(order.reason);
    idle_ = order.cells > 0 ? 0 : idle_ + 1;
    ended_ = order.kind == Order::Kind::end || idle_ > most_idle;
    if (ended_ && !was_in_goal_) return Action::forfeit(ForfeitReason::out_of_time);
    direction_ = order.direction;
    left_ = order.cells;
    tries_ = 0;
  }
}

/// Counts the cells that the last action has driven: with a map whose walls can change, maybe fewer than it asked for.
void CellwiseExplorer::settle() {
  for (int cells = asked_; cells > 0; --cells)
    if (pose().cell == neighbour(cell_, direction_, cells)) {
      for (int i = 1; i <= cells; ++i)
        was_in_goal_ = was_in_goal_ || briefing().goals.contains(neighbour(cell_, direction_, i));
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

/// Over known cells. A map whose walls can change may have no such way: then through walls that have to be looked at.
Action CellwiseExplorer::way_to(const CellSet& cells) {
  SearchField& ways = briefing().drive.fields->ways();
  for (const WallSet& passages : {knowledge().open(), knowledge().possible()}) {
    ways.fill(passages, knowledge().known_cells(), cells);
    if (const Action step = ways.step(place()); step.kind == Action::Kind::step) return step;
  }
  return Action::forfeit(ForfeitReason::no_route);
}

/// A reset is only for a mouse that has entered a goal and knows a route to it. If its map has changed, it goes there
/// again.
Action CellwiseExplorer::end() { return goal_entered() ? Action::reset() : way_to(briefing().goals); }

}  // namespace labmouse
