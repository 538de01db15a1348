// One contest in the world of steps that the caller advances action by action, for example in an interactive page.
#pragma once

#include <utility>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The sensor reading in that pose.
Sighting look(const Maze& maze, Pose pose);

/// Where a step leads, and whether a wall ended it early.
struct StepResult {
  Pose pose;
  bool blocked = false;
};
/// Moves the mouse by one step.
/// @param pose inside the maze.
/// @param step a step, no reset and no forfeit; its movement is cut to the stride of the rules.
StepResult perform(const Maze& maze, const Rules& rules, Pose pose, const Action& step);

/// Begins with the mouse at the start. The caller adds the mouse's own words, counts and reasons to the record.
class Contest {
 public:
  /// The maze must outlive it.
  Contest(const Maze& maze, const Rules& rules);

  bool ended() const { return ended_; }
  /// The reading at the present pose.
  Sighting sighting() const { return sighting_; }
  /// Performs the next action; the contest must not have ended.
  void act(const Action& action);

  /// The record so far. Its outcome is valid only after the end.
  const RunRecord& record() const { return record_; }
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
