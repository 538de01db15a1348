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
      known_(maze.size(), 1),
      told_(told_of(model, conditions)),
      body_(maze, model, conditions, seed, time_limit, record),
      pilot_(model, told_, maze.size(), gains_for(told_, model.tables.cell), conditions.pilot, parts) {
  record_.foreign_parts = parts.any();
  pilot_.know(&known_);
}

void PhysicalDriver::put_at_start() {
  body_.put_at_start();
  pilot_.put(start_);
  pending_ = false;
}

bool PhysicalDriver::make(const Action& part, bool replanned) {
  const Pose from = place().pose;
  const MazeTime begin = clock();
  pilot_.search(part);
  if (!drive_on()) return false;
  DriveRun& run = record_.drive.runs.back();
  run.moves.push_back({begin, clock(), from, part, place().pose, replanned});
  run.end = clock();
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
  return wall && known_.open().contains(*wall) ? RunEnd::misread : body_.cause();
}

void PhysicalDriver::read() {
  const Pose& pose = place().pose;
  const WallEvidence evidence = pilot_.evidence();
  record_.looks.push_back({clock(), pose, evidence});
  const Sighting seen = {open(pose.cell, left_of(pose.heading), evidence.left),
                         open(pose.cell, pose.heading, evidence.ahead),
                         open(pose.cell, right_of(pose.heading), evidence.right)};
  [[maybe_unused]] const bool agrees = known_.learn(pose, seen);
  assert(agrees);
}

/// 1 where the mouse takes the wall for open.
int PhysicalDriver::open(Cell cell, Heading side, Evidence evidence) {
  const Wall wall = wall_at(cell, side);
  const bool reads_closed = evidence > 0;
  // Nobody has to read the border.
  if (on_border(wall, maze_.size())) return 0;
  const WallState state = known_.state(wall);
  if (state != WallState::unknown) {
    constexpr int telling = 2 * evidence_a_nat;
    if (std::abs(evidence) >= telling && reads_closed != (state == WallState::closed)) ++record_.contradictions;
    return state == WallState::open ? 1 : 0;
  }
  if (reads_closed == maze_.is_open(cell, side)) ++record_.misreads;
  record_.drive.walls.push_back({clock(), wall, !reads_closed});
  return reads_closed ? 0 : 1;
}

Sighting PhysicalDriver::sighting(const Pose& pose) const {
  const auto open_to = [&](Heading side) { return known_.open().contains(wall_at(pose.cell, side)) ? 1 : 0; };
  return {open_to(left_of(pose.heading)), open_to(pose.heading), open_to(right_of(pose.heading))};
}

}  // namespace labmouse
