// One contest that goes on, an action at a time: for whoever cannot wait in a loop until a mouse has decided.
#pragma once

#include <utility>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// What a mouse in that pose reads.
Sighting look(const Maze& maze, Pose pose);

/// Where a step leads, and whether a wall ended it early.
struct StepResult {
  Pose pose;
  bool blocked = false;
};
StepResult perform(const Maze& maze, const Rules& rules, Pose pose, const Action& step);

/// Begins with the mouse at the start. What the mouse itself has to add to the record, its words, counts and reasons,
/// is left to the caller.
class Contest {
 public:
  /// The maze must outlive it.
  Contest(const Maze& maze, const Rules& rules);

  bool ended() const { return ended_; }
  /// What is read where the mouse stands.
  Sighting sighting() const { return sighting_; }
  /// The next action of a contest that has not ended.
  void act(const Action& action);

  /// All that happened so far. The outcome counts once the contest has ended.
  const RunRecord& record() const { return record_; }
  RunRecord take_record() { return std::move(record_); }

 private:
  void end(Outcome outcome);
  /// Performs a step; whether the contest is over by it.
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
