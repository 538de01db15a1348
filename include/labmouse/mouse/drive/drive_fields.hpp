// All fields (the least time or cost of each place) that a strategy plans with in the worlds in seconds.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/drive/run_costs.hpp"
#include "labmouse/mouse/drive/search_field.hpp"

namespace labmouse {

/// The fields of a strategy: one for routes of runs, one for ways of a search, and one for approximate costs of runs.
/// All parts of a strategy use them in turn. Fill a field and read it before another is filled, which may overwrite it.
/// They lie in one block of the caller's memory, whose size follows from the maze and the robot, or in memory of their
/// own. Nothing is allocated after their construction.
class DriveFields {
 public:
  /// Makes them in the caller's memory.
  /// @param size of the maze, with sides of at most max_drive_side cells.
  /// @param model the robot, without error.
  /// @param memory at least bytes_for(size, model) bytes, beginning at a multiple of FastestRoutes::alignment. It must
  ///   outlive them.
  DriveFields(Size size, const DriveModel& model, std::span<std::byte> memory);
  /// Makes them in their own memory: they take more of it, and are faster.
  /// @param size of the maze, with sides of at most max_drive_side cells.
  /// @param model the robot, without error.
  static DriveFields in_own_memory(Size size, const DriveModel& model);
  /// Bytes of memory that the fields for a maze take. If the model has no shared tables (share_route_tables()), this
  /// makes tables and throws them away.
  /// @param size of the maze, with sides of at most max_drive_side cells.
  /// @param model the robot, without error.
  static std::size_t bytes_for(Size size, const DriveModel& model);
  /// The parts of these bytes; ways and runs count only what does not overlap with others.
  /// @param size of the maze, with sides of at most max_drive_side cells.
  /// @param model the robot, without error.
  /// @return the sum of its bytes is bytes_for().
  static MemoryLayout layout(Size size, const DriveModel& model);

  /// The field for routes of runs.
  FastestRoutes& routes() { return routes_; }
  /// The field for ways of a search.
  SearchField& ways() { return ways_; }
  /// The field for ways home: ways() itself, or in their own memory a second one, so that few times change from one
  /// fill of a field to the next.
  SearchField& home() { return home_ ? *home_ : ways_; }
  /// The field for approximate costs of runs.
  /// @pre The maze has at most RunCosts::largest_area cells.
  RunCosts& runs() { return *runs_; }

 private:
  using Tables = std::shared_ptr<const RouteTables>;
  using Memory = std::unique_ptr<std::byte[]>;
  DriveFields(Size size, const Tables& tables, SearchField ways, std::byte* memory);

  Memory own_;  ///< null if the memory is the caller's
  FastestRoutes routes_;
  SearchField ways_;
  std::optional<SearchField> home_;
  std::optional<RunCosts> runs_;
};

}  // namespace labmouse
