// The fastest routes of a maze, exactly.
//
// The search goes outward from the goals, backwards in time, over two layers of every node: a turn begins here, and a
// straight begins here. Turns lead from one to the other, and straights of all lengths back, so that between two turns
// there is one straight, accelerated and braked as one.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// What all searches for routes of one robot share: its tables as they use them. May be used by many at once.
class RouteTables {
 public:
  /// The tables must outlive it. Not for more than eight speeds of a turn.
  explicit RouteTables(const DriveTables& tables);
  ~RouteTables();
  RouteTables(RouteTables&&) noexcept;
  RouteTables& operator=(RouteTables&&) noexcept;

  /// What a FastestRoutes for a maze takes, in bytes.
  std::size_t bytes_for(Size size) const;

 private:
  friend class FastestRoutes;
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// Times to the goals from all nodes of a maze up to 32×32, and the routes. Takes all memory that it will need.
class FastestRoutes {
 public:
  /// In memory of its own. The tables must outlive it.
  FastestRoutes(Size size, const DriveTables& tables);
  FastestRoutes(Size size, const RouteTables& tables);
  /// In memory that must outlive it: tables.bytes_for(size), beginning at a multiple of 16.
  FastestRoutes(Size size, const RouteTables& tables, std::span<std::byte> memory);
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
  friend class RouteTables;
  class Search;
  struct End {
    void operator()(Search* search) const;
  };

  std::unique_ptr<const RouteTables> tables_;  ///< where they are its own
  std::unique_ptr<std::byte[]> memory_;        ///< the same
  std::unique_ptr<Search, End> search_;
};

/// The walls that a route passes.
WallSet walls_of(const DriveRoute& route);
/// The same, and those behind its end that are open where it can stop: it can be driven where all of them are open.
WallSet walls_needed_by(const DriveRoute& route, const DriveTables& tables);

}  // namespace labmouse
