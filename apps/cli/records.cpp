#include "records.hpp"

#include <fmt/format.h>

#include "command.hpp"
#include "labmouse/lab/files.hpp"
#include "labmouse/lab/printable.hpp"

namespace labmouse::cli {

RecordFile load_record(const std::string& path) {
  const FileContent file = read_file(path, std::size_t{1} << 28U);
  if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", path, file.error));
  ReadRecordResult result = read_record(file.content);
  if (!result.file) throw UsageError(describe(path, result.problems.front()));
  return std::move(*result.file);
}

bool re_enact(const std::string& path, RecordFile& file) {
  ReplayResult result = replay(file, *file.maze);
  if (!result.disagreement.empty()) {
    tell(fmt::format("{}: error: does not agree with its maze: {}\n", shown(path), result.disagreement));
    return false;
  }
  file.run = std::move(result.run);
  return true;
}

}  // namespace labmouse::cli
