// The fastest routes of a maze, exactly.
//
// The search goes from the goals backwards in time. Every node has two states: a turn begins here, or a straight begins
// here. Turns lead from the first to the second, straights of all lengths back. So there is one straight between two
// turns, with one phase of acceleration and one of braking.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/drive/memory_part.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

struct DriveModel;

/// The tables that all searches for routes of one robot share. Several threads may use them at once.
class RouteTables {
 public:
  /// For mazes up to a size, and up to eight speeds of a turn.
  explicit RouteTables(const DriveTables& tables, Size largest = {max_drive_side, max_drive_side});
  ~RouteTables();
  /// The same, and they keep the bounds that a search computes for a start, for later searches: up to eight starts in
  /// mazes of up to 16x16, and eight in larger ones.
  static std::shared_ptr<const RouteTables> keeping_bounds(const DriveTables& tables);

  /// The bytes that a FastestRoutes for a maze takes, and how many of these (the first ones) it still needs when a
  /// field is being read. The others are free until the next fill.
  std::size_t bytes_for(Size size) const;
  std::size_t kept_bytes_for(Size size) const;
  /// The parts of these bytes.
  MemoryLayout layout(Size size) const;
  /// Bytes of these tables themselves, as far as mazes of that size need them; constant once they are made.
  std::size_t table_bytes(Size size) const;

 private:
  friend class FastestRoutes;
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// The tables of a model: the shared ones if it has them, else new ones.
std::shared_ptr<const RouteTables> route_tables_of(const DriveModel& model);
/// Makes shared tables for a model that many mice use. The model must not change afterwards.
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
  /// The same for one start: only the fastest routes from there are certain to be found, and other times are upper
  /// limits. It is faster, except at the first call with a start, which computes its bounds and keeps them.
  void fill_for(Pose start, const WallSet& passages, const CellSet& goals);

  /// The time from rest in the middle of the start cell, or no_time.
  DriveTime time_from(Pose start) const;
  /// Writes a fastest route, of several the first in a fixed order. It has no segments and no_time if there is none; in
  /// a goal it has no segments and time 0.
  void route_from(Pose start, DriveRoute& route) const;
  /// The walls that this route needs to be open, as walls_needed_by() finds them, without building the route.
  WallSet walls_from(Pose start) const;

  /// The time from a node where a straight (of any length, or none) begins after a turn that ended in that lane, or
  /// no_time. Undefined if no turn can end there in that lane. For comparison with other searches.
  DriveTime rolling(const DriveNode& node, std::size_t lane) const;

 private:
  friend class RouteTables;
  class Search;
  struct End {
    void operator()(Search* search) const;
  };

  std::shared_ptr<const RouteTables> tables_;
  std::unique_ptr<std::byte[]> memory_;  ///< null if the memory is the caller's
  std::unique_ptr<Search, End> search_;
};

/// The walls that a route passes.
WallSet walls_of(const DriveRoute& route);
/// The same, and the walls beyond its end that must be open for the mouse to stop. It can be driven if all of them are
/// open.
WallSet walls_needed_by(const DriveRoute& route, const DriveTables& tables);

}  // namespace labmouse
