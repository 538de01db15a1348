#include "labmouse/mouse/driven_steps.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace labmouse {
namespace {

/// Time limits a contest in seconds; this many steps are for a program that needs a number.
constexpr int driven_budget = 100'000;

}  // namespace

Briefing steps_briefing(Briefing briefing) {
  briefing.motion = strides();
  briefing.budget = driven_budget;
  briefing.sight = max_side;
  briefing.drive = {};
  return briefing;
}

DrivenSteps::DrivenSteps(const Briefing& briefing, const WallSet& open, std::unique_ptr<Strategy> mouse)
    : CellwiseExplorer(briefing),
      open_(open),
      mouse_(std::move(mouse)),
      heading_(briefing.start.heading),
      longest_(steps_briefing(briefing).motion.longest),
      budget_(driven_budget) {}

int DrivenSteps::reading(Heading direction) const {
  for (int cells = 0;; ++cells) {
    const Cell at = neighbour(cell(), direction, cells);
    const WallState known = state(at, direction);
    if (known == WallState::closed || (known == WallState::unknown && !open_.contains(wall_at(at, direction))))
      return cells;
  }
}

CellwiseExplorer::Order DrivenSteps::next_order() {
  if (--budget_ < 0) return {.kind = Order::Kind::end};
  const Action action = mouse_->decide({reading(left_of(heading_)), reading(heading_), reading(right_of(heading_))});
  switch (action.kind) {
    case Action::Kind::forfeit:
      return {.kind = Order::Kind::forfeit, .reason = action.reason};
    case Action::Kind::reset:
      // Before a goal it does nothing, as in the world of steps.
      return {.kind = was_in_goal() ? Order::Kind::end : Order::Kind::move};
    case Action::Kind::step:
      break;
  }
  heading_ = rotated(heading_, action.rotation);
  const int cells = std::clamp(action.movement, -longest_, longest_);
  return {.direction = cells < 0 ? opposite(heading_) : heading_, .cells = std::abs(cells)};
}

}  // namespace labmouse
