// Writes the record of one mms program's run: JSON Lines, described in docs/reference/records.md.
#pragma once

#include <cstdint>
#include <string>

#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"

namespace labmouse {

/// Limits of a record: the number of events, and the size after which no more events are written.
inline constexpr std::int64_t most_recorded_events = 1'000'000;
inline constexpr std::size_t most_recorded_bytes = std::size_t{64} << 20U;

/// Records one run while it goes on.
class MmsRecorder {
 public:
  /// `most`: the number of events that are written. One line at the end gives the number of the others.
  MmsRecorder(const std::string& mouse, const NamedMaze& maze, std::int64_t most = most_recorded_events);

  void add(const MmsEvent& event);

  /// Returns the whole record. Call it once, last.
  std::string finish(const MmsRun& run);

 private:
  std::int64_t most_;
  std::int64_t events_ = 0;
  std::int64_t written_ = 0;
  std::string text_;
};

}  // namespace labmouse
