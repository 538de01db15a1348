#include "labmouse/external/hidden_files.hpp"

#include <filesystem>
#include <system_error>

namespace labmouse {

void HiddenFiles::add(const std::string& path) {
  namespace fs = std::filesystem;
  if (path.empty()) return;
  std::error_code error, unknown;
  const fs::path absolute = fs::absolute(path, error).lexically_normal();
  if (error) return;
  const fs::path real = fs::weakly_canonical(absolute, unknown);
  const std::lock_guard lock(mutex_);
  bool is_new = all_.insert(absolute.string()).second;
  if (!unknown) is_new = all_.insert(real.string()).second || is_new;
  if (is_new) paths_.reset();
}

void HiddenFiles::add_if_there(const std::string& path) {
  if (std::error_code unknown; std::filesystem::exists(path, unknown)) add(path);
}

void HiddenFiles::add_store(const std::string& path) {
  if (path.empty()) return;
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) add(path + ending);
}

bool HiddenFiles::is_new_folder(const std::string& folder) {
  const std::lock_guard lock(mutex_);
  return folders_.insert(folder).second;
}

void HiddenFiles::note_unsearched(const std::string& folder) {
  const std::lock_guard lock(mutex_);
  unsearched_.insert(folder);
}

HiddenFiles::Paths HiddenFiles::paths() const {
  const std::lock_guard lock(mutex_);
  if (!paths_) paths_ = std::make_shared<const std::vector<std::string>>(all_.begin(), all_.end());
  return paths_;
}

}  // namespace labmouse
