// The maze as a body meets it: walls with a thickness, and posts where they can meet, in mm.
//
//      line 1  o---o---o      Lines lie at multiples of the cell; walls and posts reach half a wall to both of their
//              |   |   |      sides. x counts eastwards, y northwards, from the south-western corner of the maze.
//      line 0  o---o---o
//           line 0   1   2
#pragma once

#include "labmouse/functions/position.hpp"
#include "labmouse/functions/whole.hpp"
#include "labmouse/hardware/beam.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

class Field {
 public:
  /// The maze must outlive it.
  Field(const Maze& maze, double cell) : maze_(&maze), cell_(cell), half_wall_(half_wall_of(cell)) {}

  const Maze& maze() const { return *maze_; }
  double cell() const { return cell_; }
  double half_wall() const { return half_wall_; }

  /// The cell around a point; outside of the maze one that lies outside.
  Cell cell_at(const Position& position) const { return {index_at(position.x), index_at(position.y)}; }
  int index_at(double coordinate) const { return whole_below(coordinate / cell_); }
  bool contains(Cell cell) const { return maze_->size().contains(cell); }
  /// Whether a wall stands on that side of a cell; none does of a cell outside.
  bool stands(Cell cell, Heading side) const { return contains(cell) && !maze_->is_open(cell, side); }

 private:
  const Maze* maze_;
  double cell_;
  double half_wall_;
};

}  // namespace labmouse
