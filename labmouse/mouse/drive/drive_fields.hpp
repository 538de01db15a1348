// All fields that a strategy in seconds plans with.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/drive/run_costs.hpp"
#include "labmouse/mouse/drive/search_field.hpp"

namespace labmouse {

/// One field for routes of runs, one for ways of a search and one for what runs cost about, which all parts of a
/// strategy use in turn: whoever needs one fills it first, and reads it before another is filled, which may take its
/// place. They lie in one piece of memory, whose size follows from the maze and the robot; nothing else is allocated,
/// ever.
class DriveFields {
 public:
  /// In memory that must outlive them: bytes_for(size, model), beginning at a multiple of FastestRoutes::alignment.
  DriveFields(Size size, const DriveModel& model, std::span<std::byte> memory);
  /// In memory of their own, of which they take more and are faster.
  static DriveFields in_own_memory(Size size, const DriveModel& model);
  static std::size_t bytes_for(Size size, const DriveModel& model);
  /// What these bytes are spent on; ways and runs, as far as they do not lie in the place of others.
  static MemoryLayout layout(Size size, const DriveModel& model);

  FastestRoutes& routes() { return routes_; }
  SearchField& ways() { return ways_; }
  /// For ways that lead home. In memory of their own another field than ways(), so that both have little to repair.
  SearchField& home() { return home_ ? *home_ : ways_; }
  /// Not for mazes of more than RunCosts::largest_area.
  RunCosts& runs() { return *runs_; }

 private:
  using Tables = std::shared_ptr<const RouteTables>;
  using Memory = std::unique_ptr<std::byte[]>;
  DriveFields(Size size, const Tables& tables, SearchField ways, std::byte* memory);

  Memory own_;  ///< where it is their own
  FastestRoutes routes_;
  SearchField ways_;
  std::optional<SearchField> home_;
  std::optional<RunCosts> runs_;
};

}  // namespace labmouse
