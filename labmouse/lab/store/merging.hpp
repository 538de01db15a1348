// The rows of a store on their way into another one.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "labmouse/lab/store/database.hpp"

namespace labmouse {

/// What a merge came to.
struct Merge {
  std::int64_t added = 0;              ///< contests that are new in the target
  std::int64_t equal = 0;              ///< contests that it had already, with the same results
  std::vector<std::string> conflicts;  ///< contests whose results differ, a line each; then nothing was changed
  std::string error;                   ///< why there was no merge, as a line for the user

  bool good() const { return conflicts.empty() && error.empty(); }
};

/// Adds the rows of other stores to one, inside of a transaction of it. Rows have other numbers there.
class Merging {
 public:
  explicit Merging(Database& ours);

  /// Adds those of one store, which people know by that path; an error of its is noted there. Where contests contradict
  /// ours, the first ones are named, and the transaction is not to be committed.
  void add(Database& theirs, const std::string& path, Merge& merge);

 private:
  /// Our numbers by theirs.
  using Numbers = std::map<std::int64_t, std::int64_t>;

  Numbers add_named(Database& theirs, const char* table, const std::string& key, const std::string& rest);
  void add_bounds(Database& theirs);
  void add_contests(Database& theirs, const std::string& path, Merge& merge);
  void compare(const Statement& row, const std::array<std::int64_t, 4>& place, const std::string& path, Merge& merge);
  std::string conflict(const Statement& row, const std::array<std::int64_t, 4>& place, const std::string& path);

  Database& ours_;
  Statement add_bound_, add_contest_, add_timing_, find_, name_;
  Numbers worlds_, mice_, mazes_, builds_;
  std::int64_t unnamed_ = 0;  ///< conflicts of the present store that are not named
};

}  // namespace labmouse
