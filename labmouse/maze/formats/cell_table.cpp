#include "labmouse/maze/formats/cell_table.hpp"

#include <array>

#include "labmouse/maze/formats/problem_list.hpp"

namespace labmouse::formats {
namespace {

// The open sides of each cell, as the file states them for that cell.
using SideTable = std::array<Sides, max_side * max_side>;

std::string contradiction(Cell cell, Heading side) {
  return "cell " + name_of(cell) + " is open to the " + std::string(labmouse::name_of(side)) + " but its neighbour " +
         name_of(neighbour(cell, side)) + " is closed to the " + std::string(labmouse::name_of(opposite(side)));
}

// What is wrong with an open side; empty when nothing is.
std::string objection(Cell cell, Heading side, Size size, const SideTable& table) {
  const Cell other = neighbour(cell, side);
  if (!size.contains(other)) return open_border(cell, side);
  if (!has_side(table[static_cast<unsigned>(size.index(other))], opposite(side))) return contradiction(cell, side);
  return {};
}

}  // namespace

ReadResult maze_of(Size size, std::span<const CellStatement> statements) {
  SideTable table{};
  for (const auto& said : statements) table[static_cast<unsigned>(size.index(said.cell))] = said.open;

  MazeDraft draft(size, MazeDraft::Inside::closed);
  ProblemList problems;
  for (const auto& said : statements) {
    for (const Heading side : all_headings) {
      if (!has_side(said.open, side)) continue;
      if (std::string reason = objection(said.cell, side, size, table); !reason.empty())
        problems.add(said.line, said.column, std::move(reason));
      else
        draft.open(said.cell, side);
    }
  }
  if (!problems.empty()) return problems.failure();
  return {Maze(draft), {}};
}

Sides open_sides(const Maze& maze, Cell cell) {
  Sides open = 0;
  for (const Heading side : all_headings)
    if (maze.is_open(cell, side)) open |= 1U << static_cast<unsigned>(side);
  return open;
}

std::string refused_marks(const Maze& maze) {
  if (maze.start() != Cell{0, 0} || maze.start_heading() != Heading::north)
    return "the start is " + name_of(maze.start()) + " heading " +
           std::string(labmouse::name_of(maze.start_heading())) + "; this format requires (0,0) heading north";
  if (maze.goals() != centre_of(maze.size())) return "the goal is not the centre, as this format requires";
  return {};
}

std::string refused_table(const Maze& maze) {
  const auto [width, height] = maze.size();
  if (width == 1 || height == 1)
    return "the maze has " + std::to_string(width) + "x" + std::to_string(height) +
           " cells; this format holds only mazes from 2x2";
  return refused_marks(maze);
}

}  // namespace labmouse::formats
