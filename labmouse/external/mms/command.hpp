// The language of mms: one line, and what it asks for.
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
  // These draw, and have none.
  set_wall,
  clear_wall,
  set_colour,
  clear_colour,
  clear_all_colour,
  set_text,
  clear_text,
  clear_all_text,
};

/// One command. What a verb does not need has no meaning.
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

/// A line as mms takes it: a command, or the rest of a sentence that begins with the line and says why it is none, such
/// as "has no reply: turnRight takes no argument".
struct MmsLine {
  std::optional<MmsCommand> command;
  std::string problem;
};

/// Reads a line without its end; the command points into it.
MmsLine read_mms_line(std::string_view line);

/// What its writer may have meant, to follow the problem of a line with a name that mms does not know: "; did you mean
/// NAME?"; else empty. It looks at all names, which is too slow for each of a million lines.
std::string mms_suggestion(std::string_view line);

}  // namespace labmouse
