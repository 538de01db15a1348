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
  std::string world;      ///< name of the world; empty for the default world of steps, which the rules describe fully
  std::string maze_name;  ///< as in results; "maze" if the record does not name it
  std::optional<Maze> maze;  ///< always set by a writer
  std::string mouse;         ///< its name in results; "robot" if the record does not name it
  std::string spec;          ///< the mouse's SPEC where its name is another
  Settings settings;         ///< written, not read back
  std::string interpreter;   ///< interpreter of an external mouse and its version
  std::uint64_t seed = 0;    ///< of the contest
  Rules rules;
  std::string version;  ///< version of the program that wrote the record; write_record() writes the current one
  RunRecord run;
  bool ended = true;               ///< false where the last line, with the outcome, is missing
  std::vector<GivenFields> given;  ///< fields of each step as read; a step beyond this list has all fields
  GivenFields given_end;           ///< of the last line, where only the cell and the heading matter
};

/// Writes a record with its score and its outcome, in the current format.
/// @param file with its maze; `version`, `ended` and `given` are not used.
/// @return the content of the file: a header, a line for each step, and a last line. Each ends in a line feed.
/// @pre file.maze is set.
std::string write_record(const RecordFile& file);

/// A record, or what is wrong with the text: exactly one of the two is there.
struct ReadRecordResult {
  std::optional<RecordFile> file;
  std::vector<Problem> problems;
};
/// Reads a record, of a simulated or a real robot. It checks each line, but not whether the contest could have
/// happened: see replay().
/// @param text the whole file. An incomplete last line is ignored, as after a power failure.
/// @return the record, or the first problem with its line. A record of more than 1,000,000 steps is a problem.
ReadRecordResult read_record(std::string_view text);

/// A replayed record, and its first difference from the record.
struct ReplayResult {
  RunRecord run;             ///< as it happens in the maze; counts, last words and reasons are those of the record
  std::string disagreement;  ///< one line for the user; empty if all that is given agrees
};
/// Replays a record's actions in a maze and compares the result with the record. The mouse's counts and reasons are not
/// checked, except that the maze must have the walls of the reasons.
/// @param file the record; a record without its last line is replayed up to its last step.
/// @param maze up to 64×64 cells; that of the record, or another one.
/// @return the replayed run, and where it differs from the record.
ReplayResult replay(const RecordFile& file, const Maze& maze);

}  // namespace labmouse
