#include "labmouse/contest/physical_drive.hpp"

#include <cassert>
#include <cmath>

namespace labmouse {
namespace {

double angle_of(const Direction& ahead) {
  // To the microradian, for traces: a fit to within an eighth of a turn, then a step of Newton's.
  const double c = ahead.cosine, s = ahead.sine;
  double angle = std::abs(c) > std::abs(s) ? (c > 0.0 ? s : pi - s) : (s > 0.0 ? pi / 2.0 - c : -pi / 2.0 + c);
  for (int i = 0; i < 3; ++i) {
    const Direction at = direction_of(angle);
    angle += s * at.cosine - c * at.sine;
  }
  return angle;
}

}  // namespace

PhysicalDriver::PhysicalDriver(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions,
                               std::uint64_t seed, MazeTime time_limit, PhysicalRecord& record, const PilotParts& parts)
    : maze_(maze),
      record_(record),
      start_{maze.start(), maze.start_heading()},
      belief_(maze.size(), conditions.map),
      weighs_(conditions.map == MapKind::belief),
      told_(told_of(model, conditions)),
      body_(maze, model, conditions, seed, time_limit, record),
      pilot_(model, told_, maze.size(), gains_for(told_, model.tables.cell), conditions.pilot, parts) {
  record_.foreign_parts = parts.any();
  pilot_.know(&belief_.view());
}

void PhysicalDriver::put_at_start() {
  body_.put_at_start();
  pilot_.put(start_);
  pending_ = false;
  told_last_ = {};
}

bool PhysicalDriver::make(const Action& part, bool replanned) {
  const Pose from = place().pose;
  const MazeTime begin = clock();
  pilot_.search(part);
  if (!drive_on()) return false;
  DriveRun& run = record_.drive.runs.back();
  run.moves.push_back({begin, clock(), from, part, place().pose, replanned});
  run.end = clock();
  if (weighs_) pass(from);
  read();
  return true;
}

bool PhysicalDriver::run(const DriveRoute& route) {
  pilot_.run(route);
  // Its clock begins once it stands where runs begin.
  while (!pilot_.running())
    if (!tick()) return false;
  record_.drive.runs.back().begin = clock();
  return drive_on();
}

bool PhysicalDriver::drive_on() {
  for (;;) {
    if (!pending_) {
      drive_ = pilot_.tick(body_.sense());
      pending_ = true;
    }
    if (pilot_.arrived()) return true;
    if (!tick()) return false;
  }
}

bool PhysicalDriver::tick() {
  if (!pending_) drive_ = pilot_.tick(body_.sense());
  pending_ = false;
  const bool goes_on = body_.step(drive_);
  if (!body_.crashed()) note_gates();
  if (body_.trace_due()) {
    const PoseEstimate& belief = pilot_.estimate();
    body_.trace(BodyPose{belief.position, angle_of(belief.ahead)});
  }
  return goes_on;
}

/// A mouse that turns home at the edge of a goal has entered it when it has come there, a moment later.
void PhysicalDriver::note_gates() {
  auto& runs = record_.drive.runs;
  if (runs.empty()) return;
  const std::size_t last = runs.size() - 1;
  if (runs[last].kind != DriveRun::Kind::home)
    body_.note_gates(runs[last]);
  else if (last > 0 && !runs[last - 1].gate_in && record_.ends[last - 1] == RunEnd::done)
    body_.note_gates(runs[last - 1]);
}

RunEnd PhysicalDriver::cause() const {
  const auto& wall = body_.body().contact().wall;
  return wall && known().open().contains(*wall) ? RunEnd::misread : body_.cause();
}

/// It has come through the walls on its way.
void PhysicalDriver::pass(const Pose& from) {
  constexpr int surely = 6 * evidence_a_nat;
  const Pose& to = place().pose;
  for (Cell cell = to.cell; cell != from.cell; cell = neighbour(cell, opposite(to.heading)))
    add(wall_at(cell, opposite(to.heading)), -surely);
}

void PhysicalDriver::read() {
  const Pose& pose = place().pose;
  const WallEvidence evidence = pilot_.evidence();
  record_.looks.push_back({clock(), pose, evidence});
  take(pose.cell, left_of(pose.heading), evidence.left);
  take(pose.cell, pose.heading, evidence.ahead);
  take(pose.cell, right_of(pose.heading), evidence.right);
}

void PhysicalDriver::take(Cell cell, Heading side, Evidence evidence) {
  const Wall wall = wall_at(cell, side);
  // Nobody has to read the border.
  if (!on_border(wall, maze_.size())) add(wall, evidence);
}

void PhysicalDriver::add(Wall wall, int evidence) {
  const Belief::News news = belief_.add(wall, evidence);
  if (weighs_) told_last_[told_count_++ % told_last_.size()] = {wall, evidence};
  if (news == Belief::News::none) return;
  if (news != Belief::News::learned) ++record_.contradictions;
  if (news != Belief::News::contradicted) note(wall);
}

/// What it takes that wall for from now on.
void PhysicalDriver::note(Wall wall) {
  const bool open = known().open().contains(wall);
  if (open != maze_.is_open(wall.cell, wall.side)) ++record_.misreads;
  record_.drive.walls.push_back({clock(), wall, open});
}

void PhysicalDriver::doubt_last() {
  for (const Told& told : told_last_)
    if (told.evidence != 0 && known().state(told.wall) != WallState::unknown &&
        belief_.add(told.wall, -told.evidence / 2) == Belief::News::turned)
      note(told.wall);
  told_last_ = {};
}

Sighting PhysicalDriver::sighting(const Pose& pose) const {
  const auto open_to = [&](Heading side) { return known().open().contains(wall_at(pose.cell, side)) ? 1 : 0; };
  return {open_to(left_of(pose.heading)), open_to(pose.heading), open_to(right_of(pose.heading))};
}

}  // namespace labmouse
