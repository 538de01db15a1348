// Records of mms, read back: JSON Lines, described in docs/reference/records.md.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/external/mms/host.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// A line of the program that moved, turned or drew, with the simulator's reply.
struct RecordedMmsEvent {
  std::string line;
  std::string reply;  ///< empty where mms answers nothing
  HalfPose pose;      ///< after the event
  double clock = 0;   ///< simulated seconds
};

/// How a program ended.
struct MmsRecordEnd {
  std::string outcome;
  std::string end;  ///< the outcome in more words
  MmsStatistics statistics;
  std::int64_t lines = 0;
  std::int64_t invalid_lines = 0;
  std::vector<std::string> log;
  std::string errors;
  double clock = 0;
};

/// The record of one run of an mms program.
struct MmsRecordFile {
  std::string version;  ///< of the program that wrote it
  std::string maze_name;
  std::optional<Maze> maze;  ///< always there when read
  std::string mouse;
  std::vector<RecordedMmsEvent> events;
  std::int64_t left_out = 0;        ///< number of events after these that were not written
  std::optional<MmsRecordEnd> end;  ///< missing where the record breaks off
};

/// A record, or what is wrong with the text: exactly one of the two is there.
struct ReadMmsRecordResult {
  std::optional<MmsRecordFile> file;
  std::vector<Problem> problems;
};

/// Reads what MmsRecorder wrote.
ReadMmsRecordResult read_mms_record(std::string_view text);

/// Feeds a record's lines to the simulator again and compares replies and poses; where no event was left out, also the
/// statistics. Calls `after(i, host)` after event i. Returns the first difference, or an empty text.
std::string replay(const MmsRecordFile& file, const std::function<void(std::size_t event, const MmsHost&)>& after);

}  // namespace labmouse
