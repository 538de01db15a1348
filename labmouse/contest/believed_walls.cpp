#include "labmouse/contest/believed_walls.hpp"

namespace labmouse {

BelievedWalls::BelievedWalls(const Maze& maze, MapKind map, PhysicalRecord& record)
    : maze_(maze), record_(record), belief_(maze.size(), map), weighs_(map == MapKind::belief) {}

void BelievedWalls::read(MazeTime time, const Pose& pose, const WallEvidence& evidence) {
  record_.looks.push_back({time, pose, evidence});
  take(time, pose.cell, left_of(pose.heading), evidence.left);
  take(time, pose.cell, pose.heading, evidence.ahead);
  take(time, pose.cell, right_of(pose.heading), evidence.right);
}

void BelievedWalls::pass(MazeTime time, Cell from, const Pose& to) {
  constexpr int surely = 6 * evidence_a_nat;
  for (Cell cell = to.cell; cell != from; cell = neighbour(cell, opposite(to.heading)))
    add(time, wall_at(cell, opposite(to.heading)), -surely);
}

void BelievedWalls::take(MazeTime time, Cell cell, Heading side, Evidence evidence) {
  const Wall wall = wall_at(cell, side);
  // Nobody has to read the border.
  if (!on_border(wall, maze_.size())) add(time, wall, evidence);
}

void BelievedWalls::add(MazeTime time, Wall wall, int evidence) {
  const Belief::News news = belief_.add(wall, evidence);
  if (weighs_) told_last_[told_count_++ % told_last_.size()] = {wall, evidence};
  if (news == Belief::News::none) return;
  if (news != Belief::News::learned) ++record_.contradictions;
  if (news != Belief::News::contradicted) note(time, wall);
}

/// What it takes that wall for from now on.
void BelievedWalls::note(MazeTime time, Wall wall) {
  const bool open = known().open().contains(wall);
  if (open != maze_.is_open(wall.cell, wall.side)) ++record_.misreads;
  record_.drive.walls.push_back({time, wall, open});
}

void BelievedWalls::doubt_last() {
  for (const Told& told : told_last_) belief_.doubt(told.wall, told.evidence);
  told_last_ = {};
}

void BelievedWalls::forget_all() {
  WallSet::all(size()).for_each([&](Wall wall) { belief_.forget(wall); });
  put_down();
}

WallSet BelievedWalls::standing(const WallSet& walls) const {
  WallSet some = walls;
  some -= maze_.open_walls();
  return some;
}

Sighting BelievedWalls::sighting(const Pose& pose) const {
  const auto open_to = [&](Heading side) { return known().open().contains(wall_at(pose.cell, side)) ? 1 : 0; };
  return {open_to(left_of(pose.heading)), open_to(pose.heading), open_to(right_of(pose.heading))};
}

}  // namespace labmouse
