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
  /// Copies the tables of a robot.
  /// @param tables those of a model without error, with up to most_speeds speeds of a turn.
  /// @param largest size of the mazes that they can be used for, with sides of at most max_drive_side cells.
  explicit RouteTables(const DriveTables& tables, Size largest = {max_drive_side, max_drive_side});
  ~RouteTables();
  /// Makes tables for mazes of all sizes that keep the bounds which a search computes for a start, for later searches:
  /// up to eight starts in mazes of up to 16×16 cells, and eight in larger ones.
  /// @param tables those of a model without error, with up to most_speeds speeds of a turn; copied.
  /// @return never null.
  static std::shared_ptr<const RouteTables> keeping_bounds(const DriveTables& tables);

  /// Bytes of memory that a FastestRoutes for a maze takes.
  /// @param size of the maze, at most that of the tables.
  std::size_t bytes_for(Size size) const;
  /// How many of these bytes, the first ones, it still needs when a field is being read. The others are free until the
  /// next fill.
  /// @param size of the maze, at most that of the tables.
  std::size_t kept_bytes_for(Size size) const;
  /// The parts of the bytes that a FastestRoutes takes.
  /// @param size of the maze, at most that of the tables.
  /// @return the sum of its bytes is bytes_for().
  MemoryLayout layout(Size size) const;
  /// Bytes of these tables themselves, as far as mazes of a size need them; constant once they are made.
  /// @param size of the maze, at most that of the tables.
  std::size_t table_bytes(Size size) const;

 private:
  friend class FastestRoutes;
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// The tables of a model: the shared ones if it has them, else new ones, which takes time and memory.
/// @param model the robot, without error.
/// @return never null.
std::shared_ptr<const RouteTables> route_tables_of(const DriveModel& model);
/// Makes shared tables for a model that many mice use, unless it has some. The model must not change afterwards.
/// @param model without error; sets its `route_tables`.
void share_route_tables(DriveModel& model);

/// Times to the goals from all nodes of a maze up to 32×32, and the routes. Takes all memory that it will need.
class FastestRoutes {
 public:
  /// In memory of its own, with tables of its own.
  /// @param size of the maze, with sides of at most max_drive_side cells.
  /// @param tables those of a model without error; copied.
  FastestRoutes(Size size, const DriveTables& tables);
  /// In memory of its own, with shared tables.
  /// @param size of the maze, at most that of the tables.
  /// @param tables not null.
  FastestRoutes(Size size, std::shared_ptr<const RouteTables> tables);
  /// In the caller's memory, with shared tables.
  /// @param size of the maze, at most that of the tables.
  /// @param tables not null.
  /// @param memory at least tables->bytes_for(size) bytes, beginning at a multiple of `alignment`. It must outlive it.
  FastestRoutes(Size size, std::shared_ptr<const RouteTables> tables, std::span<std::byte> memory);
  static constexpr std::size_t alignment = 16;  ///< bytes
  ~FastestRoutes();
  FastestRoutes(FastestRoutes&&) noexcept;

  /// Computes all times to the goals.
  /// @param passages the open walls, all inside the size.
  /// @param goals cells where a route may end, all inside the size.
  void fill(const WallSet& passages, const CellSet& goals);
  /// The same for one start: only the fastest routes from there are certain to be found, and other times are upper
  /// limits. It is faster, except at the first call with a start, which computes its bounds and keeps them.
  /// @param start where routes begin, at rest in the middle of its cell.
  /// @param passages the open walls, all inside the size.
  /// @param goals cells where a route may end, all inside the size.
  /// @param limit times above it may be too late, or no_time.
  void fill_for(Pose start, const WallSet& passages, const CellSet& goals, DriveTime limit = no_time);
  /// Prepares later calls of fill_for() for a start: those whose passages are all among these are faster. The results
  /// stay the same. It takes about as long as fill(), and overwrites what was found.
  /// @param start where routes begin, at rest in the middle of its cell.
  /// @param passages all that those fills can have, all inside the size.
  /// @param latest about the longest time of a route that they find. Longer ones are found as well, but not faster.
  void aim(Pose start, const WallSet& passages, DriveTime latest);

  /// The time of a fastest route.
  /// @param start where it begins, at rest in the middle of its cell.
  /// @return microseconds; 0 in a goal, no_time if there is no route. After fill_for() with another start it is an
  ///   upper limit.
  DriveTime time_from(Pose start) const;
  /// Writes a fastest route, of several the first in a fixed order.
  /// @param start as for time_from(); after fill_for(), its start.
  /// @param route is overwritten. It has no segments and no_time if there is no route; in a goal it has no segments and
  ///   time 0.
  void route_from(Pose start, DriveRoute& route) const;
  /// The walls that this route needs to be open, as walls_needed_by() finds them, without building the route.
  /// @param start as for time_from(); after fill_for(), its start.
  /// @return no walls if there is no route, or the start is a goal.
  WallSet walls_from(Pose start) const;

  /// The time to the goals from a node where a straight (of any length, or none) begins after a turn. For comparison
  /// with other searches.
  /// @param node inside the maze.
  /// @param lane that in which the turn ended: a position in `along.lanes` or `diagonal.lanes` of the tables. Some turn
  ///   must be able to end there in that lane, else the result has no meaning.
  /// @return microseconds; no_time if there is no route, or the node lies on a closed wall.
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
/// @param route of any length.
/// @return no walls if it has no segments.
WallSet walls_of(const DriveRoute& route);
/// The same, and the walls beyond its end that must be open for the mouse to stop. The route can be driven if all of
/// them are open.
/// @param route one that can be driven.
/// @param tables those that it was planned with.
WallSet walls_needed_by(const DriveRoute& route, const DriveTables& tables);

}  // namespace labmouse
