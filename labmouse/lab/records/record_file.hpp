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

/// Which fields of a step stand in its record. Those that do not are known only after the record was played.
struct GivenFields {
  bool run = true, cell = true, heading = true, reading = true, blocked = true;

  friend constexpr bool operator==(const GivenFields&, const GivenFields&) = default;
};

/// A record with all that is needed to understand it years later. One that a robot wrote may lack much of it.
struct RecordFile {
  std::string world;  ///< its name, where it is another one than that of these rules alone
  std::string maze_name;
  std::optional<Maze> maze;  ///< always there when written
  std::string mouse;
  std::string spec;         ///< the mouse's SPEC where its name is another
  Settings settings;        ///< written, not read back
  std::string interpreter;  ///< with its version, of an external mouse that has one
  std::uint64_t seed = 0;
  Rules rules;
  std::string version;  ///< of the program that wrote it; a writer puts its own
  RunRecord run;
  bool ended = true;               ///< false where the last line, with the outcome, is missing
  std::vector<GivenFields> given;  ///< of each step as it was read; a step beyond them has all
  GivenFields given_end;           ///< of the last line, which has only a cell and a heading of them
};

std::string write_record(const RecordFile& file);

/// A record, or what is wrong with the text: exactly one of the two is there.
struct ReadRecordResult {
  std::optional<RecordFile> file;
  std::vector<Problem> problems;
};
ReadRecordResult read_record(std::string_view text);

/// Plays a record's actions again in a maze and compares what the record gives. Returns the whole record that comes
/// out, or where it first disagrees. What the mouse counted is taken over unchecked, and so are its reasons, but for
/// walls that the maze does not have.
struct ReplayResult {
  RunRecord run;
  std::string disagreement;  ///< empty where all that is given agrees
};
ReplayResult replay(const RecordFile& file, const Maze& maze);

}  // namespace labmouse
