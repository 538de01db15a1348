// One line of what a real robot sends. docs/reference/protocols.md has the format.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/maze/formats/read_result.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

/// Where the robot is, and which walls of that cell it sees.
struct SeenCell {
  Pose pose;
  std::array<std::optional<bool>, 4> closed;  ///< by heading; nothing for a wall that it does not see

  friend bool operator==(const SeenCell&, const SeenCell&) = default;
};

/// A value with a name, as in `batt=7900`.
struct LiveField {
  std::string name;
  std::string value;  ///< printable ASCII without blanks; what is known of its name holds

  friend bool operator==(const LiveField&, const LiveField&) = default;
};

/// What a line says; at least one of its parts is there.
struct LiveLine {
  std::int64_t number = 0;    ///< of the line, from 1
  bool has_checksum = false;  ///< and it is right
  bool is_restart = false;    ///< the robot has started anew
  std::optional<SeenCell> seen = {};
  std::vector<LiveField> fields = {};
  /// A drawing of the whole map, whose last line this is.
  std::shared_ptr<const PartialMap> drawing = {};

  friend bool operator==(const LiveLine& one, const LiveLine& other);
};

/// Reads a line.
/// @param line without its line end.
/// @return nothing for any other line: noise, a part of a line, a wrong checksum. Its number is 0.
std::optional<LiveLine> read_live_line(std::string_view line);

}  // namespace labmouse
