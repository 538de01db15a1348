// Records as files: JSON Lines, described in docs/reference/records.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// The fields that the record of a step contains. A replay restores the missing ones.
struct GivenFields {
  bool run = true, cell = true, heading = true, reading = true, blocked = true;

  friend constexpr bool operator==(const GivenFields&, const GivenFields&) = default;
};

/// A contest in a world of steps with everything that is needed to replay it. A record from a real robot may lack much
/// of it.
struct RecordFile {
  std::string world;  ///< name of the world; empty for the default world of steps, which the rules describe fully
  std::string maze_name;
  std::optional<Maze> maze;  ///< always set by a writer
  std::string mouse;
  std::string spec;         ///< the mouse's SPEC where its name is another
  Settings settings;        ///< written, not read back
  std::string interpreter;  ///< interpreter of an external mouse and its version
  std::uint64_t seed = 0;
  Rules rules;
  std::string version;  ///< version of the program that wrote the record; write_record() writes the current one
  RunRecord run;
  bool ended = true;               ///< false where the last line, with the outcome, is missing
  std::vector<GivenFields> given;  ///< fields of each step as read; a step beyond this list has all fields
  GivenFields given_end;           ///< of the last line, where only the cell and the heading matter
};

std::string write_record(const RecordFile& file);

/// A record, or what is wrong with the text: exactly one of the two is there.
struct ReadRecordResult {
  std::optional<RecordFile> file;
  std::vector<Problem> problems;
};
ReadRecordResult read_record(std::string_view text);

/// Replays a record's actions in a maze and compares the result with the record: the replayed run, and the first
/// difference. The mouse's counts and reasons are not checked, except that the maze must have the walls of the reasons.
struct ReplayResult {
  RunRecord run;
  std::string disagreement;  ///< empty where all that is given agrees
};
ReplayResult replay(const RecordFile& file, const Maze& maze);

}  // namespace labmouse
