// The true maze, which never changes.
#pragma once

#include "labmouse/grid/wall_set.hpp"

namespace labmouse {

/// A maze under construction: a reader, generator or editor fills it, and Maze makes it final. Cells must lie inside;
/// readers check their input first.
class MazeDraft {
 public:
  /// The state of all inner walls at the beginning.
  enum class Inside { open, closed };

  /// A maze with its border closed, the start at (0,0) heading north, and no goal marked.
  /// @param size must be valid.
  /// @param inside whether all inner walls are open or closed.
  MazeDraft(Size size, Inside inside);

  /// The width and height.
  Size size() const { return size_; }
  /// Whether one can pass from a cell to its neighbour; false at the border.
  /// @param cell inside the maze.
  /// @param side where the neighbour lies.
  bool is_open(Cell cell, Heading side) const;
  /// Opens an inner wall. The border stays closed: opening it does nothing.
  /// @param cell inside the maze.
  /// @param side where the wall is, seen from the cell.
  void open(Cell cell, Heading side);
  /// Closes an inner wall.
  /// @param cell inside the maze.
  /// @param side where the wall is, seen from the cell.
  void close(Cell cell, Heading side);

  /// Puts the start there; it replaces the one before.
  /// @param cell inside the maze.
  /// @param heading that of the mouse at the start.
  void set_start(Cell cell, Heading heading = Heading::north);
  /// Marks a cell as a goal, besides those before.
  /// @param cell inside the maze.
  void add_goal(Cell cell);

  /// The cell where the mouse starts.
  Cell start() const { return start_; }
  /// The heading of the mouse at the start.
  Heading start_heading() const { return start_heading_; }
  /// The cells marked as goals so far; may be empty.
  const CellSet& goals() const { return goals_; }
  /// The inner walls that are open so far.
  const WallSet& open_walls() const { return open_; }

 private:
  Size size_;
  WallSet open_;
  Cell start_;
  Heading start_heading_ = Heading::north;
  CellSet goals_;
};

/// The cells in the centre of a maze: 2×2, 2×1, 1×2 or 1, as width and height are even or odd.
/// @param size must be valid.
CellSet centre_of(Size size);

/// A maze: 1×1 to 64×64 cells, its walls, its start and its goals. Immutable; the border is closed; at least one goal.
class Maze {
 public:
  /// The final form of a draft.
  /// @param draft without a goal, the maze gets the centre as its goals.
  explicit Maze(const MazeDraft& draft);

  /// The width and height.
  Size size() const { return size_; }
  /// The cell where the mouse starts.
  Cell start() const { return start_; }
  /// The heading of the mouse at the start.
  Heading start_heading() const { return start_heading_; }
  /// The goals: at least one cell.
  const CellSet& goals() const { return goals_; }
  /// Whether a cell is a goal.
  /// @param cell any cell; false outside of the maze.
  bool is_goal(Cell cell) const { return goals_.contains(cell); }

  /// Whether one can pass from a cell to its neighbour; false at the border.
  /// @param cell inside the maze.
  /// @param side where the neighbour lies.
  bool is_open(Cell cell, Heading side) const { return open_.contains(wall_at(cell, side)); }
  /// The inner walls that are open, i.e. passages.
  const WallSet& open_walls() const { return open_; }
  /// What a sensor in the cell reads.
  /// @param cell inside the maze.
  /// @param heading where the sensor looks.
  /// @return the number of cells that lie open ahead, up to the next wall; 0 if a wall is next.
  int corridor(Cell cell, Heading heading) const;

  /// The same maze with another start.
  /// @param cell inside the maze.
  /// @param heading that of the mouse at the start.
  Maze with_start(Cell cell, Heading heading) const;
  /// The same maze with other goals.
  /// @param goals cells inside the maze, at least one.
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
