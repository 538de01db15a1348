// The true maze, which never changes.
#pragma once

#include "labmouse/grid/wall_set.hpp"

namespace labmouse {

/// A maze under construction: a reader, generator or editor fills it, and Maze makes it final. Cells must lie inside;
/// readers check their input first.
class MazeDraft {
 public:
  enum class Inside { open, closed };

  /// A maze of that size (which must be valid) with the border closed and all inner walls open or closed, the start at
  /// (0,0) heading north, and no goal marked.
  MazeDraft(Size size, Inside inside);

  Size size() const { return size_; }
  /// Whether one can pass from the cell to its neighbour on that side; false at the border.
  bool is_open(Cell cell, Heading side) const;
  /// Opens or closes an inner wall. The border stays closed: opening it does nothing.
  void open(Cell cell, Heading side);
  void close(Cell cell, Heading side);

  /// Puts the start there; it replaces the one before.
  void set_start(Cell cell, Heading heading = Heading::north);
  /// Marks a cell as a goal, besides those before.
  void add_goal(Cell cell);

  Cell start() const { return start_; }
  Heading start_heading() const { return start_heading_; }
  const CellSet& goals() const { return goals_; }
  const WallSet& open_walls() const { return open_; }

 private:
  Size size_;
  WallSet open_;
  Cell start_;
  Heading start_heading_ = Heading::north;
  CellSet goals_;
};

/// The cells in the centre: 2×2, 2×1, 1×2 or 1, as width and height are even or odd.
CellSet centre_of(Size size);

/// A maze: 1×1 to 64×64 cells, its walls, its start and its goals. Immutable; the border is closed; at least one goal.
class Maze {
 public:
  /// The final form of a draft. A draft without a goal gets the centre.
  explicit Maze(const MazeDraft& draft);

  Size size() const { return size_; }
  Cell start() const { return start_; }
  Heading start_heading() const { return start_heading_; }
  const CellSet& goals() const { return goals_; }
  bool is_goal(Cell cell) const { return goals_.contains(cell); }

  /// Whether one can pass from the cell (which must lie inside) to its neighbour on that side.
  bool is_open(Cell cell, Heading side) const { return open_.contains(wall_at(cell, side)); }
  /// The inner walls that are open, i.e. passages.
  const WallSet& open_walls() const { return open_; }
  /// What a sensor in the cell reads.
  /// @param cell inside the maze.
  /// @param heading where the sensor looks.
  /// @return the number of cells that lie open ahead, up to the next wall; 0 if a wall is next.
  int corridor(Cell cell, Heading heading) const;

  /// The same maze with another start, or with other goals (not empty). The cells must lie inside.
  Maze with_start(Cell cell, Heading heading) const;
  Maze with_goals(const CellSet& goals) const;

  friend bool operator==(const Maze&, const Maze&) = default;

 private:
  Size size_;
  WallSet open_;
  Cell start_;
  Heading start_heading_ = Heading::north;
  CellSet goals_;
};

}  // namespace labmouse
