#include "labmouse/contest/physical_drive.hpp"

#include <cassert>
#include <cmath>

namespace labmouse {
namespace {

constexpr MazeTime tick_time = 1000;
/// A mouse that has slid so many ticks before a crash has crashed because of that.
constexpr int slide_ticks = 300;

/// To the left of east.
double angle_of(Heading heading) { return pi / 2.0 * (1 - static_cast<int>(heading)); }

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
                               std::uint64_t seed, MazeTime time_limit, PhysicalRecord& record)
    : maze_(maze),
      cell_(model.tables.cell),
      conditions_(conditions),
      time_limit_(time_limit),
      record_(record),
      start_{maze.start(), maze.start_heading()},
      known_(maze.size(), 1),
      told_(told_of(model, conditions)),
      body_(maze, cell_, *model.robot.hardware, conditions.noise, seed),
      pilot_(model, told_, maze.size(), gains_for(told_, cell_), conditions.pilot) {
  record_.frailty = body_.specimen().frailty();
  pilot_.know(&known_);
}

void PhysicalDriver::put_at_start() {
  body_.put({(start_.cell.x + 0.5) * cell_, (start_.cell.y + 0.5) * cell_}, angle_of(start_.heading));
  pilot_.put(start_);
  pending_ = false;
}

bool PhysicalDriver::make(const Action& part, bool replanned) {
  const Pose from = place().pose;
  const MazeTime begin = clock_;
  pilot_.search(part);
  if (!drive_on()) return false;
  DriveRun& run = record_.drive.runs.back();
  run.moves.push_back({begin, clock_, from, part, place().pose, replanned});
  run.end = clock_;
  read();
  return true;
}

bool PhysicalDriver::run(const DriveRoute& route) {
  pilot_.run(route);
  // Its clock begins once it stands where runs begin.
  while (!pilot_.running())
    if (!tick()) return false;
  record_.drive.runs.back().begin = clock_;
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
  const Touch touch = body_.step(drive_);
  clock_ += tick_time;
  if (touch != Touch::none) record_.touches.push_back({clock_, true_pose(), touch == Touch::crash});
  if (touch != Touch::crash) note_gates();
  trace();
  return touch != Touch::crash && !out_of_time();
}

/// Where the true mouse is, for the clock of the run. One that turns home at the edge of a goal has entered it when it
/// has come there, a moment later.
void PhysicalDriver::note_gates() {
  auto& runs = record_.drive.runs;
  if (runs.empty()) return;
  const bool home = runs.back().kind == DriveRun::Kind::home;
  if (home && (runs.size() < 2 || runs[runs.size() - 2].gate_in || record_.ends[runs.size() - 2] != RunEnd::done))
    return;
  DriveRun& run = home ? runs[runs.size() - 2] : runs.back();
  const Position& at = body_.motion().position;
  const Cell cell = body_.field().cell_at(at);
  if (!maze_.size().contains(cell)) return;
  if (!run.gate_out && cell != maze_.start()) run.gate_out = clock_;
  if (!run.gate_out || !maze_.is_goal(cell)) return;
  if (!run.gate_in) run.gate_in = clock_;
  const Direction& ahead = body_.motion().ahead;
  const double past = (at.x - (cell.x + 0.5) * cell_) * ahead.cosine + (at.y - (cell.y + 0.5) * cell_) * ahead.sine;
  if (!run.centre && past >= 0.0) run.centre = clock_;
}

void PhysicalDriver::trace() {
  const int every = conditions_.trace_every;
  if (every == 0 || clock_ / tick_time % every != 0) return;
  const Estimator& belief = pilot_.estimator();
  record_.trace.push_back({clock_, true_pose(), {belief.position(), angle_of(belief.ahead())}, body_.sense().infrared});
}

RunEnd PhysicalDriver::cause() const {
  const auto& wall = body_.contact().wall;
  if (wall && known_.open().contains(*wall)) return RunEnd::misread;
  return body_.slid_within(slide_ticks) ? RunEnd::slid : RunEnd::strayed;
}

void PhysicalDriver::read() {
  const Pose& pose = place().pose;
  const WallEvidence evidence = pilot_.evidence();
  record_.looks.push_back({clock_, pose, evidence});
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
  record_.drive.walls.push_back({clock_, wall, !reads_closed});
  return reads_closed ? 0 : 1;
}

Sighting PhysicalDriver::sighting(const Pose& pose) const {
  const auto open_to = [&](Heading side) { return known_.open().contains(wall_at(pose.cell, side)) ? 1 : 0; };
  return {open_to(left_of(pose.heading)), open_to(pose.heading), open_to(right_of(pose.heading))};
}

}  // namespace labmouse
