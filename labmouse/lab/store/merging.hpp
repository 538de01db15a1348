// Copies the rows of stores into another store.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "labmouse/lab/store/database.hpp"

namespace labmouse {

/// The result of a merge.
struct Merge {
  std::int64_t added = 0;              ///< contests that are new in the target
  std::int64_t equal = 0;              ///< contests that it had already, with the same results
  std::vector<std::string> conflicts;  ///< contests with different results, one line each; if there are any, nothing
                                       ///< was changed
  std::string error;                   ///< why the merge failed, as a line for the user

  bool good() const { return conflicts.empty() && error.empty(); }
};

/// Adds the rows of other stores to one, within a transaction of that store. Rows get new ids there.
class Merging {
 public:
  explicit Merging(Database& ours);

  /// Adds the rows of one store. `path` is its name in messages. Its errors are recorded in `theirs`. After conflicts,
  /// of which the first ones are listed, the transaction must not be committed.
  void add(Database& theirs, const std::string& path, Merge& merge);

 private:
  /// Maps row ids of the other store to ours.
  using Numbers = std::map<std::int64_t, std::int64_t>;

  Numbers add_named(Database& theirs, const char* table, const std::string& key, const std::string& rest);
  void add_bounds(Database& theirs);
  void add_contests(Database& theirs, const std::string& path, Merge& merge);
  void compare(const Statement& row, const std::array<std::int64_t, 4>& place, const std::string& path, Merge& merge);
  std::string conflict(const Statement& row, const std::array<std::int64_t, 4>& place, const std::string& path);

  Database& ours_;
  Statement add_bound_, add_contest_, add_timing_, find_, name_;
  Numbers worlds_, mice_, mazes_, builds_;
  std::int64_t unnamed_ = 0;  ///< conflicts of the current store that are not listed
};

}  // namespace labmouse
