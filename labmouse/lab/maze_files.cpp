#include "labmouse/lab/maze_files.hpp"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>

#include "labmouse/lab/builtin_mazes.hpp"
#include "labmouse/lab/files.hpp"
#include "labmouse/lab/printable.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

/// Line of a problem that is not in a file's content: there is no such file, say.
constexpr int no_place = -1;

/// Reads one file into the collection, or notes in `failures` what is wrong with it.
void add_file(const std::string& path, MazeCollection& collection, std::vector<SkippedFile>& failures) {
  const FileContent file = read_file(path);
  if (!file.error.empty()) {
    failures.push_back({path, {{no_place, no_place, file.error}}});
    return;
  }
  ReadResult result = read_maze(file.content);
  if (result.maze)
    collection.mazes.push_back({path, *result.maze});
  else
    failures.push_back({path, std::move(result.problems)});
}

bool hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

/// Adds every file below a folder; links to folders are not followed, so there is no way round in circles.
void add_folder(const std::string& folder, MazeCollection& collection) {
  std::error_code error;
  std::vector<std::string> files;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (hidden(entry->path())) {
      if (entry->is_directory(error)) entry.disable_recursion_pending();
    } else if (entry->is_regular_file(error)) {
      files.push_back(entry->path().string());
    }
  }
  if (error) collection.errors.push_back({folder, {{no_place, no_place, "cannot read the folder: " + error.message()}}});
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) add_file(file, collection, collection.skipped);
}

/// Adds what a pattern matches; false where it matches nothing.
bool add_matches(const std::string& pattern, MazeCollection& collection) {
  glob_t matches{};
  const bool found = glob(pattern.c_str(), 0, nullptr, &matches) == 0;
  for (std::size_t i = 0; found && i < matches.gl_pathc; ++i) {
    const std::string path = matches.gl_pathv[i];
    if (fs::is_directory(path))
      add_folder(path, collection);
    else
      add_file(path, collection, collection.skipped);
  }
  globfree(&matches);
  return found;
}

bool add_builtin(const std::string& name, MazeCollection& collection) {
  for (const BuiltinMaze& builtin : builtin_mazes())
    if (builtin.name == name) {
      collection.mazes.push_back({name, *read_maze(builtin.text).maze});
      return true;
    }
  return false;
}

std::string no_such_maze(const std::string& path) {
  std::vector<std::string_view> names;
  for (const BuiltinMaze& builtin : builtin_mazes()) names.push_back(builtin.name);
  const auto near = nearest_name(path, names);
  return near.empty() ? "no such file, folder, match or built-in maze"
                      : fmt::format("no such file or built-in maze; did you mean '{}'?", near);
}

void add_path(const std::string& path, MazeCollection& collection) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return add_folder(path, collection);
  if (fs::exists(status)) return add_file(path, collection, collection.errors);
  if (path.find_first_of("*?[") != std::string::npos && add_matches(path, collection)) return;
  if (!add_builtin(path, collection)) collection.errors.push_back({path, {{no_place, no_place, no_such_maze(path)}}});
}

void sort_by_name(MazeCollection& collection) {
  auto& mazes = collection.mazes;
  std::stable_sort(mazes.begin(), mazes.end(), [](const NamedMaze& a, const NamedMaze& b) { return a.name < b.name; });
  mazes.erase(std::unique(mazes.begin(), mazes.end(),
                          [](const NamedMaze& a, const NamedMaze& b) { return a.name == b.name; }),
              mazes.end());
}

}  // namespace

std::string describe(const std::string& path, const Problem& problem) {
  const std::string place = problem.line == no_place ? "" : fmt::format(":{}:{}", problem.line, problem.column);
  // Paths and contents are foreign: neither may break the line or steer a terminal.
  return utf8(printable(fmt::format("{}{}: error: {}", path, place, problem.reason)));
}

MazeCollection load_mazes(std::span<const std::string> paths) {
  MazeCollection collection;
  for (const std::string& path : paths) add_path(path, collection);
  sort_by_name(collection);
  return collection;
}

MazeCollection load_builtin_mazes() {
  MazeCollection collection;
  for (const BuiltinMaze& builtin : builtin_mazes()) add_builtin(std::string(builtin.name), collection);
  return collection;
}

}  // namespace labmouse
