#include "labmouse/lab/page/played_record.hpp"

#include <fmt/format.h>

namespace labmouse {

PageReply disagreed(const std::string& name, std::string disagreement) {
  return failed(fmt::format("{} does not match its maze", name), {{0, 0, std::move(disagreement)}});
}

PlayedRecord played(const std::string& name, RecordFile file) {
  ReplayResult result = replay(file, *file.maze);
  if (!result.disagreement.empty()) return {std::nullopt, disagreed(name, std::move(result.disagreement)).failure};
  file.run = std::move(result.run);
  return {std::move(file), {}};
}

PlayedRecord read_played(const std::string& name, std::string_view text, std::optional<NamedMaze> maze) {
  ReadRecordResult read = read_record(text);
  if (!read.file) return {std::nullopt, {fmt::format("{} is not a readable record", name), std::move(read.problems)}};
  if (!read.file->maze && !maze)
    return {std::nullopt,
            {fmt::format("{} is a record without its maze; open the maze first, then the record again", name), {}}};
  if (!read.file->maze) {
    read.file->maze = maze->maze;
    read.file->maze_name = std::move(maze->name);
  }
  return played(name, std::move(*read.file));
}

}  // namespace labmouse
