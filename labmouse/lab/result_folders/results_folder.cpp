#include "labmouse/lab/result_folders/results_folder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <vector>

#include "labmouse/lab/races/race_paths.hpp"
#include "labmouse/lab/system/file_lock.hpp"
#include "labmouse/lab/system/file_names.hpp"
#include "labmouse/lab/system/file_problems.hpp"
#include "labmouse/lab/system/streams.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

constexpr const char* lock_name = ".labmouse-race";

/// The name of the mouse in a record's first line; empty where the file is no record.
std::string mouse_of(const fs::path& file) {
  constexpr std::size_t longest_header = std::size_t{1} << 16U;
  std::string line(longest_header, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(stream.gcount()));
  const ReadJson header = read_json(line.substr(0, line.find('\n')));
  const auto mouse = header.is_object() && header.contains("labmouse") ? header.find("mouse") : header.end();
  if (mouse == header.end() || !mouse->is_object() || !mouse->contains("name")) return "";
  return mouse->at("name").is_string() ? mouse->at("name").get<std::string>() : "";
}

/// Whether a race would have written the record there: the folder has the name of its mouse, or that name and a number.
bool is_in_its_place(const fs::path& file) {
  if (file.extension() != ".jsonl") return false;
  const std::string mouse = mouse_of(file);
  const std::string folder = file.parent_path().filename().string();
  return !mouse.empty() && folder.substr(0, folder.find('~')) == file_names({mouse}).front();
}

/// The picture beside a record of a first run, MAZE-1.jsonl; an empty path for other records.
fs::path picture_of(fs::path record) {
  const std::string stem = record.stem().string();
  return stem.ends_with("-1") ? record.replace_filename(stem.substr(0, stem.size() - 2) + ".svg") : fs::path();
}

std::vector<fs::path> paths_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> paths;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    paths.push_back(entry->path());
  return paths;
}

/// Files of an earlier race in the folder: results, records and pictures. Stops when `most` are found.
std::vector<fs::path> remains_of_a_race(const fs::path& folder, std::size_t most) {
  std::error_code unknown;
  std::vector<fs::path> files;
  if (const fs::path results = folder / results_file_name; fs::is_regular_file(results, unknown))
    files.push_back(results);
  for (const fs::path& inner : paths_in(folder))
    if (fs::is_directory(fs::symlink_status(inner, unknown)))
      for (const fs::path& file : paths_in(inner)) {
        if (files.size() >= most) return files;
        if (!fs::is_regular_file(fs::symlink_status(file, unknown)) || !is_in_its_place(file)) continue;
        files.push_back(file);
        if (const fs::path picture = picture_of(file); fs::exists(picture, unknown)) files.push_back(picture);
      }
  return files;
}

/// Removes the files, and then the empty folders of mice. Returns what went wrong, or nothing.
std::string remove_all(const fs::path& folder, const std::vector<fs::path>& files) {
  std::error_code error;
  for (const fs::path& file : files) {
    fs::remove(file, error);
    if (error) return fmt::format("cannot remove {}: {}", file.string(), cause_of(error.value()));
    if (file.parent_path() != folder) fs::remove(file.parent_path(), error);  // fails while the folder has other files
  }
  return "";
}

/// Makes the folder. Returns what went wrong, or nothing.
std::string make(const std::string& path) {
  if (path.empty()) return "the path of the folder is empty";
  if (descriptor_to_write(path)) return "is not a folder, which the results, records and pictures need";
  std::error_code error;
  fs::create_directories(path, error);
  if (error) return "cannot create the folder: " + cause_of(error.value());
  return fs::is_directory(path, error) ? "" : "is not a folder";
}

}  // namespace

ResultsFolder::ResultsFolder(const std::string& path, bool overwrite) {
  if (const std::string reason = take(path, overwrite); !reason.empty())
    error_ = shown(fmt::format("{}: error: {}", path, reason));
}

std::string ResultsFolder::take(const std::string& path, bool overwrite) {
  if (std::string reason = make(path); !reason.empty()) return reason;
  const std::string lock_path = (fs::path(path) / lock_name).string();
  int error = 0;
  lock_ = locked_file(lock_path, error);
  if (error == EWOULDBLOCK) return "another race is writing to this folder; wait, or choose another folder";
  if (error != 0) return "cannot write: " + cause_of(error);
  lock_path_ = lock_path;
  const auto files = remains_of_a_race(path, overwrite ? std::size_t(-1) : 1);
  if (!files.empty() && !overwrite)
    return "holds the results of an earlier race; choose another folder, or replace them with --overwrite";
  return remove_all(path, files);
}

ResultsFolder::~ResultsFolder() {
  // Removed before it is unlocked, so that no other race has locked it by then.
  std::error_code unknown;
  if (!lock_path_.empty()) fs::remove(lock_path_, unknown);
}

}  // namespace labmouse
