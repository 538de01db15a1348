#include "labmouse/contest/physical_drive.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

double angle_of(const Direction& ahead) {
  // Arctangent for traces, to the microradian: a rough start value, then three steps of Newton's method.
  const double c = ahead.cosine, s = ahead.sine;
  double angle = std::abs(c) > std::abs(s) ? (c > 0.0 ? s : pi - s) : (s > 0.0 ? pi / 2.0 - c : -pi / 2.0 + c);
  for (int i = 0; i < 3; ++i) {
    const Direction at = direction_of(angle);
    angle += s * at.cosine - c * at.sine;
  }
  return angle;
}

/// The walls between the cells of a straight way.
WallSet walls_between(Cell from, const Pose& to) {
  WallSet walls;
  for (Cell cell = to.cell; cell != from; cell = neighbour(cell, opposite(to.heading)))
    walls.insert(wall_at(cell, opposite(to.heading)));
  return walls;
}

}  // namespace

PhysicalDriver::PhysicalDriver(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions,
                               std::uint64_t seed, MazeTime time_limit, PhysicalRecord& record,
                               const ControllerParts& parts)
    : record_(record),
      start_{maze.start(), maze.start_heading()},
      handling_(conditions.handling),
      usual_pace_(conditions.controller.pace),
      walls_(maze, conditions.map, record),
      body_(maze, model, conditions, seed, time_limit, record),
      parts_(parts),
      controller_(model, *model.robot.hardware, maze.size(), gains_for(*model.robot.hardware, model.tables.cell),
                  conditions.controller, parts) {
  record_.foreign_parts = parts.any();
  controller_.know(&walls_.known());
}

void PhysicalDriver::put_at_start() {
  body_.put_at_start();
  body_.set_fan(false);
  controller_.put(start_);
  pending_ = false;
  walls_.put_down();
}

void PhysicalDriver::carry_to_start() {
  body_.wait(handling_);
  put_at_start();
}

void PhysicalDriver::look_about() {
  drive_on();
  read();
}

void PhysicalDriver::read() { walls_.read(clock(), place().pose, controller_.evidence()); }

bool PhysicalDriver::make(const Action& part, bool replanned) {
  const Pose from = place().pose;
  const MazeTime begin = clock();
  body_.set_fan(false);
  controller_.search(part);
  in_its_way_ = walls_.standing(walls_between(from.cell, place().pose));
  if (!drive_on()) return false;
  DriveRun& run = record_.drive.runs.back();
  run.moves.push_back({begin, clock(), from, part, place().pose, replanned});
  run.end = clock();
  if (walls_.weighs()) walls_.pass(clock(), from.cell, place().pose);
  read();
  return true;
}

bool PhysicalDriver::run(const DriveRoute& route) {
  controller_.run(route);
  in_its_way_ = walls_.standing(walls_of(route));
  body_.set_fan(true);
  // The clock starts after the mouse has backed up to the beginning of the run.
  while (!controller_.running())
    if (!tick()) return false;
  record_.drive.runs.back().begin = clock();
  return drive_on();
}

bool PhysicalDriver::drive_on() {
  for (;;) {
    if (!pending_) {
      drive_ = controller_.tick(body_.sense());
      pending_ = true;
    }
    if (controller_.arrived()) return true;
    if (!tick()) return false;
  }
}

bool PhysicalDriver::tick() {
  if (!pending_) drive_ = controller_.tick(body_.sense());
  pending_ = false;
  if (parts_.reason() != ForfeitReason::none) return false;
  const bool goes_on = body_.step(drive_);
  if (!body_.crashed()) note_gates();
  if (body_.trace_due()) {
    const PoseEstimate& estimate = controller_.estimate();
    body_.trace(BodyPose{estimate.position, angle_of(estimate.ahead)});
  }
  return goes_on;
}

/// A mouse that turns home at the edge of a goal may enter it a moment later, so the gates of the search are recorded
/// on the way home, too.
void PhysicalDriver::note_gates() {
  auto& runs = record_.drive.runs;
  if (runs.empty()) return;
  const std::size_t last = runs.size() - 1;
  if (runs[last].kind != DriveRun::Kind::home)
    body_.note_gates(runs[last]);
  else if (last > 0 && !runs[last - 1].gate_in && record_.ends[last - 1] == RunEnd::done)
    body_.note_gates(runs[last - 1]);
}

/// A crash next to a closed wall on the planned way counts as a wall detection error, even if the mouse hits a post
/// first.
std::optional<RunEnd> PhysicalDriver::crash() const {
  if (!body_.crashed()) return std::nullopt;
  const Cell cell = body_.cell();
  const auto stands = [&](Heading side) { return in_its_way_.contains(wall_at(cell, side)); };
  const bool inside = walls_.size().contains(cell);
  return inside && std::any_of(all_headings.begin(), all_headings.end(), stands) ? RunEnd::wall_error : body_.cause();
}

}  // namespace labmouse
