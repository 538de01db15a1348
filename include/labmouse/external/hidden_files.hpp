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
  /// A list that does not change.
  using Paths = std::shared_ptr<const std::vector<std::string>>;

  /// Adds a file or folder. The target of a link is hidden, too.
  /// @param path absolute, or relative to the current directory. It need not exist yet. An empty path is ignored.
  void add(const std::string& path);
  /// Adds a file if there is one of that name, such as that of a maze, which may also be generated.
  /// @param path as of add().
  void add_if_there(const std::string& path);
  /// Adds a store and the files that SQLite keeps beside it.
  /// @param path as of add().
  void add_store(const std::string& path);
  /// Notes that a folder is searched for files to hide.
  /// @param folder its path; other spellings count as other folders.
  /// @return whether this is the first call for that folder, so that its contents still have to be searched.
  bool is_new_folder(const std::string& folder);
  /// Notes that a folder has too many files to search, so that some with mazes may not be hidden.
  /// @param folder as of is_new_folder().
  void note_unsearched(const std::string& folder);
  /// @return the folders of note_unsearched(), sorted.
  std::vector<std::string> unsearched() const {
    const std::lock_guard lock(mutex_);
    return {unsearched_.begin(), unsearched_.end()};
  }
  /// All paths so far.
  /// @return absolute, sorted, without duplicates; never null. It is the same list until a path is added.
  Paths paths() const;

 private:
  mutable std::mutex mutex_;
  std::set<std::string> all_, folders_, unsearched_;
  mutable Paths paths_;
};

}  // namespace labmouse
