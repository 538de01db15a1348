// What a mouse knows: which walls are open, which are closed, and which it has not seen.
#pragma once

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

enum class WallState : std::uint8_t { unknown, open, closed };

/// Known walls of one maze. A known wall never changes, unless a LogOddsMap behind it forgets one. The border is known
/// from the beginning.
class Knowledge {
 public:
  /// For a mouse whose readings reach `sight` cells: a reading of that many shows no wall at its end.
  explicit Knowledge(Size size, int sight = max_side);

  Size size() const { return size_; }
  WallState state(Wall wall) const;

  /// Learns all that a reading shows: in each of the three directions the open walls of the corridor, and the closed
  /// one at its end where that lies in sight. False, and nothing is learned, where the reading contradicts what is
  /// known.
  [[nodiscard]] bool learn(Pose pose, Sighting sighting);

  /// Learns an inner wall that is unknown.
  void learn(Wall wall, bool open);
  /// Makes an inner wall unknown. Plans that used it must be made anew.
  void forget(Wall wall);

  /// Walls known to be open: passages.
  const WallSet& open() const { return open_; }
  /// Walls not known to be closed: open and unknown ones. Contains open().
  const WallSet& possible() const { return possible_; }
  /// Walls that have not been seen.
  WallSet unknown() const;
  /// Whether all four walls of a cell are known.
  bool knows(Cell cell) const;
  /// All such cells.
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
