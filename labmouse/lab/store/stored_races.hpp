// Restores races from the rows of a store, without running a contest.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// Selects contests of a store: a contest matches if each non-empty list contains its value.
struct StoreFilter {
  std::vector<std::string> worlds, mice, mazes, versions;
  std::optional<std::uint64_t> race_seed;
};

/// The filter as a WHERE clause in SQL for the view `results`; empty for an empty filter.
std::string condition_of(const StoreFilter& filter);

/// A race for each world and each of its conditions, or an error.
struct StoredRaces {
  std::vector<Race> races;
  /// Warnings about worlds, mice and contests that match the filter but are missing in the races, one line each.
  std::vector<std::string> remarks;
  std::string error;
};

/// The races with one seed; an error where the rows have several and the filter names none. Of mice with the same name
/// (such as versions of an external mouse) it takes the last one to race, and prefers those without a learned prior.
/// Mice and mazes are as the rows describe them: no contest can be run again.
StoredRaces stored_races(const std::string& path, const StoreFilter& filter);

/// The same with all mice and seeds. Each result has its own seed, and names of mice may repeat.
StoredRaces all_stored_contests(const std::string& path, const StoreFilter& filter);

/// The contests of one mouse in one world of a store.
struct StoredMouse {
  std::string world, conditions, mouse;
  std::string apart;  ///< how its conditions differ from others of that world; empty where there are no others
  std::int64_t mazes = 0, contests = 0, finished = 0;
  std::optional<double> mean;  ///< mean score in mazes with a bound, with the score that the world counts for a failure
  std::int64_t first = 0, last = 0;  ///< seconds since 1970
};
struct StoredMice {
  std::vector<StoredMouse> mice;
  std::string error;
};
StoredMice stored_mice(const std::string& path, const StoreFilter& filter);

enum class ExportFormat { json_lines, csv };
/// Exports each contest with all its columns, as JSON Lines or as CSV with a header, ordered by world, mouse, maze and
/// seed. Calls `take` with one part of the text after the other and stops where it returns false. With `most` above 0,
/// exports only the last ones, in the order in which they were stored. Returns what went wrong, or nothing.
std::string export_store(const std::string& path, const StoreFilter& filter, ExportFormat format, std::int64_t most,
                         const std::function<bool(const std::string& lines)>& take);

}  // namespace labmouse
