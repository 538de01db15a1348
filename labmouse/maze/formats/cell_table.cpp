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

// The open sides on the border.
std::vector<BorderGap> gaps_of(Size size, std::span<const CellStatement> statements) {
  std::vector<BorderGap> gaps;
  for (const auto& said : statements)
    for (const Heading side : all_headings)
      if (has_side(said.open, side) && !size.contains(neighbour(said.cell, side))) gaps.push_back({said.cell, side});
  return gaps;
}

}  // namespace

ReadResult maze_of(Size size, std::span<const CellStatement> statements) {
  SideTable table{};
  for (const auto& said : statements) table[static_cast<unsigned>(size.index(said.cell))] = said.open;

  std::vector<BorderGap> gaps = gaps_of(size, statements);
  const bool closes = gaps.size() <= most_gaps && size.area() >= least_cells_with_gaps;
  MazeDraft draft(size, MazeDraft::Inside::closed);
  ProblemList problems;
  for (const auto& said : statements) {
    for (const Heading side : all_headings) {
      if (!has_side(said.open, side)) continue;
      const Cell other = neighbour(said.cell, side);
      if (!size.contains(other)) {
        if (!closes) problems.add(said.line, said.column, open_border(said.cell, side));
      } else if (!has_side(table[static_cast<unsigned>(size.index(other))], opposite(side))) {
        problems.add(said.line, said.column, contradiction(said.cell, side));
      } else {
        draft.open(said.cell, side);
      }
    }
  }
  ReadResult result{.gaps = std::move(gaps)};
  if (problems.empty()) {
    result.maze = Maze(draft);
  } else {
    if (!problems.full() && (closes || result.gaps.empty())) result.repaired = Maze(draft);
    result.problems = problems.all();
  }
  return result;
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
