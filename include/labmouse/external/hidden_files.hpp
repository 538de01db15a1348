// Files that external mice must not see: the mazes of a race, its store, its records.
#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace labmouse {

/// A list of paths that grows while a command reads its arguments. All mice share it, and each uses its state at the
/// mouse's start. Thread-safe.
class HiddenFiles {
 public:
  using Paths = std::shared_ptr<const std::vector<std::string>>;

  /// Adds a file or folder, relative to the current directory, which need not exist yet. The target of a link is
  /// hidden, too. Empty paths are ignored.
  void add(const std::string& path);
  /// Adds a store and the files that SQLite keeps beside it.
  void add_store(const std::string& path);
  /// Whether this is the first call for that folder, so that its contents still have to be searched.
  bool is_new_folder(const std::string& folder);
  /// All paths, absolute, sorted, without duplicates. Returns the same list until a path is added.
  Paths paths() const;

 private:
  mutable std::mutex mutex_;
  std::set<std::string> all_, folders_;
  mutable Paths paths_;
};

}  // namespace labmouse
