// Mice files: files that name mice, described in docs/reference/files.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/mice_files/file_limits.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// One entry of a mice file, as written there.
struct MiceFileEntry {
  enum class Kind { mouse, capstone, external, controller, firmware, mms };

  std::string name;
  Kind kind = Kind::mouse;
  std::string what;  ///< SPEC of a built-in mouse, file of a capstone robot or of firmware, or command
  std::vector<std::string> arguments;
  std::vector<std::string> environment;  ///< NAME=VALUE
  std::string directory, interpreter, note;
  std::optional<int> runs;
  FileLimits limits;         ///< empty ones are those of the race
  int line = 0, column = 0;  ///< of the entry in its file, from 1
};

/// The key of a kind: "capstone".
std::string_view key_of(MiceFileEntry::Kind kind);

/// Either mice, or the problems of their file.
struct MiceFileResult {
  std::vector<MiceFileEntry> mice;
  std::vector<Problem> problems;
  /// What a league asks of its entries; may be empty in other files.
  std::vector<std::string> authors = {};
  std::string licence = {};
  std::string robot = {};  ///< that the mouse is made for
};

/// Reads a mice file of at most 64 KiB.
MiceFileResult read_mice_file(std::string_view text);

}  // namespace labmouse
