// Steps of a searching mouse towards some cells, in each world.
#pragma once

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/drive/search_field.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/route.hpp"

namespace labmouse {

/// In steps, by the moves of the briefing's motion.
class StrideWays {
 public:
  explicit StrideWays(const Briefing& briefing) : field_(briefing.size, briefing.motion) {}

  /// A step to some cells over walls that may be open: as far as these are known, or a turn to look at an unknown one.
  Action step_towards(const CellSet& cells, const Knowledge& knowledge, const Pose& pose) {
    field_.fill(knowledge.possible(), cells);
    return optimistic_step(field_, knowledge, pose);
  }
  /// A step to the nearest of some cells over known passages, in order to look from there.
  Action step_to_look(const CellSet& cells, const Knowledge& knowledge, const Pose& pose) {
    field_.fill(knowledge.open(), cells);
    return step_along(field_, knowledge.open(), pose);
  }

 private:
  DistanceField field_;
};

/// In seconds, with the fields of the briefing.
class SearchWays {
 public:
  explicit SearchWays(const Briefing& briefing);

  /// A step to some cells over walls that may be open, also to look from there. Readings show little here, so a way
  /// through unseen walls shows more than one round them, and it is shorter.
  Action step_towards(const CellSet& cells, const Knowledge& knowledge, const SearchPlace& place);

 private:
  SearchField& field_;
};

/// A step along a field over walls that may be open: as far as these are known, or a turn to look at an unknown one.
Action hopeful_step(const SearchField& field, const Knowledge& knowledge, const SearchPlace& place);

/// The cells from which one of the walls can be seen, along a corridor of open walls.
CellSet viewpoints_of(const WallSet& walls, const Knowledge& knowledge, int sight);

}  // namespace labmouse
