// A line in which a mouse says where it is and which walls it sees: in the logs of the format `steps`, and in what real
// robots send.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "labmouse/grid/cell.hpp"
#include "labmouse/grid/heading.hpp"

namespace labmouse::formats {

/// A line of a mouse.
struct StepLine {
  Cell cell;  ///< both numbers from 0 to max_side - 1
  Heading heading = Heading::north;
  std::array<std::optional<bool>, 4> closed;  ///< the walls of the cell by heading: closed, open, or not seen
  bool plain = false;                         ///< whether it begins with these four words
  std::string_view rest;                      ///< what follows them
};

/// Reads a line with x, y, a heading, and the walls as `1` (closed), `0` (open) or `?` (not seen): three on the left,
/// ahead and on the right, or four in the north, east, south and west. Other words may stand before and between them.
/// @return nothing if the line is another one.
std::optional<StepLine> read_step_line(std::string_view line);

}  // namespace labmouse::formats
