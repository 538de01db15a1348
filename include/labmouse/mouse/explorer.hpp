// The common base of labmouse's own strategies for the world of steps (see motion.hpp). It tracks the pose, learns from
// readings, and takes the shortest known route in the speed run. The strategy decides where to explore and when to
// stop.
#pragma once

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/route.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

/// Base class of strategies for the world of steps, which implement explore().
class Explorer : public Strategy {
 public:
  /// Takes all memory that it will need.
  /// @param briefing in steps, with the start inside the maze and at least one goal.
  explicit Explorer(const Briefing& briefing);

  Action decide(const Sighting& seen) final;
  const Knowledge& knowledge() const final { return knowledge_; }

 protected:
  /// Chooses the next action of the search run.
  /// @return a step through walls known to be open; a reset, to begin the speed run, if goal_entered(); or a forfeit.
  virtual Action explore() = 0;
  /// Chooses the next action of the speed run. By default this is the next step on the shortest known route. The route
  /// is planned anew at each step, because the readings may have shown a shorter one.
  /// @return by default a forfeit with `no_route` if no known route leads to a goal.
  virtual Action race();

  /// The briefing that it was made with.
  const Briefing& briefing() const { return briefing_; }
  /// The present cell and heading.
  const Pose& pose() const { return pose_; }
  /// The reading in the present pose.
  const Sighting& seen() const { return seen_; }
  /// Whether a step of the search run has ended in a goal, so that a reset is allowed.
  bool goal_entered() const { return goal_entered_; }
  /// Cells in which the mouse has stood in the search run, its start and the present one among them.
  const CellSet& visited() const { return visited_; }
  /// Steps that the budget still allows, the present one among them.
  int steps_left() const { return briefing_.budget - steps_; }

  /// labmouse::optimistic_step() with what is known here.
  /// @param optimistic filled over knowledge().possible().
  Action optimistic_step(const DistanceField& optimistic) const {
    return labmouse::optimistic_step(optimistic, knowledge_, pose_);
  }

 private:
  void perform(const Action& action);
  void move(const Action& step);

  Briefing briefing_;
  Knowledge knowledge_;
  Pose pose_;
  Sighting seen_;
  CellSet visited_;
  DistanceField to_goal_;
  int steps_ = 0;
  bool goal_entered_ = false;
  bool racing_ = false;
};

}  // namespace labmouse
