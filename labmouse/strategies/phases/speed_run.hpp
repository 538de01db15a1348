// The third phase of `phases`: the run on the shortest known route.
#pragma once

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// The briefing with the moves of the speed run, which the parameter `speed` may shorten.
Briefing briefing_for_speed(Briefing briefing, const Settings& settings);

class SpeedRun {
 public:
  /// Reads the parameter `speed`, and allocates all memory.
  SpeedRun(const Briefing& briefing, const Settings& settings);

  /// Cost of the run if it began now, in steps.
  int length(const Knowledge& knowledge);
  /// Plans the route. It is not changed later, except with `speed=strides-updating`.
  void plan(const Knowledge& knowledge);
  /// The next action on it.
  Action next(const Knowledge& knowledge, Pose pose);

 private:
  Cell start_;
  CellSet goals_;
  bool updating_;
  DistanceField field_;
  WallSet passages_;
};

}  // namespace labmouse
