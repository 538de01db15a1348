// A strategy for the world of steps that drives in seconds: its search run is driven by the controller, cell by cell;
// the way home and the speed run are those of the contest.
#pragma once

#include <memory>

#include "labmouse/mouse/cellwise_explorer.hpp"

namespace labmouse {

/// Its readings reach as far as in the world of steps, because it cannot work with less: the walls that the mouse has
/// detected are those of its map, right or wrong, and those farther away are as they are. Steps are performed as in the
/// world of steps: movements are cut to the longest step, and end at walls.
class DrivenSteps final : public CellwiseExplorer {
 public:
  /// @param briefing In seconds; `mouse` got steps_briefing() of it.
  /// @param open The open walls of the maze, for readings beyond the map.
  DrivenSteps(const Briefing& briefing, const WallSet& open, std::unique_ptr<Strategy> mouse);

  StrategyReport report() override { return mouse_->report(); }

 private:
  Order next_order() override;
  /// The number of open cells in a direction from its cell.
  int reading(Heading direction) const;

  WallSet open_;
  std::unique_ptr<Strategy> mouse_;
  Heading heading_;
  int longest_;
  int budget_;
};

/// The briefing of a strategy for the world of steps that drives in seconds.
Briefing steps_briefing(Briefing briefing);

}  // namespace labmouse
