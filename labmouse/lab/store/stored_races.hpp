// Races from the rows of a store, without running a contest.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// Which contests of a store are meant: all whose world, mouse, maze and so on have one of these names; of an empty
/// list, all have.
struct StoreFilter {
  std::vector<std::string> worlds, mice, mazes, versions;
  std::optional<std::uint64_t> race_seed;
};

/// The condition on the view `results` that picks them, for SQL; empty where all are meant.
std::string condition_of(const StoreFilter& filter);

/// A race in each world under each of its conditions, or why there is none.
struct StoredRaces {
  std::vector<Race> races;
  /// What the races lack and were not asked to lack, a line each.
  std::vector<std::string> remarks;
  std::string error;
};

/// The races that were held with one seed; an error where the rows have several and none was asked for. Of mice with
/// one name, such as an older external mouse, the one that raced last, and none that a study taught. Mice and mazes are
/// as the rows say: nothing can be run again.
StoredRaces stored_races(const std::string& path, const StoreFilter& filter);

/// The same with all mice and seeds: results have their own, and the names of mice are not unique.
StoredRaces all_stored_contests(const std::string& path, const StoreFilter& filter);

/// A mouse of a world in a store.
struct StoredMouse {
  std::string world, conditions, mouse;
  std::string apart;  ///< what tells its conditions from others of that world; empty where there are no others
  std::int64_t mazes = 0, contests = 0, finished = 0;
  std::optional<double> mean;        ///< of what its contests count, in mazes that count
  std::int64_t first = 0, last = 0;  ///< seconds since 1970
};
struct StoredMice {
  std::vector<StoredMouse> mice;
  std::string error;
};
StoredMice stored_mice(const std::string& path, const StoreFilter& filter);

/// Each contest with all that is known of it, as JSON in a line or as CSV with a header, by world, mouse, maze and
/// seed, a part of the text after the other; stops where `take` returns false. With `most` the last ones alone, in the
/// order in which they were kept; 0 takes all. Returns what went wrong, or nothing.
enum class ExportFormat { json_lines, csv };
std::string export_store(const std::string& path, const StoreFilter& filter, ExportFormat format, std::int64_t most,
                         const std::function<bool(const std::string& lines)>& take);

}  // namespace labmouse
