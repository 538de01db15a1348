#include "labmouse/contest/failure_drive.hpp"

#include <algorithm>

#include "labmouse/contest/brightness.hpp"
#include "labmouse/contest/drive_gates.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

MazeTime part_of(MazeTime time, double part) { return static_cast<MazeTime>(static_cast<double>(time) * part); }

}  // namespace

FailureDriver::FailureDriver(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions,
                             const FailureRates& failure_rates, std::uint64_t seed, MazeTime time_limit,
                             PhysicalRecord& record)
    : TimedDriver(maze, model, time_limit, record.drive),
      handling_(conditions.handling),
      usual_pace_(conditions.controller.pace),
      walls_(maze, conditions.map, record),
      seed_(seed),
      rng_(seed_for(seed, "hazards")),
      rates_(failure_rates),
      sample_(*model.robot.hardware, conditions.errors, maze.size(), seed),
      variation_(conditions.errors.variation),
      variation_share_(rng_.unit()) {
  record.by_failure_model = true;
  record.severity = sample_.severity();
  set_pace(1.0);
}

/// If the variation lies between two measured ones, one of them is drawn for the contest, the nearer with higher
/// probability. The same holds for the pace of a run.
void FailureDriver::set_pace(double pace) {
  pace_ = usual_pace_ * pace;
  const auto paces = between(rates_.paces, pace_, [](const RatesAtPace& at) { return at.pace; });
  const RatesAtPace& at_pace = rates_.paces[rng_.unit() < paces.part ? paces.above : paces.below];
  const auto scales = between(at_pace.variations, variation_, [](const RatesAtVariation& at) { return at.variation; });
  at_variation_ = &at_pace.variations[variation_share_ < scales.part ? scales.above : scales.below];
}

const FailureRatesByBrightness& FailureDriver::rates() const {
  return at_variation_->by_brightness[brightness_class(sample_.brightness())];
}

std::size_t FailureDriver::random_class(std::span<const double> shares) { return class_at(rng_.unit(), shares); }

std::size_t FailureDriver::class_at(double left, std::span<const double> shares) {
  std::size_t place = 0;
  while (place + 1 < shares.size() && left >= shares[place]) left -= shares[place++];
  // Rounding can leave a remainder: it goes to the last class with a positive share.
  while (place > 0 && shares[place] <= 0.0) --place;
  return place;
}

void FailureDriver::put_at_start() {
  TimedDriver::put_at_start();
  position_error_ = random_class(rates().put);
  crash_.reset();
  walls_.put_down();
}

void FailureDriver::carry_to_start() {
  clock_ += handling_;
  put_at_start();
}

void FailureDriver::look_about() {
  const Heading heading = place_.pose.heading;
  const double clear = rng_.unit();
  WallEvidence seen;
  seen.left = read_wall(left_of(heading), false, clear);
  seen.ahead = read_wall(heading, true, clear);
  seen.right = read_wall(right_of(heading), false, clear);
  walls_.read(clock_, place_.pose, seen);
}

/// Readings without evidence depend on the mouse's position, so all walls around it share one random draw `clear`. A
/// wall gives no evidence if `clear` is below its share of such readings.
Evidence FailureDriver::read_wall(Heading side, bool ahead, double clear) {
  const Wall wall = wall_at(place_.pose.cell, side);
  // The border is known.
  if (on_border(wall, maze_.size())) return 0;
  const bool again = read_.contains(wall);
  read_.insert(wall);
  const bool open = maze_.is_open(place_.pose.cell, side);
  const Reading reading = reading_of(open, ahead, again);
  const std::size_t bright = brightness_class(sample_, place_.pose, side, !open);
  ReadingRates shares =
      at_variation_->by_brightness[bright].readings[static_cast<std::size_t>(reading)][position_error_];
  double& silent = shares[evidence_class(0)];
  if (clear < silent) return 0;
  for (double& told : shares) told /= 1.0 - silent;
  silent = 0.0;
  // What is wrong with a wall stays: each look at it from this side has the same random number.
  const auto number_of_side =
      static_cast<std::uint64_t>(4 * maze_.size().index(place_.pose.cell) + static_cast<int>(side));
  return evidence_in(class_at(Rng(seed_for(seed_, "reading", number_of_side)).unit(), shares));
}

FailureDriver::ManoeuvreOutcome FailureDriver::drive(Manoeuvre manoeuvre, bool way_is_open) {
  const ManoeuvreRates& failure = rates().manoeuvres[static_cast<std::size_t>(manoeuvre)][position_error_];
  if (!way_is_open) return {RunEnd::wall_error, 0.5};
  if (rng_.unit() < failure.crash)
    return {rng_.unit() < failure.slid ? RunEnd::slid : RunEnd::position_lost, rng_.unit()};
  position_error_ = random_class(failure.after);
  return {};
}

bool FailureDriver::crash_at(MazeTime time, RunEnd cause) {
  if (reach(time)) crash_ = cause;
  return false;
}

bool FailureDriver::reach(MazeTime time) {
  clock_ = std::min(time, time_limit_);
  return clock_ < time_limit_;
}

bool FailureDriver::is_open(const Action& part) const {
  const Heading heading = after_search(place_, part).pose.heading;
  for (int cell = 0; cell < part.movement; ++cell)
    if (!maze_.is_open(neighbour(place_.pose.cell, heading, cell), heading)) return false;
  return true;
}

bool FailureDriver::make(const Action& part, bool replanned) {
  const Cell from = place_.pose.cell;
  const MazeTime begin = clock_, time = time_of(part);
  const ManoeuvreOutcome outcome = drive(manoeuvre_of(maze_, place_, part), is_open(part));
  if (outcome.crash) return crash_at(begin + part_of(time, outcome.part), *outcome.crash);
  if (!reach(begin + time)) return false;
  advance(part, begin, replanned);
  if (walls_.weighs()) walls_.pass(clock_, from, place_.pose);
  look_about();
  return true;
}

bool FailureDriver::run(const DriveRoute& route) {
  DriveRun& run = record_.runs.back();
  const MazeTime begin = run.begin = clock_;
  set_gates(run, maze_, model_);
  const auto happen = [&](std::optional<MazeTime>& gate) {
    if (gate) gate = begin + slowed(*gate - begin);
    if (gate > clock_) gate.reset();
  };
  bool stands = true;
  for (const DriveSegment& segment : route.segments) {
    DriveRoute piece;
    piece.segments.push_back(segment);
    const WallSet needed = walls_of(piece);
    bool open = true;
    needed.for_each([&](Wall wall) { open = open && maze_.is_open(wall.cell, wall.side); });
    const ManoeuvreOutcome outcome = drive(manoeuvre_of(segment), open);
    const MazeTime length = segment.end - segment.begin;
    stands = outcome.crash ? crash_at(begin + slowed(segment.begin + part_of(length, outcome.part)), *outcome.crash)
                           : reach(begin + slowed(segment.end));
    if (!stands) break;
  }
  for (auto* gate : {&run.gate_out, &run.gate_in, &run.centre}) happen(*gate);
  for (MazeTime& gate : run.laps) gate = begin + slowed(gate - begin);
  std::erase_if(run.laps, [&](MazeTime gate) { return gate > clock_; });
  run.end = clock_;
  stand_behind(route);
  return stands;
}

}  // namespace labmouse
