// What a mouse knows: which walls are open, which are closed, and which it has not seen.
#pragma once

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// What a mouse knows of a wall.
enum class WallState : std::uint8_t { unknown, open, closed };

/// Known walls of one maze. A known wall never changes, unless a LogOddsMap behind it forgets one. The border is known
/// from the beginning.
class Knowledge {
 public:
  /// All inner walls unknown.
  /// @param size of the maze, with sides of 1 to max_side cells.
  /// @param sight range of a reading in cells, at least 1; a reading of that many shows no wall at its end.
  explicit Knowledge(Size size, int sight = max_side);

  /// The size of the maze.
  Size size() const { return size_; }
  /// The state of a wall.
  /// @param wall any wall; those of the border and outside are `closed`.
  WallState state(Wall wall) const;

  /// Learns all that a reading shows: in each of the three directions the open walls of the corridor, and the closed
  /// one at its end where that lies in sight.
  /// @param pose where it was read, inside the maze.
  /// @param sighting in cells.
  /// @return false, and nothing is learned, if the reading contradicts what is known, or is below 0 or above the sight.
  [[nodiscard]] bool learn(Pose pose, Sighting sighting);

  /// Learns a wall.
  /// @param wall an inner one whose state is unknown.
  /// @param open whether it is open or closed.
  void learn(Wall wall, bool open);
  /// Makes a wall unknown. Plans that used it must be made anew.
  /// @param wall an inner one, in any state.
  void forget(Wall wall);

  /// Walls known to be open: passages.
  const WallSet& open() const { return open_; }
  /// Inner walls not known to be closed: open and unknown ones. Contains open().
  const WallSet& possible() const { return possible_; }
  /// Inner walls that have not been seen.
  WallSet unknown() const;
  /// Whether all four walls of a cell are known.
  /// @param cell inside the maze.
  bool knows(Cell cell) const;
  /// All cells of the maze whose four walls are known.
  CellSet known_cells() const;

  friend bool operator==(const Knowledge&, const Knowledge&) = default;

 private:
  bool agrees(Pose pose, int open_cells) const;
  void learn_corridor(Pose pose, int open_cells);

  Size size_;
  int sight_;
  WallSet open_;
  WallSet possible_;
};

}  // namespace labmouse
