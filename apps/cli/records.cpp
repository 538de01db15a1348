#include "records.hpp"

#include <fmt/format.h>

#include "command.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::cli {

Option* add_record_maze(Command& command, std::string& maze) {
  return command.add_option("--maze", maze, "Play the record in this maze instead of its own")->type_name("MAZE");
}

std::string load_record_text(const std::string& path) {
  FileContent file = read_file(path, std::size_t{1} << 28U);
  if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", path, file.error));
  return std::move(file.content);
}

std::optional<DriveRecordFile> load_drive_record(const std::string& path, const std::string& text) {
  ReadDriveRecordResult result = read_drive_record(text);
  if (!result.file) throw UsageError(describe(path, result.problems.front()));
  const std::string disagreement = replay(*result.file);
  if (disagreement.empty()) return std::move(result.file);
  tell(fmt::format("{}: error: the record does not match its maze: {}\n", shown(path), disagreement));
  return std::nullopt;
}

void refuse_in_seconds(const Command& command, const std::vector<std::string>& options) {
  for (const std::string& name : options)
    if (command.count(name) > 0)
      throw UsageError(fmt::format("error: {} cannot be used with a record in seconds", name));
}

RecordFile load_record(const std::string& path, const std::string& text, const std::string& maze) {
  ReadRecordResult result = read_record(text);
  if (!result.file) throw UsageError(describe(path, result.problems.front()));
  RecordFile& record = *result.file;
  if (!maze.empty()) {
    NamedMaze named = find_maze(maze, {});
    record.maze = std::move(named.maze);
    record.maze_name = std::move(named.name);
  }
  if (!record.maze)
    throw UsageError(fmt::format("{}: error: the record does not contain its maze; name it with --maze MAZE", path));
  return std::move(record);
}

bool re_enact(const std::string& path, RecordFile& file) {
  ReplayResult result = replay(file, *file.maze);
  if (!result.disagreement.empty()) {
    tell(fmt::format("{}: error: the record does not match its maze: {}\n", shown(path), result.disagreement));
    return false;
  }
  file.run = std::move(result.run);
  return true;
}

}  // namespace labmouse::cli
