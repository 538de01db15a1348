// The wall follower, the simplest maze solver. Contest mazes are built to defeat it.
#pragma once

#include <cstdint>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The hand that stays on the wall.
enum class Hand : std::uint8_t { left, right };

/// Whether a mouse that begins at the maze's start and keeps one hand on the wall ever enters a goal. In each cell it
/// takes the first open side of: towards the hand, ahead, away from the hand, behind. It fails when it comes to a cell
/// with a heading that it had there before, or cannot move at all.
bool wall_follower_arrives(const Maze& maze, Hand hand);

}  // namespace labmouse
