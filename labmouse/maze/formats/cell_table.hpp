// What the formats share that describe each cell by its four sides: capstone, num and maz.
//
// They state every inner wall twice, once from either cell, so they can contradict themselves; and they have no place
// for a start or a goal, so both are the default.
#pragma once

#include <span>
#include <string>

#include "labmouse/maze/formats/read_result.hpp"

namespace labmouse::formats {

/// The sides of a cell as bits: bit 0 north, 1 east, 2 south, 3 west.
using Sides = unsigned;
inline constexpr Sides all_sides = 15;

constexpr bool has_side(Sides sides, Heading side) { return (sides >> static_cast<unsigned>(side) & 1U) != 0; }

/// What a file says of one cell, and where it says it.
struct CellStatement {
  Cell cell;
  Sides open = 0;
  int line = 0;
  int column = 0;
};

/// The maze of the statements, one for each cell of that size; or all open sides that lie on the border or whose
/// neighbour says otherwise, in the order of the statements.
ReadResult maze_of(Size size, std::span<const CellStatement> statements);

/// The open sides of a cell.
Sides open_sides(const Maze& maze, Cell cell);

/// Why a format without marks cannot hold the maze: its start or its goals are not the default. Empty when it can.
std::string refused_marks(const Maze& maze);

/// The same for a table of cells, which also needs two rows and columns to be told from other lists of numbers.
std::string refused_table(const Maze& maze);

}  // namespace labmouse::formats
