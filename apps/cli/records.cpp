#include "records.hpp"

#include <fmt/format.h>

#include "command.hpp"
#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/pictures/mms_picture.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::cli {
namespace {

/// What a record says is foreign: it may hold anything.
void tell_disagreement(const std::string& path, const std::string& disagreement) {
  tell(shown(fmt::format("{}: error: the record does not match its maze: {}", path, disagreement)) + "\n");
}

}  // namespace

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
  tell_disagreement(path, disagreement);
  return std::nullopt;
}

std::optional<MmsRecord> load_mms_record(const std::string& path, const std::string& text) {
  ReadMmsRecordResult result = read_mms_record(text);
  if (!result.file) throw UsageError(describe(path, result.problems.front()));
  MmsRecord record{std::move(*result.file), {}};
  record.replay = replay_of(record.file);
  if (record.replay.disagreement.empty()) return record;
  tell_disagreement(path, record.replay.disagreement);
  return std::nullopt;
}

std::string mms_drawing_of(const Maze& maze, const MmsCanvas& canvas, const HalfPose& pose) {
  return draw_text(as_in_mms(maze), mms_layers(canvas, pose), colours());
}

void refuse_options(const Command& command, const std::vector<std::string>& options, std::string_view kind) {
  for (const std::string& name : options)
    if (command.count(name) > 0) throw UsageError(fmt::format("error: {} cannot be used with {}", name, kind));
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
    tell_disagreement(path, result.disagreement);
    return false;
  }
  file.run = std::move(result.run);
  return true;
}

}  // namespace labmouse::cli
