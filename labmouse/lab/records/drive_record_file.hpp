// Records of contests in seconds as files: JSON Lines, described in docs/reference/records.md.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// What a record of the physical world, or of the failure model, has besides.
struct PhysicalPart {
  PhysicalConditions conditions;
  PhysicalNotes notes;
  int edition = physical_edition;  ///< of its world, in which it was driven
  std::string failure_rates;       ///< by whose dice it was held; empty in the physical world
  std::string rates_hash;
};

/// A record with all that is needed to understand it years later.
struct DriveRecordFile {
  std::string version;  ///< of the program that wrote it; a writer puts its own
  std::string maze_name;
  std::optional<Maze> maze;  ///< always there, and at most 32x32
  std::string mouse;
  std::string spec;   ///< the mouse's SPEC where its name is another
  Settings settings;  ///< written, not read back
  std::uint64_t seed = 0;
  std::shared_ptr<const DriveModel> model;  ///< always there; without an error
  std::uint64_t tables_hash = 0;            ///< of the tables that the record was made with; a writer puts the model's
  DriveRules rules;
  DriveRecord record;
  bool ended = true;                              ///< false where the last line, with the outcome, is missing
  std::optional<PhysicalPart> physical{};         ///< of the physical world alone
  std::optional<DriveRunScore> recorded_score{};  ///< what the last line gives; a writer puts the score of the record
};

/// The part of the robot's usual pace at which a run of it was driven.
inline double pace_of(const DriveRecordFile& file, const DriveRun& run) {
  return file.physical ? file.physical->conditions.controller.pace * run.pace : 1.0;
}
/// Whether it says where the mouse was between its moves.
inline bool has_trace(const DriveRecordFile& file) { return file.physical && !file.physical->notes.trace.empty(); }

std::string write_drive_record(const DriveRecordFile& file);

/// A record, or what is wrong with the text: exactly one of the two is there.
struct ReadDriveRecordResult {
  std::optional<DriveRecordFile> file;
  std::vector<Problem> problems;
};

ReadDriveRecordResult read_drive_record(std::string_view text);

/// Plays a record again in its maze and compares all of it: places, times, walls, what was known and hoped for, gates,
/// and the score. Who drove, and how often it decided and planned, is taken over unchecked. Returns where the record
/// first disagrees, or nothing.
std::string replay(const DriveRecordFile& file);

/// The runs as a table, and the result in a line below.
std::string summary_of(const DriveRecordFile& file);

/// How a contest went, in one line without its end: the mouse, the maze, and the score with its parts or what went
/// wrong.
std::string result_line(const DriveRecordFile& file);

}  // namespace labmouse
