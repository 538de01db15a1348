#include "labmouse/lab/store/store_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>

#include "labmouse/lab/store/merging.hpp"
#include "labmouse/lab/store/schema.hpp"
#include "labmouse/lab/system/file_lock.hpp"
#include "labmouse/lab/system/file_problems.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

/// Adds stores to a target in one transaction, which fails as a whole at an error or a conflict. `called`, if not
/// empty, is the name of the stores in messages.
void add_to(const std::string& target, Database::Access access, const std::vector<std::string>& paths,
            const std::string& called, Merge& merge) {
  Database ours = open_store(target, access);
  ours.run("BEGIN IMMEDIATE");
  {
    Merging merging(ours);
    for (const std::string& path : paths) {
      if (!merge.good() || !ours.good()) break;
      Database theirs = open_checked_store(path, Database::Access::read);
      merging.add(theirs, called.empty() ? path : called, merge);
      merge.error = error_line(path, theirs.error());
    }
  }
  if (merge.good()) ours.run("COMMIT");
  ours.roll_back();
  if (merge.error.empty()) merge.error = error_line(target, ours.error());
}

/// Why a merge cannot read a store; empty where it can.
std::string refuse(const std::string& path, const std::string& target) {
  std::error_code none;
  if (fs::equivalent(path, target, none)) return error_line(path, "is the target of the merge itself");
  return error_line(path, open_store(path, Database::Access::read).error());
}

/// Gives a new store its name, if no file has it yet. Returns false where another program has just created the target,
/// which must not be replaced; true after success or an error.
bool becomes(const std::string& beside, const std::string& target, Merge& merge) {
  std::error_code error;
  if (fs::exists(target, error)) return false;
  fs::create_hard_link(beside, target, error);
  if (error == std::errc::file_exists) return false;
  // Some file systems have no hard links.
  if (error) fs::rename(beside, target, error);
  if (error) merge.error = error_line(target, "cannot be written: " + cause_of(error.value()));
  return true;
}

/// Resets the counters of a failed merge, which changed nothing.
Merge as_it_ended(Merge merge) {
  if (!merge.good()) merge.added = merge.equal = 0;
  return merge;
}

/// A locked temporary file beside the target for a merge, removed in the destructor. A killed merge leaves its file
/// unlocked; the next merge into the target removes it.
class FileBeside {
 public:
  explicit FileBeside(const std::string& target) : begin_(target + ".merging-") {
    for (int number = 1; path_.empty() && error_ == 0; ++number)
      if (auto file = taken(std::to_string(number), error_)) {
        path_ = begin_ + std::to_string(number);
        lock_.emplace(std::move(*file));
      }
    remove_leftovers(fs::path(target));
  }
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;
  ~FileBeside() {
    // Removed before it is unlocked, so that no other merge has locked it by then.
    if (lock_) remove(path_);
  }

  /// Why it could not be created; empty where it could.
  std::string error() const { return error_ == 0 ? "" : "cannot be written: " + cause_of(error_); }
  const std::string& path() const { return path_; }

 private:
  static constexpr const char* lock_ending = "-lock";

  /// Locks and removes the file of that number; nothing where another merge uses it, or where it cannot be created.
  std::optional<Descriptor> taken(const std::string& number, int& error) const {
    Descriptor file = locked_file(begin_ + number + lock_ending, error);
    if (error == EWOULDBLOCK)
      error = 0;
    else if (error == 0) {
      remove_store(begin_ + number);
      return file;
    }
    return std::nullopt;
  }

  /// Removes files of killed merges. Our own file and those of running merges are locked.
  void remove_leftovers(const fs::path& target) const {
    const std::string begin = target.filename().string() + ".merging-";
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::vector<std::string> numbers;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      const std::string name = entry->path().filename().string();
      if (!name.starts_with(begin)) continue;
      const std::string rest = name.substr(begin.size()), number = rest.substr(0, rest.find('-'));
      const bool is_number = !number.empty() && std::all_of(number.begin(), number.end(),
                                                            [](char letter) { return letter >= '0' && letter <= '9'; });
      if (is_number) numbers.push_back(number);
    }
    for (const std::string& number : numbers) {
      int unknown = 0;
      if (const auto lock = taken(number, unknown)) remove(begin_ + number);
    }
  }

  static void remove_store(const std::string& path) {
    std::error_code unknown;
    for (const char* ending : {"", "-wal", "-shm"}) fs::remove(path + ending, unknown);
  }
  static void remove(const std::string& path) {
    std::error_code unknown;
    remove_store(path);
    fs::remove(path + lock_ending, unknown);
  }

  std::string begin_, path_;
  std::optional<Descriptor> lock_;
  int error_ = 0;
};

}  // namespace

Merge merge_stores(const std::vector<std::string>& paths, const std::string& target, TargetCheck check) {
  Merge merge;
  std::error_code unknown;
  if (check == TargetCheck::now && fs::exists(target, unknown))
    merge.error = error_line(target, open_checked_store(target, Database::Access::read).error());
  if (!merge.good()) return merge;
  for (const std::string& path : paths)
    if (merge.error = refuse(path, target); !merge.error.empty()) return merge;
  const FileBeside beside(target);
  if (merge.error = error_line(target, beside.error()); !merge.error.empty()) return merge;
  if (fs::exists(target, unknown)) {
    add_to(target, Database::Access::write, paths, "", merge);
    return as_it_ended(std::move(merge));
  }
  // A new store gets its name only when it is complete.
  add_to(beside.path(), Database::Access::create, paths, "", merge);
  if (!merge.good() || becomes(beside.path(), target, merge)) return as_it_ended(std::move(merge));
  merge.added = merge.equal = 0;
  add_to(target, Database::Access::write, {beside.path()}, target, merge);
  return as_it_ended(std::move(merge));
}

Forgotten forget(const std::string& path, const StoreFilter& filter) {
  Forgotten forgotten;
  Database database = open_checked_store(path, Database::Access::write);
  database.run("BEGIN IMMEDIATE");
  database.run("CREATE TEMP TABLE gone AS SELECT id FROM results" + condition_of(filter));
  database.run("DELETE FROM timings WHERE contest IN (SELECT id FROM gone)");
  database.run("DELETE FROM contests WHERE id IN (SELECT id FROM gone)");
  forgotten.contests = database.changes();
  database.run(R"(
    DELETE FROM bounds WHERE NOT EXISTS (
      SELECT 1 FROM contests WHERE contests.world = bounds.world AND contests.maze = bounds.maze);
    DELETE FROM worlds WHERE id NOT IN (SELECT world FROM contests);
    DELETE FROM mice WHERE id NOT IN (SELECT mouse FROM contests);
    DELETE FROM mazes WHERE id NOT IN (SELECT maze FROM contests);
    DELETE FROM builds WHERE id NOT IN (SELECT build FROM contests);
    COMMIT)");
  forgotten.error = error_line(path, database.error());
  if (!forgotten.error.empty()) forgotten.contests = 0;
  return forgotten;
}

}  // namespace labmouse
