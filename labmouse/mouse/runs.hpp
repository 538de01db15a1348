// Runs from start to goal, in each world: the best known one, the best that may exist, and the unknown walls between
// them.
#pragma once

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/optimistic_routes.hpp"

namespace labmouse {

/// The runs in the world of steps.
class StrideRuns {
 public:
  explicit StrideRuns(const Briefing& briefing);

  /// Finds the runs by what is known now.
  void plan(const Knowledge& knowledge);

  /// Whether the best known run is the best of all.
  bool proven() const { return optimistic_.length() == known_ && known_ < unreachable; }
  /// Whether no run can exist.
  bool hopeless() const { return optimistic_.length() == unreachable; }
  /// The unknown walls of the best runs that may exist.
  const WallSet& unknown_walls() const { return optimistic_.unknown_walls(); }
  /// Whether this is the last moment at which a reset and the known run still fit into the steps that are left.
  bool last_call(int steps_left) const { return steps_left <= known_ + 1; }

 private:
  Briefing briefing_;
  DistanceField field_;
  OptimisticRoutes optimistic_;
  int known_ = unreachable;
};

/// The runs in the worlds in seconds, with the fields of the briefing.
class DriveRuns {
 public:
  explicit DriveRuns(const Briefing& briefing);

  /// Finds the runs by what is known now; returns whether it made a new plan. It does so only if a newly seen wall cuts
  /// the optimistic route: walls only raise times, so a route that is not cut stays the fastest.
  bool plan(const Knowledge& knowledge) { return plan(knowledge.possible(), knowledge); }
  /// The same over those possible passages that a strategy hopes for. Passages that it adds later are used only from
  /// the next new plan on.
  bool plan(const WallSet& optimistic, const Knowledge& knowledge);

  /// Makes the next call plan anew: passages that were left out are possible again.
  void forget() {
    planned_ = false;
    aimed_plans_ = 0;
  }

  /// Whether all walls of the optimistic route are open, so that it is the best known one, too. True if no route can be
  /// driven.
  bool proven() const { return unknown_.empty(); }
  const WallSet& unknown_walls() const { return unknown_; }

  /// The time of the fastest route that may exist.
  DriveTime optimistic_time() const { return time_; }
  /// The time of the fastest known one, or no_time if that is above a limit or there is none; searches for it.
  DriveTime known_time(const Knowledge& knowledge, DriveTime limit);

 private:
  Pose start_;
  CellSet goals_;
  FastestRoutes& routes_;
  DriveTime time_ = no_time;
  WallSet walls_;  ///< of the fastest route that may exist
  WallSet unknown_;
  bool planned_ = false;
  int aimed_plans_ = 0;  ///< plans until the bounds of the routes are found anew
};

}  // namespace labmouse
