#include <algorithm>
#include <cmath>

#include "labmouse/lab/failure_rates/failure_rates.hpp"

namespace labmouse {
namespace {

/// A mouse crashed in a turn if its heading changed by more than `turning` radians in the `last_moments` of a run.
constexpr MazeTime last_moments = 40'000;
constexpr double turning = 0.1;

class FailureCounter {
 public:
  FailureCounter(const PhysicalRecord& record, const Maze& maze, double cell, const RobotSample& sample,
                 FailureTally& tally)
      : record_(record),
        maze_(maze),
        cell_(cell),
        sample_(sample),
        tally_(tally),
        counts_(tally.by_brightness[brightness_class(sample.brightness())]) {}

  void count() {
    ++counts_.contests;
    counts_.finished += record_.drive.outcome == DriveOutcome::finished ? 1 : 0;
    for (const Look& look : record_.looks) count_look(look);
    for (std::size_t i = 0; i < record_.drive.runs.size(); ++i) {
      const DriveRun& run = record_.drive.runs[i];
      const RunEnd end = record_.ends[i];
      if (i == 0 || is_crash(record_.ends[i - 1])) ++counts_.put[level_at(run.begin)];
      if (run.has_route())
        count_fast(run, end);
      else
        count_moves(run, end);
    }
  }

 private:
  /// The last point of the trace by then; nothing where there is none.
  const TracePoint* point_at(MazeTime time) const {
    const auto after = std::upper_bound(record_.trace.begin(), record_.trace.end(), time,
                                        [](MazeTime t, const TracePoint& point) { return t < point.time; });
    return after == record_.trace.begin() ? nullptr : &*(after - 1);
  }

  std::size_t level_at(MazeTime time) const {
    const TracePoint* point = point_at(time);
    if (point == nullptr || !point->estimate) return 0;
    const Position way = point->truth.position - point->estimate->position;
    return position_error_level(std::sqrt(way.x * way.x + way.y * way.y) / cell_);
  }

  void add(Manoeuvre manoeuvre, MazeTime begin, MazeTime end) {
    ManoeuvreCount& count = count_of(manoeuvre, begin);
    ++count.times;
    ++count.after[level_at(end)];
  }
  /// Crashes into a wall that was read as open are not counted: they do not depend on the manoeuvre.
  void add_crash(Manoeuvre manoeuvre, MazeTime begin, RunEnd end) {
    if (end == RunEnd::wall_error) return;
    ManoeuvreCount& count = count_of(manoeuvre, begin);
    ++count.times;
    ++count.crashes;
    count.slid += end == RunEnd::slid ? 1 : 0;
  }
  ManoeuvreCount& count_of(Manoeuvre manoeuvre, MazeTime begin) {
    return counts_.manoeuvres[static_cast<std::size_t>(manoeuvre)][level_at(begin)];
  }

  void count_moves(const DriveRun& run, RunEnd end) {
    const Pose start = {maze_.start(), maze_.start_heading()};
    SearchPlace place = {run.moves.empty() ? start : run.moves.front().from, true};
    MazeTime time = run.begin;
    // A way home goes on from where the run before it ended, perhaps in motion.
    if (run.kind == DriveRun::Kind::home) place.at_rest = began_at_rest(run);
    for (const SearchMove& move : run.moves) {
      add(manoeuvre_of(maze_, place, move.action), move.begin, move.end);
      place = {move.to, move.action.movement == 0};
      time = move.end;
    }
    if (!is_crash(end)) return;
    const Manoeuvre moving = turned_before(run.end) ? Manoeuvre::turn : straight_through(maze_, place.pose);
    add_crash(place.at_rest ? Manoeuvre::start : moving, time, end);
  }

  /// A way home begins at rest after a speed run; after a search run, if that had no moves or ended with a rotation
  /// only.
  bool began_at_rest(const DriveRun& home) const {
    const auto& runs = record_.drive.runs;
    const auto index = static_cast<std::size_t>(&home - runs.data());
    if (index == 0) return true;
    const DriveRun& before = runs[index - 1];
    return before.has_route() || before.moves.empty() || before.moves.back().action.movement == 0;
  }

  bool turned_before(MazeTime end) const {
    const TracePoint* last = point_at(end);
    const TracePoint* early = point_at(end - last_moments);
    if (last == nullptr || early == nullptr || !last->estimate || !early->estimate) return false;
    return std::abs(std::remainder(last->estimate->angle - early->estimate->angle, 6.283185307179586)) > turning;
  }

  void count_fast(const DriveRun& run, RunEnd end) {
    // Times of a route are at the usual pace; this converts them to the time of the contest.
    const auto clock = [&](DriveTime time) {
      return run.begin + static_cast<MazeTime>(static_cast<double>(time) / (tally_.pace * run.pace));
    };
    const auto& segments = run.route.segments;
    for (const DriveSegment& segment : segments) {
      const MazeTime begins = clock(segment.begin), ends = clock(segment.end);
      if (is_crash(end) && (ends > run.end || &segment == &segments.back()))
        return add_crash(manoeuvre_of(segment), begins, end);
      if (ends > run.end || (run.gate_in && begins >= *run.gate_in)) return;
      add(manoeuvre_of(segment), begins, ends);
    }
  }

  void count_look(const Look& look) {
    const std::size_t level = level_at(look.time);
    const Pose& pose = look.pose;
    count_reading(pose, left_of(pose.heading), look.evidence.left, level);
    count_reading(pose, pose.heading, look.evidence.ahead, level);
    count_reading(pose, right_of(pose.heading), look.evidence.right, level);
  }

  void count_reading(const Pose& pose, Heading side, Evidence evidence, std::size_t level) {
    const Wall wall = wall_at(pose.cell, side);
    if (on_border(wall, maze_.size())) return;
    const bool open = maze_.is_open(pose.cell, side);
    const Reading reading = reading_of(open, side == pose.heading, read_.contains(wall));
    read_.insert(wall);
    FailureCounts& counts = tally_.by_brightness[brightness_class(sample_, pose, side, !open)];
    ReadingCount& count = counts.readings[static_cast<std::size_t>(reading)][level];
    ++count.by_evidence[evidence_class(evidence)];
  }

  const PhysicalRecord& record_;
  const Maze& maze_;
  double cell_;
  const RobotSample& sample_;
  FailureTally& tally_;
  FailureCounts& counts_;  ///< of contests with this one's brightness
  WallSet read_;           ///< walls that were read before
};

}  // namespace

void count_failures(const PhysicalRecord& record, const Maze& maze, double cell, const RobotSample& sample,
                    FailureTally& tally) {
  FailureCounter(record, maze, cell, sample, tally).count();
}

}  // namespace labmouse
