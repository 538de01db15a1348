#include "labmouse/lab/replays/lost_steps.hpp"

#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/mouse/distance.hpp"

namespace labmouse {

LossMeter::LossMeter(const Maze& maze, const Rules& rules)
    : size_(maze.size()),
      goal_(static_cast<std::size_t>(size_.area())),
      distances_(goal_.size()),
      optimum_(bound_of(maze, rules).optimum.value_or(0)) {
  DistanceField to_goal(size_, strides(rules.stride));
  to_goal.fill(maze.open_walls(), maze.goals());
  to_goal.copy_to(distances_);
  for (std::size_t i = 0; i < goal_.size(); ++i) goal_[i] = maze.is_goal(size_.cell_at(static_cast<int>(i)));
}

std::vector<int> LossMeter::by_step(const RunRecord& record) const {
  std::vector<int> losses(record.steps.size());
  if (optimum_ == 0) return losses;
  Run run = Run::search_run;
  // What is left of the run before the step; a run begins with all of the shortest one.
  int left = optimum_;
  bool goal_entered = false;
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const StepRecord& step = record.steps[i];
    const StepRecord* next = i + 1 < record.steps.size() ? &record.steps[i + 1] : nullptr;
    if (step.run != run) {
      run = step.run;
      left = optimum_;
    }
    const auto end = static_cast<std::size_t>(size_.index((next != nullptr ? next->pose : record.end).cell));
    const bool goes_back = run == Run::search_run && next != nullptr && next->run == Run::speed;
    // A reset ends in no goal, wherever the mouse stands; nor does it lead away from one.
    goal_entered = goal_entered || (step.action.kind == Action::Kind::step && goal_[end]);
    const bool arrived = run == Run::search_run && goal_entered;
    const int after = arrived ? 0 : distances_[end];
    if (!goes_back) losses[i] = 1 + after - left;
    left = after;
  }
  return losses;
}

std::optional<LostSteps> LossMeter::lost(const RunRecord& record) const {
  if (record.outcome != Outcome::finished) return std::nullopt;
  LostSteps lost = {std::vector<int>(distances_.size()), std::vector<int>(distances_.size())};
  const std::vector<int> losses = by_step(record);
  for (std::size_t i = 0; i < losses.size(); ++i) {
    const StepRecord& step = record.steps[i];
    (step.run == Run::speed ? lost.speed : lost.search_run)[static_cast<std::size_t>(size_.index(step.pose.cell))] +=
        losses[i];
  }
  return lost;
}

}  // namespace labmouse
