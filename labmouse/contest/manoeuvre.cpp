#include "labmouse/contest/manoeuvre.hpp"

namespace labmouse {

Manoeuvre straight_through(const Maze& maze, const Pose& pose) {
  const int walls = (maze.is_open(pose.cell, left_of(pose.heading)) ? 0 : 1) +
                    (maze.is_open(pose.cell, right_of(pose.heading)) ? 0 : 1);
  return walls == 0 ? Manoeuvre::open_cell : walls == 1 ? Manoeuvre::half_cell : Manoeuvre::corridor;
}

Manoeuvre manoeuvre_of(const Maze& maze, const SearchPlace& from, const Action& action) {
  if (action.movement == 0) return Manoeuvre::halt;
  if (from.at_rest) return Manoeuvre::start;
  if (action.movement > 1) return Manoeuvre::dash;
  if (action.rotation == 0) return straight_through(maze, from.pose);
  return action.rotation == 180 ? Manoeuvre::turn_back : Manoeuvre::turn;
}

Manoeuvre manoeuvre_of(const DriveSegment& segment) {
  return segment.kind == DriveSegment::Kind::turn ? Manoeuvre::run_turn
         : segment.diagonal()                     ? Manoeuvre::run_diagonal
                                                  : Manoeuvre::run_straight;
}

}  // namespace labmouse
