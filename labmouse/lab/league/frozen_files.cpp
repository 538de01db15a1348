#include "labmouse/lab/league/frozen_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/league/earlier_seasons.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

using Hashes = std::map<std::string, std::string, std::less<>>;  ///< by path in the folder

constexpr std::size_t hash_digits = 64;
constexpr std::string_view separator = "  ";

std::string list_of(const Hashes& hashes) {
  std::string text;
  for (const auto& [name, hash] : hashes) text += fmt::format("{}{}{}\n", hash, separator, name);
  return text;
}

/// Hashes files of a folder; after the first error it does nothing.
class Freezing {
 public:
  Freezing(std::string folder, Hashes hashes) : folder_(std::move(folder)), hashes_(std::move(hashes)) {}

  void add(const std::string& name) {
    if (!error_.empty()) return;
    const std::string path = fmt::format("{}/{}", folder_, name);
    const FileContent file = read_found_file(path, most_results_bytes);
    if (file.error.empty())
      hashes_[name] = sha256_text(file.content);
    else
      error_ = shown(fmt::format("{}: error: {}", path, file.error));
  }

  /// Adds the files in a folder of the season, but hidden ones, which are not read as mazes either.
  void add_folder(const std::string& name) {
    std::error_code error;
    const fs::path folder = fs::path(folder_) / name;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      std::error_code unknown;
      const bool is_folder = entry->is_directory(unknown),
                 is_hidden = entry->path().filename().string().starts_with('.');
      if (is_hidden && is_folder) entry.disable_recursion_pending();
      if (is_folder || is_hidden) continue;
      add(entry->path().lexically_relative(folder_).generic_string());
    }
    if (error && error_.empty())
      error_ = shown(fmt::format("{}: error: cannot be read: {}", folder.string(), error.message()));
  }

  FrozenFiles list() const { return error_.empty() ? FrozenFiles{list_of(hashes_), ""} : FrozenFiles{"", error_}; }

 private:
  std::string folder_, error_;
  Hashes hashes_;
};

Hashes hashes_in(std::string_view list) {
  Hashes hashes;
  for (std::size_t begin = 0; begin < list.size();) {
    const auto end = std::min(list.find('\n', begin), list.size());
    const std::string_view line = list.substr(begin, end - begin);
    if (line.size() > hash_digits + separator.size() && line.substr(hash_digits, separator.size()) == separator)
      hashes[std::string(line.substr(hash_digits + separator.size()))] = line.substr(0, hash_digits);
    begin = end + 1;
  }
  return hashes;
}

}  // namespace

FrozenFiles frozen_files(const std::string& folder, const Season& season, std::string_view season_file) {
  Freezing freezing(folder, {{season_file_name, sha256_text(season_file)}});
  for (const WorldSetting& setting : season.world.entry->settings)
    if (const auto chosen = season.world.settings.find(setting.name);
        chosen != season.world.settings.end() && can_be_file(setting, (fs::path(folder) / chosen->second).string()))
      freezing.add(chosen->second);
  std::error_code unknown;
  if (fs::exists(fmt::format("{}/{}", folder, previous_file_name), unknown)) freezing.add(previous_file_name);
  freezing.add_folder(practice_folder_name);
  return freezing.list();
}

std::vector<std::string> frozen_changes(const std::string& folder, std::string_view written, std::string_view now) {
  if (written == now) return {};
  std::vector<std::string> changes;
  const auto add = [&](std::string_view name, std::string_view reason) {
    changes.push_back(shown(fmt::format("{}/{}: error: {}", folder, name, reason)));
  };
  const Hashes before = hashes_in(written), after = hashes_in(now);
  if (before.empty() || list_of(before) != written) {
    add(frozen_file_name, "is not as `labmouse league init` wrote it; restore it");
    return changes;
  }
  for (const auto& [name, hash] : before) {
    const auto found = after.find(name);
    if (found == after.end())
      add(name,
          "is missing, and the season was frozen with it; restore it, or make another season with `labmouse league "
          "init`");
    else if (found->second != hash)
      add(name, "has changed, and a season is frozen; restore it, or make another season with `labmouse league init`");
  }
  for (const auto& [name, hash] : after)
    if (before.find(name) == before.end())
      add(name, "was added, and a season is frozen; remove it, or make another season with `labmouse league init`");
  return changes;
}

}  // namespace labmouse
