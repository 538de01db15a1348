// The fastest routes of a maze, exactly.
//
// The search goes outward from the goals, backwards in time, over two layers of every node: a turn begins here, and a
// straight begins here. Turns lead from one to the other, and straights of all lengths back, so that between two turns
// there is one straight, accelerated and braked as one.
#pragma once

#include <memory>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// Times to the goals from all nodes of a maze up to 32×32, and the routes. Takes all memory that it will need.
class FastestRoutes {
 public:
  /// The tables must outlive it.
  FastestRoutes(Size size, const DriveTables& tables);
  ~FastestRoutes();
  FastestRoutes(FastestRoutes&&) noexcept;
  FastestRoutes& operator=(FastestRoutes&&) noexcept;

  /// Computes all times over the given passages (all inside the size) to the given cells.
  void fill(const WallSet& passages, const CellSet& goals);
  /// The same for one start: only the fastest routes from there are sure to be found, and other times are upper limits.
  /// Sooner done, but for the first time with a start: what there is to know of it beforehand is found then, and kept.
  void fill_for(Pose start, const WallSet& passages, const CellSet& goals);

  /// The time from rest in the middle of the start cell, or no_time.
  DriveTime time_from(Pose start) const;
  /// Writes a fastest route: of those equally fast the first in a fixed order. One without segments and with no_time
  /// where there is none; in a goal, one without segments that takes no time.
  void route_from(Pose start, DriveRoute& route) const;

  /// The time from a node where a straight (of any length, or none) begins behind a turn that ended in that lane, or
  /// no_time; whatever where no turn can end there in that lane. For comparison with other searches.
  DriveTime rolling(const DriveNode& node, std::size_t lane) const;

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

/// The walls that a route passes: it can be driven where all of them are open.
WallSet walls_of(const DriveRoute& route, const DriveTables& tables);

}  // namespace labmouse
