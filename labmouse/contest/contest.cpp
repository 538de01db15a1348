#include "labmouse/contest/contest.hpp"

#include <algorithm>
#include <cassert>

#include "labmouse/mouse/motion.hpp"

namespace labmouse {
namespace {

/// Outcome of a contest that has used all its steps.
Outcome outcome_at_the_end_of_steps(Run run, bool goal_entered) {
  if (run == Run::speed) return Outcome::speed_run_unfinished;
  return goal_entered ? Outcome::never_reset : Outcome::out_of_steps;
}

}  // namespace

Sighting look(const Maze& maze, Pose pose) {
  return {maze.corridor(pose.cell, left_of(pose.heading)), maze.corridor(pose.cell, pose.heading),
          maze.corridor(pose.cell, right_of(pose.heading))};
}

StepResult perform(const Maze& maze, const Rules& rules, Pose pose, const Action& step) {
  pose.heading = rotated(pose.heading, step.rotation);
  const int movement = std::clamp(step.movement, -rules.stride, rules.stride);
  const Heading direction = movement < 0 ? opposite(pose.heading) : pose.heading;
  for (int cells = movement < 0 ? -movement : movement; cells > 0; --cells) {
    if (!maze.is_open(pose.cell, direction)) return {pose, true};
    pose.cell = neighbour(pose.cell, direction);
  }
  return {pose, false};
}

Contest::Contest(const Maze& maze, const Rules& rules)
    : maze_(maze), rules_(rules), pose_{maze.start(), maze.start_heading()}, sighting_(look(maze, pose_)) {
  record_.end = pose_;
  if (rules.budget < 1) end(Outcome::out_of_steps);
}

void Contest::act(const Action& action) {
  assert(!ended_);
  const int clock = static_cast<int>(record_.steps.size()) + 1;
  record_.steps.push_back({run_, clock, pose_, sighting_, action, false});
  switch (action.kind) {
    case Action::Kind::forfeit:
      return end(Outcome::forfeit);
    case Action::Kind::reset:
      // Before a goal was entered, or in the speed run, it costs its step and does nothing.
      if (run_ == Run::search_run && goal_entered_) {
        run_ = Run::speed;
        pose_ = {maze_.start(), maze_.start_heading()};
      }
      break;
    case Action::Kind::step:
      if (step(action)) return end(Outcome::finished);
      break;
  }
  if (clock >= rules_.budget) return end(outcome_at_the_end_of_steps(run_, goal_entered_));
  sighting_ = look(maze_, pose_);
}

bool Contest::step(const Action& action) {
  const StepResult result = perform(maze_, rules_, pose_, action);
  record_.steps.back().blocked = result.blocked;
  pose_ = result.pose;
  if (!maze_.is_goal(pose_.cell)) return false;
  goal_entered_ = true;
  return run_ == Run::speed;
}

void Contest::end(Outcome outcome) {
  ended_ = true;
  record_.outcome = outcome;
  record_.end = pose_;
}

}  // namespace labmouse
