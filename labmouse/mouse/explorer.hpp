// What every mouse of our own has in common: it keeps track of where it stands, learns what it sees, and in the speed
// run takes the shortest route that it knows. What is left to the mind is where to explore and when to stop.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/route.hpp"
#include "labmouse/mouse/strategy.hpp"

namespace labmouse {

class DriveFields;
class SearchClock;

/// A strategy with the bookkeeping done. A mind derives from it and writes explore(). In seconds it goes home when the
/// time would not allow it after another step, and has no more to do when it has run.
class Explorer : public Strategy {
 public:
  explicit Explorer(const Briefing& briefing);
  ~Explorer() override;

  Action decide(const Sighting& seen) final;
  void show(const Pose& pose, const Sighting& seen) final;
  void searches_at(double pace) final;
  void carried(std::int64_t clock) final;
  bool considers() const final { return clock_ != nullptr; }
  Action consider(const Belief& belief, const SearchPlace& place, std::int64_t time) final;
  const Knowledge& knowledge() const final { return knowledge_; }
  /// In seconds, `replanned`: how often it planned anew.
  std::span<const Counter> counters() const override;

 protected:
  /// One action of the exploration. Moves must lead through walls known to be open; a reset is only for a mouse that
  /// has entered a goal.
  virtual Action explore() = 0;
  /// One action of the speed run; unless a mind has its own, the next on the shortest known route, planned anew at each
  /// step because the readings may have shown a shorter one.
  virtual Action race();

  /// Walls are not what they were taken for: what was planned by them is to be planned anew at the next explore().
  virtual void renew() {}

  /// In seconds it has fields to plan in, which all parts of a mind share.
  const Briefing& briefing() const { return briefing_; }
  const Pose& pose() const { return pose_; }
  /// The same in seconds, where it matters whether the mouse stands.
  SearchPlace place() const { return {pose_, at_rest_}; }
  /// The reading in the present pose.
  const Sighting& seen() const { return seen_; }
  /// Whether a step of the exploration has ended in a goal, so that a reset is allowed.
  bool goal_entered() const { return goal_entered_; }
  /// Cells in which the mouse has stood in the exploration, its start and the present one among them.
  const CellSet& visited() const { return visited_; }
  /// Steps that the budget still allows, the present one among them.
  int steps_left() const { return briefing_.budget - steps_; }
  /// In seconds: what is left of the time in the maze, in microseconds.
  std::int64_t time_left() const;

  /// Notes that the present decision took a new plan.
  void count_plan() { ++counters_.front().value; }

  /// labmouse::optimistic_step with what is known here.
  Action optimistic_step(const DistanceField& optimistic) const {
    return labmouse::optimistic_step(optimistic, knowledge_, pose_);
  }

 private:
  Action decide();
  void arrive();
  bool must_go_home_before(const Action& action);
  void perform(const Action& action);
  void move(const Action& step);

  std::unique_ptr<DriveFields> fields_;  ///< in seconds, where they are its own
  Briefing briefing_;
  Knowledge knowledge_;
  Pose pose_;
  Sighting seen_;
  CellSet visited_;
  DistanceField to_goal_;
  int steps_ = 0;
  int version_ = 0;  ///< of the belief that it knows
  bool at_rest_ = true;
  bool goal_entered_ = false;
  bool racing_ = false;
  std::array<Counter, 1> counters_ = {Counter{"replanned", 0}};
  std::unique_ptr<SearchClock> clock_;  ///< in seconds
};

}  // namespace labmouse
