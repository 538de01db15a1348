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
#include "labmouse/mouse/drive/memory_part.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

struct DriveModel;

/// What all searches for routes of one robot share: its tables as they use them. May be used by many at once.
class RouteTables {
 public:
  /// For mazes up to a size; not for more than eight speeds of a turn.
  explicit RouteTables(const DriveTables& tables, Size largest = {max_drive_side, max_drive_side});
  ~RouteTables();
  /// The same, which keep what searches find about a start beforehand, for those that are made later: up to eight
  /// starts in mazes of up to 16x16, and eight in larger ones.
  static std::shared_ptr<const RouteTables> keeping_bounds(const DriveTables& tables);

  /// What a FastestRoutes for a maze takes, in bytes; and how many of these it needs to keep when a field has been
  /// read: the first ones. The others are free until the next fill.
  std::size_t bytes_for(Size size) const;
  std::size_t kept_bytes_for(Size size) const;
  /// What they are spent on.
  MemoryLayout layout(Size size) const;
  /// Of these tables themselves, as far as mazes of that size need them: constant once they are made.
  std::size_t table_bytes(Size size) const;

 private:
  friend class FastestRoutes;
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// Those of a model: the ones that it shares, or new ones.
std::shared_ptr<const RouteTables> route_tables_of(const DriveModel& model);
/// Makes them for a model that many mice will drive by, and that stays as it is.
void share_route_tables(DriveModel& model);

/// Times to the goals from all nodes of a maze up to 32×32, and the routes. Takes all memory that it will need.
class FastestRoutes {
 public:
  /// In memory of its own.
  FastestRoutes(Size size, const DriveTables& tables);
  FastestRoutes(Size size, std::shared_ptr<const RouteTables> tables);
  /// In memory that must outlive it: tables->bytes_for(size), beginning at a multiple of `alignment`.
  FastestRoutes(Size size, std::shared_ptr<const RouteTables> tables, std::span<std::byte> memory);
  static constexpr std::size_t alignment = 16;
  ~FastestRoutes();
  FastestRoutes(FastestRoutes&&) noexcept;

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
  /// The walls that this route needs to be open, as walls_needed_by says, without writing it down.
  WallSet walls_from(Pose start) const;

  /// The time from a node where a straight (of any length, or none) begins behind a turn that ended in that lane, or
  /// no_time; whatever where no turn can end there in that lane. For comparison with other searches.
  DriveTime rolling(const DriveNode& node, std::size_t lane) const;

 private:
  friend class RouteTables;
  class Search;
  struct End {
    void operator()(Search* search) const;
  };

  std::shared_ptr<const RouteTables> tables_;
  std::unique_ptr<std::byte[]> memory_;  ///< where it is its own
  std::unique_ptr<Search, End> search_;
};

/// The walls that a route passes.
WallSet walls_of(const DriveRoute& route);
/// The same, and those behind its end that are open where it can stop: it can be driven where all of them are open.
WallSet walls_needed_by(const DriveRoute& route, const DriveTables& tables);

}  // namespace labmouse
