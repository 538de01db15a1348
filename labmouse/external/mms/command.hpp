// Parses a command line of the mms protocol.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "labmouse/grid/heading.hpp"

namespace labmouse {

enum class MmsVerb : std::uint8_t {
  // These have a reply.
  maze_width,
  maze_height,
  wall,
  move,
  turn,
  was_reset,
  ack_reset,
  get_stat,
  // These draw, and have no reply.
  set_wall,
  clear_wall,
  set_colour,
  clear_colour,
  clear_all_colour,
  set_text,
  clear_text,
  clear_all_text,
};

/// One command. Fields that a verb does not need are unused.
struct MmsCommand {
  MmsVerb verb = MmsVerb::maze_width;
  /// Of turn and wall: the direction, in turns of 45 degrees clockwise from ahead.
  int eighths = 0;
  /// Of move: the half steps asked for; of wall: how many of them to look ahead. Any number, also 0 or less.
  std::int64_t half_steps = 1;
  /// The cell to draw in; it may lie outside of the maze.
  int x = 0, y = 0;
  Heading side = Heading::north;
  char colour = 0;
  /// What to write in the cell, or the name of a statistic: a part of the line.
  std::string_view text;
};

/// A parsed line: a command, or the problem, to follow the quoted line in a message, such as "has no reply: turnRight
/// takes no argument".
struct MmsLine {
  std::optional<MmsCommand> command;
  std::string problem;
};

/// Parses a line without its end; the command points into the line.
MmsLine read_mms_line(std::string_view line);

/// A hint to follow the problem of a line with an unknown name: "; did you mean NAME?"; else empty. It compares all
/// names, so it is too slow for millions of lines.
std::string mms_suggestion(std::string_view line);

}  // namespace labmouse
