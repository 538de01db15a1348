// The maze in mm: walls with a thickness, and posts where they can meet.
//
//      line 1  o---o---o      Lines lie at multiples of the cell; walls and posts reach half a wall to both of their
//              |   |   |      sides. x counts eastwards, y northwards, from the south-western corner of the maze.
//      line 0  o---o---o
//           line 0   1   2
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "labmouse/functions/position.hpp"
#include "labmouse/functions/whole.hpp"
#include "labmouse/hardware/beam.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

class Field {
 public:
  /// `post_shifts`: by how much each post is off its place in mm, row by row from the south-western one, or none.
  Field(const Maze& maze, double cell, std::vector<Position> post_shifts = {});

  double cell() const { return cell_; }
  double half_wall() const { return half_wall_; }

  /// The cell around a point; outside of the maze one that lies outside.
  Cell cell_at(const Position& position) const { return {index_at(position.x), index_at(position.y)}; }
  int index_at(double coordinate) const { return whole_below(coordinate * per_cell_); }
  bool contains(Cell cell) const { return size_.contains(cell); }
  bool contains(int column, int row) const {
    return static_cast<unsigned>(column) < static_cast<unsigned>(size_.width) &&
           static_cast<unsigned>(row) < static_cast<unsigned>(size_.height);
  }
  /// Whether a wall stands on that side of a cell; none does of a cell outside.
  bool stands(int column, int row, Heading side) const {
    if (!contains(column, row)) return false;
    const auto index = static_cast<std::size_t>(row * size_.width + column);
    return (walls_[index] >> static_cast<unsigned>(side) & 1U) != 0;
  }
  /// Whether a wall stands on a line across x, in a row; or on a line across y, in a column.
  bool stands_upright(int line, int row) const {
    return stands(line, row, Heading::west) || stands(line - 1, row, Heading::east);
  }
  bool stands_level(int column, int line) const {
    return stands(column, line, Heading::south) || stands(column, line - 1, Heading::north);
  }

  /// The most by which a post is off its place, in x or in y.
  double most_shift() const { return most_shift_; }
  /// By how much the post at these lines is off its place.
  Position post_shift(int column, int row) const {
    if (post_shifts_.empty() || column < 0 || row < 0 || column > size_.width || row > size_.height) return {};
    return post_shifts_[static_cast<std::size_t>(row * (size_.width + 1) + column)];
  }
  /// By how much a wall between two posts is off its line: that across x at y, eastwards; that across y at x,
  /// northwards.
  double upright_shift(int line, double y) const;
  double level_shift(double x, int line) const;

 private:
  Size size_;
  double cell_;
  double per_cell_;
  double half_wall_;
  std::vector<std::uint8_t> walls_;  ///< of each cell, a bit for each side
  std::vector<Position> post_shifts_;
  double most_shift_ = 0.0;
};

}  // namespace labmouse
