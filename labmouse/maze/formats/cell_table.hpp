// Code shared by the formats that describe each cell by its four sides: capstone, num and maz.
//
// They state every inner wall twice, once for each of its cells, so a file can contradict itself. They cannot store a
// start or a goal, so both are the default.
#pragma once

#include <span>
#include <string>

#include "labmouse/maze/formats/read_result.hpp"

namespace labmouse::formats {

/// The sides of a cell as bits: bit 0 north, 1 east, 2 south, 3 west.
using Sides = unsigned;
inline constexpr Sides all_sides = 15;

constexpr bool has_side(Sides sides, Heading side) { return (sides >> static_cast<unsigned>(side) & 1U) != 0; }

/// The sides of one cell as a file states them, and their place in the file.
struct CellStatement {
  Cell cell;
  Sides open = 0;
  int line = 0;
  int column = 0;
};

/// The most openings in the border that are taken for an entrance and an exit, and the fewest cells of such a maze: in
/// other files, they show that the file is read in a wrong way.
inline constexpr int most_gaps = 2;
inline constexpr int least_cells_with_gaps = 16;

/// Builds the maze from one statement for each cell of that size. Fails with each open side that is closed by the
/// neighbour's statement or is one of too many on the border, in the order of the statements.
ReadResult maze_of(Size size, std::span<const CellStatement> statements);

/// The open sides of a cell.
Sides open_sides(const Maze& maze, Cell cell);

/// Why a format without start and goal cannot store the maze: one of them is not the default. Empty if it can.
std::string refused_marks(const Maze& maze);

/// The same for a table of cells, which also needs two rows and columns to be told from other lists of numbers.
std::string refused_table(const Maze& maze);

}  // namespace labmouse::formats
