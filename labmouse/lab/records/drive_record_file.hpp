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

/// What a record of the physical world or of the failure model stores in addition.
struct PhysicalPart {
  PhysicalConditions conditions;
  PhysicalNotes notes;
  int edition = physical_edition;  ///< version of the physical world in which the contest ran
  std::string failure_rates;       ///< name of the failure rates; empty in the physical world
  std::string rates_hash;
};

/// A contest in seconds with everything that is needed to replay it.
struct DriveRecordFile {
  std::string added_world;  ///< its name, if the contest was run in a world that this program does not bring
  std::string version;  ///< version of the program that wrote the record; write_drive_record() writes the current one
  std::string maze_name;
  std::optional<Maze> maze;  ///< always set, and at most 32x32
  std::string mouse;
  std::string spec;   ///< the mouse's SPEC where its name is another
  Settings settings;  ///< written, not read back
  std::uint64_t seed = 0;
  std::shared_ptr<const DriveModel> model;  ///< always set, and without an error
  std::uint64_t tables_hash = 0;  ///< of the robot's tables, as read; write_drive_record() writes that of `model`
  DriveRules rules;
  DriveRecord record;
  bool ended = true;                              ///< false where the last line, with the outcome, is missing
  std::optional<PhysicalPart> physical{};         ///< only in the physical world and the failure model
  std::optional<DriveRunScore> recorded_score{};  ///< the score in the last line; computed by write_drive_record()
};

/// The name of the contest's world.
std::string world_of(const DriveRecordFile& file);

/// The pace of a run: its speed on the same path, as a share of the robot's usual speed.
inline double pace_of(const DriveRecordFile& file, const DriveRun& run) {
  return file.physical ? file.physical->conditions.controller.pace * run.pace : 1.0;
}
/// Whether the record has trace points: positions of the mouse between its moves.
inline bool has_trace(const DriveRecordFile& file) { return file.physical && !file.physical->notes.trace.empty(); }

std::string write_drive_record(const DriveRecordFile& file);

/// A record, or what is wrong with the text: exactly one of the two is there.
struct ReadDriveRecordResult {
  std::optional<DriveRecordFile> file;
  std::vector<Problem> problems;
};

ReadDriveRecordResult read_drive_record(std::string_view text);

/// Replays a record in its maze and compares places, times, walls and the score. Compared are also the times of the
/// fastest known and the fastest possible route, and when the mouse left the start and entered a goal. The mouse's name
/// and its counts of decisions and plans are not checked. Returns the first difference, or an empty text.
std::string replay(const DriveRecordFile& file);

/// The runs as a table, followed by a line with the result.
std::string summary_of(const DriveRecordFile& file);

/// The result of a contest in one line without a line feed: the mouse, the maze, and the score with its parts or the
/// reason why there is none.
std::string result_line(const DriveRecordFile& file);
/// The value of a score with its unit: "8.196 s", "51.786 marks lost".
std::string value_text(MazeTime value, const DriveRules& rules, int digits = 3);

}  // namespace labmouse
