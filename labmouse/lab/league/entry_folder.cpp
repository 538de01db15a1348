#include "labmouse/lab/league/entry_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "labmouse/lab/league/secret_seed.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 60, longest_text = 200;

/// Whether a text has a path that leads out of the folder of the entry. Paths of the system may stand there.
bool leads_out(std::string_view text) {
  constexpr std::string_view separators = " \t\"'=:,;";
  while (!text.empty()) {
    const auto end = std::min(text.find_first_of(separators), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const bool is_of_system = word.starts_with("/usr/") || word.starts_with("/bin/");
    if (word.starts_with('~') || (word.starts_with('/') && word.size() > 1 && !is_of_system)) return true;
    const fs::path path(word);
    if (std::find(path.begin(), path.end(), fs::path("..")) != path.end()) return true;
  }
  return false;
}

/// Copies a folder, and counts what it copies.
class Copying {
 public:
  std::string copy(const fs::path& from, const fs::path& to) {
    std::error_code error;
    if (!fs::create_directories(to, error) && error) return failed(to, "cannot be made: " + error.message());
    std::vector<fs::directory_entry> entries;
    for (fs::directory_iterator entry(from, error), end; !error && entry != end; entry.increment(error)) {
      entries.push_back(*entry);
      if (++files_ > most_entry_files)
        return failed(
            from, fmt::format("has more than {} files; remove those that the mouse does not need", most_entry_files));
    }
    if (error) return failed(from, "cannot be read: " + error.message());
    std::sort(entries.begin(), entries.end());
    for (const fs::directory_entry& entry : entries)
      if (std::string problem = copy_one(entry, to / entry.path().filename()); !problem.empty()) return problem;
    return "";
  }

 private:
  static std::string failed(const fs::path& path, const std::string& reason) {
    return shown(fmt::format("{}: error: {}", path.string(), reason));
  }

  std::string copy_one(const fs::directory_entry& entry, const fs::path& to) {
    std::error_code error;
    const fs::file_status status = entry.symlink_status(error);
    if (!error && status.type() == fs::file_type::directory) return copy(entry.path(), to);
    if (error || status.type() != fs::file_type::regular)
      return failed(entry.path(), "is no regular file; replace it by the file itself, or remove it");
    bytes_ += entry.file_size(error);
    if (bytes_ > most_entry_bytes)
      return failed(entry.path(), fmt::format("with it, the entry has more than {} MiB; remove what the mouse does "
                                              "not need",
                                              most_entry_bytes >> 20U));
    if (!error) fs::copy_file(entry.path(), to, error);
    return error ? failed(entry.path(), "cannot be copied: " + error.message()) : "";
  }

  int files_ = 0;
  std::uintmax_t bytes_ = 0;
};

/// What of a mouse its league decides, or the folder of the entry.
std::vector<Problem> problems_of(const MiceFileResult& file) {
  std::vector<Problem> problems;
  const MiceFileEntry& mouse = file.mice.front();
  const auto add = [&](std::string reason) { problems.push_back({mouse.line, mouse.column, std::move(reason)}); };
  const auto is_bad = [](const std::string& text) {
    return text.empty() || shown(text) != text || text.size() > longest_text;
  };
  if (file.mice.size() > 1) add("an entry is one mouse; remove the others");
  if (mouse.name.size() > longest_name) add(fmt::format("the name is longer than {} bytes", longest_name));
  if (file.authors.empty() || std::any_of(file.authors.begin(), file.authors.end(), is_bad))
    add("authors are missing; add authors = [\"...\"] at the top");
  if (is_bad(file.licence)) add("the licence is missing; add licence = \"MIT\" at the top");
  const FileLimits& limits = mouse.limits;
  if (limits.start || limits.decision || limits.silence || limits.contest || limits.memory || limits.written ||
      limits.processes || limits.processor_seconds)
    add("the season sets the limits of all entries; remove 'limits'");
  if (mouse.runs) add("the season sets the number of contests; remove 'runs'");
  std::vector<std::string> texts = {mouse.what, mouse.directory, mouse.interpreter};
  texts.insert(texts.end(), mouse.arguments.begin(), mouse.arguments.end());
  texts.insert(texts.end(), mouse.environment.begin(), mouse.environment.end());
  if (std::any_of(texts.begin(), texts.end(), leads_out))
    add("a path leads out of the folder of the entry; put the file into it");
  return problems;
}

}  // namespace

EntryManifestResult read_manifest(std::string_view text) {
  MiceFileResult file = read_mice_file(text);
  if (!file.problems.empty()) return {{}, std::move(file.problems)};
  if (std::vector<Problem> problems = problems_of(file); !problems.empty()) return {{}, std::move(problems)};
  const MiceFileEntry& mouse = file.mice.front();
  return {{mouse.name, std::move(file.authors), std::move(file.licence), std::move(file.robot),
           std::string(key_of(mouse.kind)), mouse.what},
          {}};
}

std::string hash_of_folder(const std::string& folder) {
  std::vector<std::string> lines;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->symlink_status(error).type() != fs::file_type::regular) continue;
    std::ifstream file(entry->path(), std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(file), {}};
    lines.push_back(fmt::format("{} {}\n", sha256_text(content),
                                sha256_text(entry->path().lexically_relative(folder).generic_string())));
  }
  std::sort(lines.begin(), lines.end());
  return sha256_text(fmt::format("{}", fmt::join(lines, "")));
}

std::string copy_entry(const std::string& from, const std::string& to) { return Copying().copy(from, to); }

}  // namespace labmouse
