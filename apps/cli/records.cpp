#include "records.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "command.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse::cli {

Option* add_record_maze(Command& command, std::string& maze) {
  return command.add_option("--maze", maze, "Play the record in this maze instead of its own")->type_name("MAZE");
}

std::string load_record_text(const std::string& path) {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown))
    throw UsageError(
        fmt::format("{}: error: this is a folder; name one of its records, FOLDER/MOUSE/MAZE.jsonl", path));
  FileContent file = read_file(path, std::size_t{1} << 28U);
  if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", path, file.error));
  return std::move(file.content);
}

std::unique_ptr<Replay> open_record(const std::string& path, const std::string& text, const std::string& maze) {
  std::optional<NamedMaze> named;
  if (!maze.empty()) named = find_maze(maze, {});
  OpenedRecord opened = kind_of_record(text).open(text, named ? &*named : nullptr);
  if (opened.lacks_maze)
    throw UsageError(fmt::format("{}: error: the record does not contain its maze; name it with --maze MAZE", path));
  if (!opened.problems.empty()) {
    refuse_other_kind(path, text, FileKind::record);
    throw UsageError(describe(path, opened.problems.front()));
  }
  // The text may come from a record of somebody else, so make it safe to print.
  if (!opened.disagreement.empty())
    tell(shown(fmt::format("{}: error: the record does not match its maze: {}", path, opened.disagreement)) + "\n");
  return std::move(opened.replay);
}

}  // namespace labmouse::cli
