// Mice files: files that name mice, described in docs/reference/files.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/external/limits.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// One entry of a mice file, as written there.
struct MiceFileEntry {
  enum class Kind { mouse, capstone, external, controller, mms };

  std::string name;
  Kind kind = Kind::mouse;
  std::string what;  ///< SPEC of a built-in mouse, file of a capstone robot, or command
  std::vector<std::string> arguments;
  std::vector<std::string> environment;  ///< NAME=VALUE
  std::string directory, interpreter, note;
  std::optional<int> runs;
  /// Limits that the file sets; empty ones are those of the race.
  std::optional<double> start, decision, silence, contest;  ///< in seconds
  std::optional<int> memory, written;                       ///< in MiB
  std::optional<int> processes, processor_seconds;
  int line = 0, column = 0;  ///< of the entry in its file, from 1

  /// The limits given, overridden by those that the file sets.
  ExternalLimits limits_over(ExternalLimits limits) const;
};

/// The key of a kind: "capstone".
std::string_view key_of(MiceFileEntry::Kind kind);

/// Either mice, or the problems of their file.
struct MiceFileResult {
  std::vector<MiceFileEntry> mice;
  std::vector<Problem> problems;
};

/// Reads a mice file of at most 64 KiB.
MiceFileResult read_mice_file(std::string_view text);

}  // namespace labmouse
