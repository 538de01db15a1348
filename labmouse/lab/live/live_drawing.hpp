// The map of a real robot as text for a terminal.
#pragma once

#include <string>

#include "labmouse/lab/live/live_map.hpp"
#include "labmouse/lab/live/live_reader.hpp"

namespace labmouse {

/// Draws the map with the robot and its planned route: walls that it has not seen are faint. Over a known maze, false
/// and missed walls are marked.
/// @param colours whether to add ANSI colours.
/// @return lines that end in a line feed.
std::string draw_live(const LiveMap& map, bool colours);

/// Two lines: the counts of the map and of the stream, and the newest values of the robot's fields.
std::string live_summary(const LiveMap& map, const LiveReader& reader);

}  // namespace labmouse
