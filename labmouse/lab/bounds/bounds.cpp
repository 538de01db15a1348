#include "labmouse/lab/bounds/bounds.hpp"

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/mouse/route.hpp"

namespace labmouse {

std::vector<Action> shortest_run(const Maze& maze, const Rules& rules) {
  DistanceField to_goal(maze.size(), strides(rules.stride));
  to_goal.fill(maze.open_walls(), maze.goals());
  Pose pose = {maze.start(), maze.start_heading()};
  if (!to_goal.reaches(pose.cell)) return {};
  std::vector<Action> actions;
  do {
    actions.push_back(step_along(to_goal, maze.open_walls(), pose));
    pose = after(pose, actions.back());
  } while (!maze.is_goal(pose.cell));
  return actions;
}

Bound bound_of(const Maze& maze, const Rules& rules) {
  const int steps = static_cast<int>(shortest_run(maze, rules).size());
  if (steps == 0) return {};
  return {steps, score_of(steps + 1, steps, rules)};
}

std::unique_ptr<Strategy> make_oracle(const Maze& maze, const Rules& rules) {
  std::vector<Action> actions = shortest_run(maze, rules);
  const std::vector<Action> again = actions;
  actions.push_back(Action::reset());
  actions.insert(actions.end(), again.begin(), again.end());
  return std::make_unique<Script>(maze.size(), std::move(actions));
}

}  // namespace labmouse
