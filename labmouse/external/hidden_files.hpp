// Files that no external mouse may see: the mazes of a race, its store, its records.
#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace labmouse {

/// A list of paths that grows while a command reads its arguments. Its mice share it: each takes what stands there when
/// it is started. From several threads at once.
class HiddenFiles {
 public:
  using Paths = std::shared_ptr<const std::vector<std::string>>;

  /// Adds a file or folder, as seen from the current directory; it need not exist yet. Where it is a link, what it
  /// leads to is hidden, too. Empty paths are ignored.
  void add(const std::string& path);
  /// Adds a store and the files that SQLite keeps beside it.
  void add_store(const std::string& path);
  /// Whether nobody asked that of the folder before: then what is in it is still to be looked through.
  bool is_new_folder(const std::string& folder);
  /// All paths, absolute, sorted, each once. The same list until one is added.
  Paths paths() const;

 private:
  mutable std::mutex mutex_;
  std::set<std::string> all_, folders_;
  mutable Paths paths_;
};

}  // namespace labmouse
