#include "labmouse/contest/simulator.hpp"

#include <algorithm>
#include <utility>

namespace labmouse {
namespace {

/// How a contest ends whose steps are used up.
Outcome outcome_at_the_end_of_steps(Run run, bool goal_entered) {
  if (run == Run::speed) return Outcome::speed_run_unfinished;
  return goal_entered ? Outcome::never_reset : Outcome::out_of_steps;
}

std::vector<Count> counts_of(const Strategy& mouse) {
  std::vector<Count> counts;
  for (const Counter& counter : mouse.counters()) counts.push_back({std::string(counter.name), counter.value});
  std::sort(counts.begin(), counts.end(), [](const Count& a, const Count& b) { return a.name < b.name; });
  return counts;
}

}  // namespace

Briefing brief(const Maze& maze, const Rules& rules, std::uint64_t seed) {
  return {maze.size(), {maze.start(), maze.start_heading()}, maze.goals(), strides(rules.stride), rules.budget, seed};
}

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

RunRecord run(const Maze& maze, const Rules& rules, Strategy& mouse) {
  const Pose start = {maze.start(), maze.start_heading()};
  RunRecord record;
  Run run = Run::exploration;
  Pose pose = start;
  bool goal_entered = false;
  const auto end = [&](Outcome outcome) {
    record.outcome = outcome;
    record.end = pose;
    record.counts = counts_of(mouse);
    record.last_words = mouse.last_words();
    return std::move(record);
  };
  for (int step = 1; step <= rules.budget; ++step) {
    const Sighting sighting = look(maze, pose);
    const Action action = mouse.decide(sighting);
    record.steps.push_back({run, step, pose, sighting, action, false});
    if (const Reasons* reasons = mouse.reasons()) record.reasons.push_back({step, *reasons});
    switch (action.kind) {
      case Action::Kind::forfeit:
        return end(Outcome::forfeit);
      case Action::Kind::reset:
        // Before a goal was entered, or in the speed run, it costs its step and does nothing.
        if (run == Run::exploration && goal_entered) {
          run = Run::speed;
          pose = start;
        }
        break;
      case Action::Kind::step: {
        const StepResult result = perform(maze, rules, pose, action);
        record.steps.back().blocked = result.blocked;
        pose = result.pose;
        if (!maze.is_goal(pose.cell)) break;
        if (run == Run::speed) return end(Outcome::solved);
        goal_entered = true;
        break;
      }
    }
  }
  return end(outcome_at_the_end_of_steps(run, goal_entered));
}

}  // namespace labmouse
