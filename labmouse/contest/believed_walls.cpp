#include "labmouse/contest/believed_walls.hpp"

#include <cstdlib>

namespace labmouse {
namespace {

/// Evidence of a wall that is known for certain.
constexpr int surely = 6 * evidence_a_nat;

}  // namespace

BelievedWalls::BelievedWalls(const Maze& maze, MapKind map, PhysicalRecord& record)
    : maze_(maze),
      record_(record),
      log_odds_(maze.size(), map),
      weighs_(map != MapKind::first),
      asks_where_it_is_(map == MapKind::learned) {}

void BelievedWalls::read(MazeTime time, const Pose& pose, const WallEvidence& evidence) {
  record_.looks.push_back({time, pose, evidence});
  against_ = {0, against_[0]};
  take(time, pose.cell, left_of(pose.heading), evidence.left);
  take(time, pose.cell, pose.heading, evidence.ahead);
  take(time, pose.cell, right_of(pose.heading), evidence.right);
}

void BelievedWalls::know_open(MazeTime time, const WallSet& walls) {
  walls.for_each([&](Wall wall) { add(time, wall, -surely); });
}

void BelievedWalls::pass(MazeTime time, Cell from, const Pose& to) {
  for (Cell cell = to.cell; cell != from; cell = neighbour(cell, opposite(to.heading))) {
    const Wall wall = wall_at(cell, opposite(to.heading));
    passed_.insert(wall);
    add(time, wall, -surely);
  }
}

void BelievedWalls::close_after_crash(MazeTime time, Wall wall) {
  if (on_border(wall, maze_.size()) || passed_.contains(wall)) return;
  closed_by_crash_.insert(wall);
  add_to_map(time, wall, 2 * LogOddsMap::most);
}

void BelievedWalls::take(MazeTime time, Cell cell, Heading side, Evidence evidence) {
  const Wall wall = wall_at(cell, side);
  // The border is known.
  if (on_border(wall, maze_.size())) return;
  constexpr int sure = 4 * evidence_a_nat;
  if (closed_by_crash_.contains(wall) && evidence < 0) return;
  const LogOddsMap::News news = add(time, wall, evidence);
  const bool against = news == LogOddsMap::News::contradicted || news == LogOddsMap::News::turned;
  if (against && std::abs(evidence) >= sure) ++against_[0];
}

LogOddsMap::News BelievedWalls::add(MazeTime time, Wall wall, int evidence) {
  if (weighs_) last_evidence_[evidence_count_++ % last_evidence_.size()] = {wall, evidence};
  return add_to_map(time, wall, evidence);
}

LogOddsMap::News BelievedWalls::add_to_map(MazeTime time, Wall wall, int evidence) {
  const LogOddsMap::News news = log_odds_.add(wall, evidence);
  if (news == LogOddsMap::News::none) return news;
  if (news != LogOddsMap::News::learned) ++record_.contradictions;
  if (news != LogOddsMap::News::contradicted) note(time, wall);
  return news;
}

/// Records the new state of that wall.
void BelievedWalls::note(MazeTime time, Wall wall) {
  const bool open = known().open().contains(wall);
  if (open != maze_.is_open(wall.cell, wall.side)) ++record_.wrong_walls;
  record_.drive.walls.push_back({time, wall, open});
}

void BelievedWalls::weaken_last() {
  for (const Reading& last : last_evidence_) log_odds_.weaken(last.wall, last.evidence);
  last_evidence_ = {};
}

void BelievedWalls::forget_all() {
  WallSet::all(size()).for_each([&](Wall wall) { log_odds_.forget(wall); });
  closed_by_crash_ = passed_ = {};
  put_down();
}

WallSet BelievedWalls::standing(const WallSet& walls) const {
  WallSet some = walls;
  some -= maze_.open_walls();
  return some;
}

}  // namespace labmouse
