// The third phase of `phases`: the run on the shortest known route.
#pragma once

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/distance.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// The briefing with the moves of the speed run in place of the world's: the parameter `speed` may shorten them.
Briefing briefing_for_speed(Briefing briefing, const Settings& settings);

class SpeedRun {
 public:
  /// Takes the parameter `speed`, and all memory.
  SpeedRun(const Briefing& briefing, const Settings& settings);

  /// What the run would cost if it began now.
  int length(const Knowledge& knowledge);
  /// Plans the route. Unless readings on the way shall count, it stays as it is planned here.
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
