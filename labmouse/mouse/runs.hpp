// Runs from start to goal, in each world: the best that is known, the best that may exist, and what to look at to tell.
#pragma once

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/optimistic_routes.hpp"

namespace labmouse {

/// In steps.
class StrideRuns {
 public:
  explicit StrideRuns(const Briefing& briefing);

  /// Finds the runs by what is known now.
  void plan(const Knowledge& knowledge);

  /// Whether the best known run is the best of all.
  bool proven() const { return hoped_.length() == known_ && known_ < unreachable; }
  /// Whether no run can exist.
  bool hopeless() const { return hoped_.length() == unreachable; }
  /// The unknown walls of the best runs that may exist.
  const WallSet& unknown_walls() const { return hoped_.unknown_walls(); }
  /// Whether this is the last moment at which a reset and the known run still fit into the steps that are left.
  bool last_call(int steps_left) const { return steps_left <= known_ + 1; }

 private:
  Briefing briefing_;
  DistanceField field_;
  OptimisticRoutes hoped_;
  int known_ = unreachable;
};

/// In seconds, with the fields of the briefing.
class DriveRuns {
 public:
  explicit DriveRuns(const Briefing& briefing);

  /// Finds the runs by what is known now; whether it had to plan for that. Plans anew only where a newly seen wall cuts
  /// the route that was hoped for: walls only raise times, so that one that is not cut stays the fastest.
  bool plan(const Knowledge& knowledge) { return plan(knowledge.possible(), knowledge.open()); }
  /// The same over passages that a strategy hopes for; those that come to its hopes later are seen with the next new
  /// plan.
  bool plan(const WallSet& hoped, const WallSet& open);

  /// Plans anew the next time: walls have come back that it had left out.
  void forget() { planned_ = false; }

  /// Once all walls of the hoped-for route are open, it is the best known one, too. Nothing is left to prove where no
  /// route can be driven.
  bool proven() const { return unknown_.empty(); }
  const WallSet& unknown_walls() const { return unknown_; }

  /// The time of the fastest route that may exist.
  DriveTime hoped_time() const { return time_; }
  /// The time of the fastest known one, or no_time; searches for it.
  DriveTime known_time(const Knowledge& knowledge);

 private:
  Pose start_;
  CellSet goals_;
  FastestRoutes& routes_;
  DriveTime time_ = no_time;
  WallSet walls_;  ///< of the fastest route that may exist
  WallSet unknown_;
  bool planned_ = false;
};

}  // namespace labmouse
