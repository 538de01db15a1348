#include <algorithm>
#include <cmath>

#include "labmouse/lab/hazards/hazards.hpp"

namespace labmouse {
namespace {

/// A mouse whose heading has changed by more in the last ticks of a run was in a turn.
constexpr MazeTime last_moments = 40'000;
constexpr double turning = 0.1;

class HazardCounter {
 public:
  HazardCounter(const PhysicalRecord& record, const Maze& maze, double cell, HazardTally& tally)
      : record_(record), maze_(maze), cell_(cell), tally_(tally) {}

  void count() {
    ++tally_.contests;
    tally_.finished += record_.drive.outcome == DriveOutcome::finished ? 1 : 0;
    for (const Look& look : record_.looks) count_look(look);
    for (std::size_t i = 0; i < record_.drive.runs.size(); ++i) {
      const DriveRun& run = record_.drive.runs[i];
      const bool crashed = is_crash(record_.ends[i]);
      if (run.kind == DriveRun::Kind::fast)
        count_fast(run, crashed);
      else
        count_moves(run, crashed);
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
    if (point == nullptr || !point->belief) return 0;
    const Position way = point->truth.position - point->belief->position;
    return astray_level(std::sqrt(way.x * way.x + way.y * way.y) / cell_);
  }

  void add(Manoeuvre manoeuvre, MazeTime begin, MazeTime end) {
    ManoeuvreCount& count = count_of(manoeuvre, begin);
    ++count.times;
    ++count.after[level_at(end)];
  }
  void add_crash(Manoeuvre manoeuvre, MazeTime begin) {
    ManoeuvreCount& count = count_of(manoeuvre, begin);
    ++count.times;
    ++count.crashes;
  }
  ManoeuvreCount& count_of(Manoeuvre manoeuvre, MazeTime begin) {
    return tally_.manoeuvres[static_cast<std::size_t>(manoeuvre)][level_at(begin)];
  }

  Manoeuvre straight_through(const Pose& pose) const {
    const int walls = (maze_.is_open(pose.cell, left_of(pose.heading)) ? 0 : 1) +
                      (maze_.is_open(pose.cell, right_of(pose.heading)) ? 0 : 1);
    return walls == 0 ? Manoeuvre::open_cell : walls == 1 ? Manoeuvre::half_cell : Manoeuvre::corridor;
  }

  Manoeuvre manoeuvre_of(const SearchMove& move, bool at_rest) const {
    if (move.action.movement == 0) return Manoeuvre::halt;
    if (at_rest) return Manoeuvre::start;
    if (move.action.movement > 1) return Manoeuvre::dash;
    return move.action.rotation == 0 ? straight_through(move.from) : Manoeuvre::turn;
  }

  void count_moves(const DriveRun& run, bool crashed) {
    bool at_rest = true;
    MazeTime time = run.begin;
    const Pose start = {maze_.start(), maze_.start_heading()};
    Pose pose = run.moves.empty() ? start : run.moves.front().from;
    // A way home goes on from where a search or a fast run ended: at rest only after the latter.
    if (run.kind == DriveRun::Kind::home) at_rest = began_at_rest(run);
    for (const SearchMove& move : run.moves) {
      add(manoeuvre_of(move, at_rest), move.begin, move.end);
      at_rest = move.action.movement == 0;
      time = move.end;
      pose = move.to;
    }
    if (!crashed) return;
    add_crash(at_rest ? Manoeuvre::start : turned_before(run.end) ? Manoeuvre::turn : straight_through(pose), time);
  }

  /// A way home behind a fast run begins at rest; behind a search it goes on.
  bool began_at_rest(const DriveRun& home) const {
    const auto& runs = record_.drive.runs;
    const auto index = static_cast<std::size_t>(&home - runs.data());
    if (index == 0) return true;
    const DriveRun& before = runs[index - 1];
    return before.kind == DriveRun::Kind::fast || before.moves.empty() || before.moves.back().action.movement == 0;
  }

  bool turned_before(MazeTime end) const {
    const TracePoint* last = point_at(end);
    const TracePoint* early = point_at(end - last_moments);
    if (last == nullptr || early == nullptr || !last->belief || !early->belief) return false;
    return std::abs(std::remainder(last->belief->angle - early->belief->angle, 6.283185307179586)) > turning;
  }

  static Manoeuvre manoeuvre_of(const DriveSegment& segment) {
    return segment.kind == DriveSegment::Kind::turn ? Manoeuvre::run_turn
           : segment.diagonal()                     ? Manoeuvre::run_diagonal
                                                    : Manoeuvre::run_straight;
  }

  void count_fast(const DriveRun& run, bool crashed) {
    const auto& segments = run.route.segments;
    const MazeTime driven = run.end - run.begin;
    for (const DriveSegment& segment : segments) {
      if (crashed && (segment.end > driven || &segment == &segments.back()))
        return add_crash(manoeuvre_of(segment), run.begin + segment.begin);
      if (segment.end > driven) return;
      add(manoeuvre_of(segment), run.begin + segment.begin, run.begin + segment.end);
    }
  }

  void count_look(const Look& look) {
    const std::size_t level = level_at(look.time);
    const Pose& pose = look.pose;
    count_reading(pose.cell, left_of(pose.heading), look.evidence.left, false, level);
    count_reading(pose.cell, pose.heading, look.evidence.ahead, true, level);
    count_reading(pose.cell, right_of(pose.heading), look.evidence.right, false, level);
  }

  void count_reading(Cell cell, Heading side, Evidence evidence, bool ahead, std::size_t level) {
    if (on_border(wall_at(cell, side), maze_.size())) return;
    const bool open = maze_.is_open(cell, side);
    const Reading reading =
        ahead ? (open ? Reading::gap_ahead : Reading::wall_ahead) : (open ? Reading::gap_beside : Reading::wall_beside);
    ReadingCount& count = tally_.readings[static_cast<std::size_t>(reading)][level];
    ++count.times;
    count.silent += evidence == 0 ? 1 : 0;
    count.wrong += evidence != 0 && (evidence < 0) != open ? 1 : 0;
  }

  const PhysicalRecord& record_;
  const Maze& maze_;
  double cell_;
  HazardTally& tally_;
};

}  // namespace

ManoeuvreCount& ManoeuvreCount::operator+=(const ManoeuvreCount& other) {
  times += other.times;
  crashes += other.crashes;
  for (std::size_t i = 0; i < after.size(); ++i) after[i] += other.after[i];
  return *this;
}

ReadingCount& ReadingCount::operator+=(const ReadingCount& other) {
  times += other.times;
  wrong += other.wrong;
  silent += other.silent;
  return *this;
}

HazardTally& HazardTally::operator+=(const HazardTally& other) {
  contests += other.contests;
  finished += other.finished;
  for (std::size_t i = 0; i < manoeuvres.size(); ++i)
    for (std::size_t level = 0; level < astray_levels; ++level) manoeuvres[i][level] += other.manoeuvres[i][level];
  for (std::size_t i = 0; i < readings.size(); ++i)
    for (std::size_t level = 0; level < astray_levels; ++level) readings[i][level] += other.readings[i][level];
  return *this;
}

ManoeuvreCount HazardTally::of(Manoeuvre manoeuvre) const {
  ManoeuvreCount sum;
  for (const ManoeuvreCount& count : manoeuvres[static_cast<std::size_t>(manoeuvre)]) sum += count;
  return sum;
}

ManoeuvreCount HazardTally::at(std::size_t level) const {
  ManoeuvreCount sum;
  for (const auto& counts : manoeuvres) sum += counts[level];
  return sum;
}

void count_hazards(const PhysicalRecord& record, const Maze& maze, double cell, HazardTally& tally) {
  HazardCounter(record, maze, cell, tally).count();
}

}  // namespace labmouse
