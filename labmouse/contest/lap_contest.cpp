#include "labmouse/contest/lap_contest.hpp"

#include <algorithm>
#include <utility>

#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/lap_route.hpp"
#include "labmouse/contest/physical_conditions.hpp"

namespace labmouse {
namespace {

/// Starts in a contest at most: a mouse that is carried in no time may crash very often.
constexpr int most_starts = 100;

std::size_t laps_of(const DriveRoute& route) {
  constexpr std::size_t corners = 4;
  const auto is_turn = [](const DriveSegment& segment) { return segment.kind == DriveSegment::Kind::turn; };
  return static_cast<std::size_t>(std::count_if(route.segments.begin(), route.segments.end(), is_turn)) / corners;
}

class LapContest {
 public:
  LapContest(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse,
             ContestDriver& driver, PhysicalRecord& record)
      : maze_(maze), model_(model), mouse_(mouse), driver_(driver), record_(record), laps_left_(rules.most_runs) {}

  void run() {
    driver_.put_at_start();
    driver_.know_open(ring_of(maze_.size()));
    driver_.look_about();
    while (begin()) {
      make_laps();
      if (laps_left_ <= 0 || driver_.out_of_time()) return;
      ++record_.carried;
      driver_.carry_to_start();
      mouse_.carried(driver_.clock());
      driver_.look_about();
    }
  }

 private:
  /// Opens the record of a run; false if there is no route or no time.
  bool begin() {
    DriveRun run;
    run.kind = DriveRun::Kind::laps;
    run.route = route_ = lap_route(maze_, model_, laps_left_);
    if (route_.time == no_time || driver_.out_of_time() || starts_of(record_.drive) >= most_starts) return false;
    run.begin = run.end = driver_.clock();
    run.touched = record_.carried > 0;
    if (driver_.errs()) run.pace = std::clamp(mouse_.pace(true), least_pace, 1.0);
    const Knowledge& known = driver_.known();
    run.open = known.open();
    run.closed = WallSet::all(maze_.size());
    run.closed -= known.possible();
    driver_.set_pace(run.pace);
    record_.drive.runs.push_back(std::move(run));
    record_.ends.push_back(RunEnd::done);
    return true;
  }

  void make_laps() {
    const bool stands = driver_.run(route_);
    DriveRun& run = record_.drive.runs.back();
    run.end = driver_.clock();
    laps_left_ -= static_cast<int>(run.laps.size());
    // A crash after the last lap does not affect this run.
    if (run.laps.size() < laps_of(route_))
      record_.ends.back() = stands ? RunEnd::position_lost : driver_.crash().value_or(RunEnd::out_of_time);
  }

  const Maze& maze_;
  const DriveModel& model_;
  DrivingStrategy& mouse_;
  ContestDriver& driver_;
  PhysicalRecord& record_;
  int laps_left_;
  DriveRoute route_;
};

}  // namespace

void run_laps(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse,
              ContestDriver& driver, PhysicalRecord& record) {
  LapContest(maze, rules, model, mouse, driver, record).run();
  record.drive.outcome = score(record.drive, rules).best ? DriveOutcome::finished : DriveOutcome::out_of_time;
}

}  // namespace labmouse
