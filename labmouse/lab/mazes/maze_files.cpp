#include "labmouse/lab/mazes/maze_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "labmouse/lab/system/calls.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/streams.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

/// Adds the maze of a file to the collection, or its problems to `failures`.
void add_file(const std::string& path, const FileContent& file, const ReadChoice& choice, MazeCollection& collection,
              std::vector<SkippedFile>& failures) {
  if (!file.error.empty()) {
    failures.push_back({path, {{no_place, no_place, file.error}}});
    return;
  }
  ReadResult result = read_maze(file.content, choice);
  for (std::string& note : result.notes) collection.notes.push_back({path, std::move(note)});
  if (result.maze)
    collection.mazes.push_back(
        {path, *result.maze, std::move(result.reading), result.partial ? result.partial->unseen : WallSet()});
  else
    failures.push_back({path, std::move(result.problems), result.repaired.has_value()});
}

bool hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

std::vector<fs::directory_entry> entries_of(const std::string& folder, std::error_code& error) {
  std::vector<fs::directory_entry> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (!hidden(entry->path())) entries.push_back(*entry);
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Adds every file below a folder. Links to folders are not followed, to avoid cycles. Unreadable files are skipped; an
/// unreadable folder itself goes to `failures`.
void add_folder(const std::string& folder, const ReadChoice& choice, MazeCollection& collection,
                std::vector<SkippedFile>& failures) {
  std::error_code error;
  for (const fs::directory_entry& entry : entries_of(folder, error)) {
    std::error_code unknown;
    const bool link = entry.is_symlink(unknown);
    if (link && entry.is_directory(unknown)) continue;
    if (entry.is_directory(unknown))
      add_folder(entry.path().string(), choice, collection, collection.skipped);
    else
      add_file(entry.path().string(), read_found_file(entry.path().string()), choice, collection, collection.skipped);
  }
  if (error) failures.push_back({folder, {{no_place, no_place, "cannot read the folder: " + error.message()}}});
}

/// Adds what a pattern matches; returns false if it matches nothing.
bool add_matches(const std::string& pattern, const ReadChoice& choice, MazeCollection& collection) {
  const std::vector<std::string> paths = paths_like(pattern);
  for (const std::string& path : paths) {
    std::error_code unknown;
    if (fs::is_directory(path, unknown))
      add_folder(path, choice, collection, collection.skipped);
    else
      add_file(path, read_found_file(path), choice, collection, collection.skipped);
  }
  return !paths.empty();
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
  return near.empty() ? "no such file, folder or built-in maze"
                      : fmt::format("no such file or built-in maze; did you mean '{}'?", near);
}

void add_path(const std::string& path, const ReadChoice& choice, MazeCollection& collection) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return add_folder(path, choice, collection, collection.errors);
  if (status.type() != fs::file_type::not_found || descriptor_to_read(path))
    return add_file(path, read_file(path), choice, collection, collection.errors);
  if (path.find_first_of("*?[") != std::string::npos && add_matches(path, choice, collection)) return;
  if (!add_builtin(path, collection)) collection.errors.push_back({path, {{no_place, no_place, no_such_maze(path)}}});
}

/// Sorts by name and removes duplicates, so that neither order nor repetition of arguments matters.
template <class Named, class Name>
void sort_by(std::vector<Named>& list, Name name) {
  std::stable_sort(list.begin(), list.end(), [&](const Named& a, const Named& b) { return name(a) < name(b); });
  list.erase(std::unique(list.begin(), list.end(), [&](const Named& a, const Named& b) { return name(a) == name(b); }),
             list.end());
}

}  // namespace

std::string describe(const std::string& path, const Problem& problem) {
  const std::string place = problem.line <= 0 ? "" : fmt::format(":{}:{}", problem.line, problem.column);
  // Paths and contents are untrusted: escape line breaks and terminal control codes.
  return shown(fmt::format("{}{}: error: {}", path, place, problem.reason));
}

MazeCollection load_mazes(std::span<const std::string> paths, const ReadChoice& choice) {
  MazeCollection collection;
  for (const std::string& path : paths) add_path(path, choice, collection);
  std::set<std::pair<std::string, std::string>> known;
  std::erase_if(collection.notes, [&](const auto& note) { return !known.emplace(note.path, note.text).second; });
  sort_by(collection.mazes, [](const NamedMaze& maze) -> const std::string& { return maze.name; });
  for (auto* files : {&collection.skipped, &collection.errors})
    sort_by(*files, [](const SkippedFile& file) -> const std::string& { return file.path; });
  return collection;
}

ReadResult load_map(const std::string& path) {
  std::error_code error;
  if (fs::status(path, error).type() == fs::file_type::not_found && !descriptor_to_read(path)) {
    for (const BuiltinMaze& builtin : builtin_mazes())
      if (builtin.name == path) return read_maze(builtin.text);
    return {.problems = {{no_place, no_place, no_such_maze(path)}}};
  }
  const FileContent file = read_file(path);
  if (!file.error.empty()) return {.problems = {{no_place, no_place, file.error}}};
  return read_maze(file.content);
}

std::optional<Maze> maze_named(const std::string& name) {
  MazeCollection collection;
  std::error_code error;
  if (fs::exists(name, error))
    add_file(name, read_found_file(name), {.closes_unseen = true}, collection, collection.errors);
  else
    add_builtin(name, collection);
  if (collection.mazes.empty()) return std::nullopt;
  return collection.mazes.front().maze;
}

MazeCollection load_builtin_mazes() {
  MazeCollection collection;
  for (const BuiltinMaze& builtin : builtin_mazes()) add_builtin(std::string(builtin.name), collection);
  return collection;
}

}  // namespace labmouse
