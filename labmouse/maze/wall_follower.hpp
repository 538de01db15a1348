// The wall follower: the oldest way through a maze, and the one that contest mazes are built to defeat.
#pragma once

#include <cstdint>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The hand that stays on the wall.
enum class Hand : std::uint8_t { left, right };

/// Whether a mouse that starts at the maze's start and keeps one hand on the wall, going cell by cell, ever enters a
/// goal. It takes the first open side of: towards the hand, ahead, away from the hand, behind. It has failed when it
/// stands in a cell with the heading it had there before, or cannot move at all.
bool wall_follower_arrives(const Maze& maze, Hand hand);

}  // namespace labmouse
