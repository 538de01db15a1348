// What a mouse knows that looks no farther than the walls about it.
#pragma once

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/search_tree.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// The passages between the cells in which a mouse has stood: of each it learns, when it first stands there, the walls
/// to the left, ahead and to the right. What it walked through is open as well: the way that it came is always known.
class NearWalls {
 public:
  explicit NearWalls(Cell start) : last_(start) {}

  /// Learns where the mouse stands now, one straight move from where it stood before.
  void arrive(Pose pose, const Sighting& seen) {
    for (Cell cell = pose.cell; cell != last_;) {
      const Heading back = move_between(cell, last_).direction;
      open_.insert(wall_at(cell, back));
      cell = neighbour(cell, back);
    }
    last_ = pose.cell;
    if (!stood_in_.contains(pose.cell)) look_around(pose, seen);
  }

  const WallSet& open() const { return open_; }
  const CellSet& stood_in() const { return stood_in_; }

 private:
  void look_around(Pose pose, const Sighting& seen) {
    stood_in_.insert(pose.cell);
    for (const int quarters : {-1, 0, 1}) {
      const Heading direction = turned(pose.heading, quarters);
      if (seen.towards(quarters) > 0 && stood_in_.contains(neighbour(pose.cell, direction)))
        open_.insert(wall_at(pose.cell, direction));
    }
  }

  WallSet open_;
  CellSet stood_in_;
  Cell last_;
};

}  // namespace labmouse
