#include "labmouse/lab/mice/maze_holders.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/markup.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

/// In bytes. No file of the largest maze, 64×64 cells, is longer.
constexpr std::uintmax_t longest_maze = std::uintmax_t{256} << 10U;

/// Whether the size fits the only binary format, which has a byte for each cell.
bool is_binary_maze(std::uintmax_t size) { return size <= max_side * max_side; }

bool is_installed_or_hidden(const fs::path& folder) {
  std::error_code error;
  const std::string name = folder.filename().string();
  return name.starts_with('.') || name == "node_modules" || name == "__pycache__" ||
         fs::exists(folder / "pyvenv.cfg", error);
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return lower;
}

}  // namespace

bool holds_maze(const std::string& path) {
  std::array<char, 1024> bytes{};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  const std::string_view begin(bytes.data(), static_cast<std::size_t>(file.gcount()));
  if (begin.empty()) return false;
  if (begin.starts_with("SQLite format 3")) return true;
  // Records, and results of races.
  if (begin.starts_with('{') && begin.find("\"labmouse\"") != std::string_view::npos) return true;
  // Pictures, reports, and what a build of labmouse makes.
  if (is_markup(begin)) return true;
  const std::string name = in_lower_case(path);
  for (const std::string_view end : {".svg", ".html", ".htm", "/labmouse_core.wasm", "/builtin_mazes.cpp"})
    if (name.ends_with(end)) return true;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || size > longest_maze || (begin.find('\0') != std::string_view::npos && !is_binary_maze(size)))
    return false;
  const FileContent content = read_found_file(path);
  // A source file that has a maze in it is a part of the mouse.
  return content.error.empty() && recognised_format(content.content) != &c_format &&
         read_maze(content.content).maze.has_value();
}

void hide_mazes_in(const std::string& folder, HiddenFiles& hidden) {
  if (folder.empty() || !hidden.is_new_folder(folder)) return;
  std::error_code error;
  int files = 0;
  for (fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code unknown;
    if (entry->is_directory(unknown) && is_installed_or_hidden(entry->path())) entry.disable_recursion_pending();
    if (!entry->is_regular_file(unknown)) continue;
    if (++files > most_searched) return hidden.note_unsearched(folder);
    if (holds_maze(entry->path().string())) hidden.add(entry->path().string());
  }
}

}  // namespace labmouse
