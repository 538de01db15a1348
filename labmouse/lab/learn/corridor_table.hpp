// Precomputed readings of a maze, one word per cell, so that a step of a learner is a table look-up.
//
//      bits  0.. 5   cells open to the north         bit 7   the cell is a goal
//      bits  8..13   ... to the east
//      bits 16..21   ... to the south
//      bits 24..29   ... to the west
#pragma once

#include <cstdint>
#include <span>

#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

using Corridors = std::uint32_t;

inline constexpr Corridors goal_mark = 0x80;

constexpr bool is_goal(Corridors cell) { return (cell & goal_mark) != 0; }
constexpr int corridor(Corridors cell, Heading heading) {
  return static_cast<int>(cell >> (8 * static_cast<unsigned>(heading)) & 63U);
}
constexpr Sighting sighting_of(Corridors cell, Heading heading) {
  return {corridor(cell, left_of(heading)), corridor(cell, heading), corridor(cell, right_of(heading))};
}

/// Writes the table of a maze: the word of cell (x,y) at y * pitch + x. `pitch` is at least the maze's width, and the
/// table has at least pitch * height words. All other words become 0.
void write_corridors(const Maze& maze, int pitch, std::span<Corridors> table);

}  // namespace labmouse
