// Records as files: JSON Lines, described in docs/run-record.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// A record with all that is needed to understand it years later.
struct RecordFile {
  std::string maze_name;
  std::optional<Maze> maze;  ///< always there when written
  std::string mouse;
  Settings settings;         ///< written, not read back
  std::uint64_t seed = 0;
  Rules rules;
  std::string version;       ///< of the program that wrote it; a writer puts its own
  RunRecord run;
  bool ended = true;         ///< false where the last line, with the outcome, is missing
};

std::string write_record(const RecordFile& file);

/// A record, or what is wrong with the text: exactly one of the two is there.
struct ReadRecordResult {
  std::optional<RecordFile> file;
  std::vector<Problem> problems;
};
ReadRecordResult read_record(std::string_view text);

/// Plays a record's actions again in a maze. Returns the record that comes out, or where it first disagrees; what the
/// mouse counted and its reasons are taken over unchecked.
struct ReplayResult {
  RunRecord run;
  std::string disagreement;  ///< empty where every step agrees
};
ReplayResult replay(const RecordFile& file, const Maze& maze);

}  // namespace labmouse
