// One contest in the world of steps that the caller advances action by action, for example in an interactive page.
#pragma once

#include <utility>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The sensor reading in a pose.
/// @param maze the true maze.
/// @param pose inside the maze.
/// @return open cells to the left, ahead and to the right, each up to the next wall.
Sighting look(const Maze& maze, Pose pose);

/// Where a step leads, and whether a wall ended it early.
struct StepResult {
  Pose pose;
  bool blocked = false;
};
/// Moves the mouse by one step: it turns, then moves until its cells are done or a wall blocks it.
/// @param maze the true maze.
/// @param rules the movement is cut to their stride.
/// @param pose inside the maze.
/// @param step a step, no reset and no forfeit.
StepResult perform(const Maze& maze, const Rules& rules, Pose pose, const Action& step);

/// Begins with the mouse at the start. The caller adds the mouse's own words, counts and reasons to the record.
class Contest {
 public:
  /// Puts the mouse at the start. A budget below 1 ends the contest at once.
  /// @param maze must outlive it.
  /// @param rules copied.
  Contest(const Maze& maze, const Rules& rules);

  /// Whether the contest is over: no further action is allowed.
  bool ended() const { return ended_; }
  /// The reading at the present pose.
  Sighting sighting() const { return sighting_; }
  /// Performs the next action and records it. The contest must not have ended. A reset before a goal was entered, or in
  /// the speed run, costs its step and does nothing.
  /// @param action a step, a reset or a forfeit, which ends the contest.
  void act(const Action& action);

  /// The record so far. Its outcome is valid only after the end.
  const RunRecord& record() const { return record_; }
  /// Moves the record out. Call it once, after the end.
  RunRecord take_record() { return std::move(record_); }

 private:
  void end(Outcome outcome);
  /// Performs a step. Returns whether it ended the contest.
  bool step(const Action& action);

  const Maze& maze_;
  Rules rules_;
  Run run_ = Run::search_run;
  Pose pose_;
  Sighting sighting_;
  bool goal_entered_ = false, ended_ = false;
  RunRecord record_;
};

}  // namespace labmouse
