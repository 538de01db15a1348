// Lineups: files that name mice, described in docs/reference/files.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/guests/limits.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// One mouse of a lineup, as its file says it.
struct LineupMouse {
  enum class Kind { mouse, capstone, guest, pilot, mms };

  std::string name;
  Kind kind = Kind::mouse;
  std::string what;  ///< a SPEC of ours, the file of a robot, or a command
  std::vector<std::string> arguments;
  std::vector<std::string> environment;  ///< NAME=VALUE
  std::string directory, interpreter, note;
  std::optional<int> runs;
  /// The limits that the file sets; the others are those of the race.
  std::optional<double> start, decision, silence, contest;  ///< in seconds
  std::optional<int> memory, written;                       ///< in MiB
  std::optional<int> processes, processor_seconds;
  int line = 0, column = 0;  ///< where it stands

  /// These limits, with those that the file sets.
  GuestLimits limits_over(GuestLimits limits) const;
};

/// The key of a kind: "capstone".
std::string_view key_of(LineupMouse::Kind kind);

/// Mice, or what is wrong with their file: exactly one of the two is there.
struct LineupResult {
  std::vector<LineupMouse> mice;
  std::vector<Problem> problems;
};

/// Reads a lineup of at most 64 KiB.
LineupResult read_lineup(std::string_view text);

}  // namespace labmouse
