// The record of one program that was written for mms: JSON Lines, described in docs/reference/records.md.
#pragma once

#include <cstdint>
#include <string>

#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"

namespace labmouse {

/// A record has at most so many events, and no more once it has so many bytes.
inline constexpr std::int64_t most_recorded_events = 1'000'000;
inline constexpr std::size_t most_recorded_bytes = std::size_t{64} << 20U;

/// Writes down one run while it goes on.
class MmsRecorder {
 public:
  /// `most`: events that are written down; a mark stands in the place of the others.
  MmsRecorder(const std::string& mouse, const NamedMaze& maze, std::int64_t most = most_recorded_events);

  void add(const MmsEvent& event);

  /// The whole record; nothing more can be added.
  std::string finish(const MmsRun& run);

 private:
  std::int64_t most_;
  std::int64_t events_ = 0;
  std::int64_t written_ = 0;
  std::string text_;
};

}  // namespace labmouse
