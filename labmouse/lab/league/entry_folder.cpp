#include "labmouse/lab/league/entry_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "labmouse/functions/sha256.hpp"
#include "labmouse/lab/league/builtin_templates.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 60, longest_text = 200;

constexpr std::string_view quotes = "\"'\\";

/// Whether a text without quotes has a path that leads out of the folder of the entry. Paths of the system may stand
/// there.
bool has_outer_path(std::string_view text) {
  constexpr std::string_view separators = " \t=:,;";
  while (!text.empty()) {
    const auto end = std::min(text.find_first_of(separators), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const bool is_of_system = word.starts_with("/usr/") || word.starts_with("/bin/");
    if (word.starts_with('~') || (word.starts_with('/') && !is_of_system)) return true;
    const fs::path path(word);
    if (std::find(path.begin(), path.end(), fs::path("..")) != path.end()) return true;
  }
  return false;
}

/// The same for any text. Quotes end a word, or join its parts: `/""home`.
bool leads_out(std::string text) {
  std::string joined = text;
  std::erase_if(joined, [](char letter) { return quotes.find(letter) != std::string_view::npos; });
  std::replace_if(
      text.begin(), text.end(), [](char letter) { return quotes.find(letter) != std::string_view::npos; }, ' ');
  return has_outer_path(joined) || has_outer_path(text);
}

std::string failed(const fs::path& path, const std::string& reason) {
  return shown(fmt::format("{}: error: {}", path.string(), reason));
}

/// Adds up what an entry has, and says what it may not have.
class EntrySize {
 public:
  /// The error of one file or folder; empty where it may be there.
  std::string add(const fs::directory_entry& entry) {
    std::error_code error;
    const fs::file_status status = entry.symlink_status(error);
    if (++files_ > most_entry_files)
      return failed(entry.path(),
                    fmt::format("with it, the entry has more than {} files and folders; remove those that "
                                "the mouse does not need",
                                most_entry_files));
    if (!error && status.type() == fs::file_type::directory) return "";
    if (error || status.type() != fs::file_type::regular)
      return failed(entry.path(), "is no regular file; replace it by the file itself, or remove it");
    // It would show Python, and so the mouse, the folder that it names.
    if (entry.path().filename() == "pyvenv.cfg")
      return failed(entry.path(), "an entry has no Python environment of its own; leave it out");
    bytes_ += entry.file_size(error);
    if (error) return failed(entry.path(), "cannot be read: " + error.message());
    if (bytes_ > most_entry_bytes)
      return failed(entry.path(), fmt::format("with it, the entry has more than {} MiB; remove what the mouse does "
                                              "not need",
                                              most_entry_bytes >> 20U));
    return "";
  }

 private:
  int files_ = 0;
  std::uintmax_t bytes_ = 0;
};

bool is_executable(const fs::file_status& status) {
  return (status.permissions() & fs::perms::owner_exec) != fs::perms::none;
}

/// Copies a folder.
class Copying {
 public:
  std::string copy(const fs::path& from, const fs::path& to) {
    std::error_code error;
    if (!fs::create_directories(to, error) && error) return failed(to, "cannot be made: " + error.message());
    std::vector<fs::directory_entry> entries;
    for (fs::directory_iterator entry(from, error), end; !error && entry != end; entry.increment(error)) {
      if (std::string problem = size_.add(*entry); !problem.empty()) return problem;
      entries.push_back(*entry);
    }
    if (error) return failed(from, "cannot be read: " + error.message());
    std::sort(entries.begin(), entries.end());
    for (const fs::directory_entry& entry : entries)
      if (std::string problem = copy_one(entry, to / entry.path().filename()); !problem.empty()) return problem;
    return "";
  }

 private:
  std::string copy_one(const fs::directory_entry& entry, const fs::path& to) {
    std::error_code error;
    const fs::file_status status = entry.symlink_status(error);
    if (!error && status.type() == fs::file_type::directory) return copy(entry.path(), to);
    if (!error) fs::copy_file(entry.path(), to, error);
    // Without the bits that would give others the rights of the organiser.
    const fs::perms run = is_executable(status) ? fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec
                                                : fs::perms::none;
    constexpr auto read = fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read;
    if (!error) fs::permissions(to, read | fs::perms::owner_write | run, error);
    return error ? failed(entry.path(), "cannot be copied: " + error.message()) : "";
  }

  EntrySize size_;
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
  if (mouse.name.starts_with('.') || mouse.name.starts_with('/') || mouse.name.find("..") != std::string::npos)
    add("the name looks like a path; choose one without '..', and without a dot or slash at its beginning");
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

FolderHash hash_of_folder(const std::string& folder) {
  std::vector<std::string> lines;
  EntrySize size;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (std::string problem = size.add(*entry); !problem.empty()) return {"", std::move(problem)};
    const fs::file_status status = entry->symlink_status(error);
    if (!error && status.type() == fs::file_type::directory) continue;
    const FileContent file = read_found_file(entry->path().string(), most_entry_bytes);
    if (!file.error.empty()) return {"", failed(entry->path(), file.error)};
    lines.push_back(fmt::format("{} {} {}\n", sha256_text(file.content),
                                sha256_text(entry->path().lexically_relative(folder).generic_string()),
                                is_executable(status)));
  }
  if (error) return {"", failed(folder, "cannot be read: " + error.message())};
  std::sort(lines.begin(), lines.end());
  return {sha256_text(fmt::format("{}", fmt::join(lines, ""))), ""};
}

std::vector<EntryFile> template_entries() {
  std::vector<EntryFile> files;
  for (const BuiltinTemplate& robot : builtin_templates()) {
    if (robot.name == "empty") continue;
    const std::string folder = fmt::format("template_{}", robot.name);
    files.push_back(
        {fmt::format("{}/{}", folder, manifest_name),
         fmt::format("# A template that comes with labmouse.\nauthors = [\"The labmouse authors\"]\nlicence = "
                     "\"MIT\"\n\n[[mouse]]\nname = \"{}\"\ncapstone = \"robot.py\"\n",
                     folder)});
    files.push_back({fmt::format("{}/robot.py", folder), std::string(robot.text)});
  }
  return files;
}

std::string copy_entry(const std::string& from, const std::string& to) { return Copying().copy(from, to); }

}  // namespace labmouse
