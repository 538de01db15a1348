#include "labmouse/contest/drive_contest.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "labmouse/contest/dead_ends.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/lap_contest.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/search_parts.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/drive/search_field.hpp"

namespace labmouse {
namespace {

double pace_of(DrivingStrategy& mouse, DriveRun::Kind kind) {
  return std::clamp(mouse.pace(kind == DriveRun::Kind::speed), least_pace, 1.0);
}

class DriveContest {
 public:
  DriveContest(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse,
               ContestDriver& driver, PhysicalRecord& record)
      : maze_(maze),
        rules_(rules),
        model_(model),
        mouse_(mouse),
        record_(record),
        start_{maze.start(), maze.start_heading()},
        driver_(driver),
        errs_(driver.errs()),
        weighed_(driver.weighed()),
        routes_(maze.size(), route_tables_of(model)),
        home_(maze.size(), model.search),
        goal_entered_(!errs_ && maze.is_goal(maze.start())) {}

  void run() {
    driver_.put_at_start();
    make_runs();
    DriveRecord& drive = record_.drive;
    // A mouse may enter the goal of a search a moment after that has ended.
    if (rules_.counts == Counted::dead_end)
      for (DriveRun& run : drive.runs) run.dead_ends = dead_ends_of(run, maze_);
    const bool scored = score(drive, rules_).best.has_value();
    // In worlds with errors, a mouse that gives up keeps its score.
    if (drive.outcome == DriveOutcome::forfeit && !(errs_ && scored)) return;
    drive.outcome = scored ? DriveOutcome::finished : DriveOutcome::out_of_time;
  }

 private:
  /// State of the contest after a run or a part of one.
  enum class After { on_the_way, at_start, searching_again, at_goal, crashed, over };

  /// Makes runs until the mouse, the rules or the time end the contest.
  void make_runs() {
    Action action = decide_at_start();
    for (;;) {
      if (is_no_route(action)) {
        if (driver_.out_of_time()) return;
        action = begin_anew();
        continue;
      }
      After after = start_run(action);
      action = Action::reset();
      if (after == After::at_goal) {
        // The strategy decides at the goal what it will do at the start.
        action = decide({start_, true});
        if (action.kind == Action::Kind::forfeit && !is_no_route(action)) return give_up(action.reason);
        after = go_back(action);
      }
      if (after == After::over) return;
      if (after == After::searching_again) {
        mouse_.carried(driver_.clock());
        action = decide(driver_.place());
      }
      if (after == After::crashed) action = carry_to_start();
    }
  }

  /// Makes the run that was decided on at the start. Without errors the first run is always a search.
  After start_run(const Action& action) {
    if (action.kind == Action::Kind::step || (!errs_ && record_.drive.runs.empty()))
      return begin(DriveRun::Kind::search) ? search(action) : After::over;
    if (action.kind == Action::Kind::reset) return begin(DriveRun::Kind::speed) ? run_fast() : After::over;
    give_up(action.reason);
    return After::over;
  }

  /// Returns from the goal to the start. A mouse without errors is carried between two speed runs.
  After go_back(const Action& next) {
    if (errs_ || next.kind == Action::Kind::step) return drive_home();
    driver_.carry_to_start();
    return After::at_start;
  }

  Action carry_to_start() {
    ++record_.carried;
    if (weighed_ != nullptr) weighed_->weaken_last();
    driver_.carry_to_start();
    mouse_.carried(driver_.clock());
    return decide_at_start();
  }

  /// Clears a map that has no route left, even after weaken(), and begins again at the start.
  Action begin_anew() {
    weighed_->forget_all();
    weakens_ = 0;
    return carry_to_start();
  }

  /// Reads the walls at the start, and decides.
  Action decide_at_start() {
    driver_.look_about();
    return decide({start_, true});
  }

  /// Opens the record of a run; false if time or rules allow none.
  bool begin(DriveRun::Kind kind) {
    if (driver_.out_of_time() || (kind != DriveRun::Kind::home && starts_of(record_.drive) >= rules_.most_runs))
      return false;
    const Knowledge& known = driver_.known();
    DriveRun run;
    run.kind = kind;
    run.begin = run.end = driver_.clock();
    run.touched = record_.carried > 0;
    if (errs_) run.pace = pace_of(mouse_, kind);
    run.open = known.open();
    run.closed = WallSet::all(maze_.size());
    run.closed -= known.possible();
    // Millions of contests are run in the failure model, so unused values are left out.
    if (!record_.by_failure_model) {
      if (possible_over_ != known.possible()) possible_ = plan(known.possible());
      possible_over_ = known.possible();
      run.possible = possible_;
    }
    if (!record_.by_failure_model || kind == DriveRun::Kind::speed) run.known = plan(known.open());
    record_.drive.runs.push_back(std::move(run));
    record_.ends.push_back(RunEnd::done);
    driver_.set_pace(record_.drive.runs.back().pace);
    weakens_ = 0;
    return true;
  }

  /// Plans the fastest route through these passages, and returns its time.
  DriveTime plan(const WallSet& passages) {
    if (planned_over_ != passages) routes_.fill_for(start_, passages, maze_.goals());
    planned_over_ = passages;
    return routes_.time_from(start_);
  }

  After end_run(RunEnd end, After after) {
    record_.ends.back() = end;
    record_.drive.runs.back().end = driver_.clock();
    return after;
  }
  /// Ends a run that was aborted.
  After broken_off() {
    const std::optional<RunEnd> crash = driver_.crash();
    return crash ? end_run(*crash, After::crashed) : end_run(RunEnd::out_of_time, After::over);
  }

  Action decide(const SearchPlace& place) {
    Action action = ask(place);
    // A map without a route has a wrong wall.
    while (is_no_route(action) && weakens_++ < most_weakenings && weaken(place.pose.cell)) action = ask(place);
    return action;
  }

  /// Whether the strategy found no route, on a map whose walls can change.
  bool is_no_route(const Action& action) const {
    return weighed_ != nullptr && action.kind == Action::Kind::forfeit && action.reason == ForfeitReason::no_route;
  }

  bool weaken(Cell cell) {
    return (goal_entered_ && weighed_->weaken_path(cell, CellSet::of(start_.cell))) ||
           weighed_->weaken_path(cell, maze_.goals());
  }

  Action ask(const SearchPlace& place) {
    const std::int64_t plans = mouse_.plans();
    const Action action = weighed_ != nullptr ? mouse_.consider(weighed_->log_odds(), place, driver_.clock())
                                              : mouse_.decide(driver_.seen(place.pose));
    replanned_ = mouse_.plans() > plans;
    record_.actions.push_back(action);
    ++record_.drive.decisions;
    record_.drive.replanned += replanned_ ? 1 : 0;
    return action;
  }

  /// Passes a reading to the strategy without asking for a decision.
  void show(const Pose& pose) {
    if (weighed_ == nullptr) mouse_.show(pose, driver_.seen(pose));
  }

  void give_up(ForfeitReason reason) {
    if (reason == ForfeitReason::finished && starts_of(record_.drive) > 1) return;
    record_.drive.outcome = DriveOutcome::forfeit;
    record_.drive.reason = reason;
  }

  /// Searches from that action on until the strategy resets, then drives home.
  After search(Action action) {
    while (action.kind == Action::Kind::step) {
      if (const After after = move(action); after != After::on_the_way) return after;
      if (driver_.out_of_time()) return end_run(RunEnd::out_of_time, After::over);
      action = decide(driver_.place());
    }
    if (is_no_route(action)) return end_run(RunEnd::no_route_left, After::crashed);
    if (action.kind == Action::Kind::forfeit) {
      give_up(action.reason);
      return end_run(action.reason == ForfeitReason::no_route ? RunEnd::no_route_left : RunEnd::given_up, After::over);
    }
    if (!goal_entered_) return give_up_on_it();
    end_run(RunEnd::done, After::on_the_way);
    return drive_home();
  }

  /// Makes one action, in parts with a reading after each.
  After move(const Action& action) {
    if (!is_search_step(driver_.place(), action)) return give_up_on_it();
    Action left = action;
    do {
      const Pose from = driver_.place().pose;
      const bool first = left.movement == action.movement;
      if (!first) show(from);
      const Action part = first_part(model_.search, driver_.place(), left, driver_.known());
      if (const auto wall = wall_not_open(driver_.place(), part, driver_.known()))
        return weighed_ != nullptr ? look_at(*wall, !first) : give_up_on_it();
      if (const After after = make(part, replanned_ && first); after != After::on_the_way) return after;
      if (!errs_) pass(from, part.movement);
      left = Action::step(0, left.movement - part.movement);
    } while (left.movement > 0);
    return After::on_the_way;
  }

  /// Passes on the readings in the middle of a dash.
  void pass(const Pose& from, int edges) {
    for (int edge = 1; edge < edges; ++edge) {
      const Pose pose = {neighbour(from.cell, from.heading, edge), from.heading};
      goal_entered_ = goal_entered_ || maze_.is_goal(pose.cell);
      show(pose);
    }
  }

  /// Reads again at a wall on the way that is not known to be open.
  After look_at(Wall wall, bool moved) {
    if (moved) return After::on_the_way;
    // The believed position may be wrong.
    if (driver_.known().state(wall) != WallState::unknown) return give_up_on_it();
    driver_.look_about();
    // The wall may be behind the mouse, out of sight.
    return driver_.known().state(wall) == WallState::unknown ? give_up_on_it() : After::on_the_way;
  }

  /// Ends the contest: the mouse asked for an impossible action.
  After give_up_on_it() {
    give_up(ForfeitReason::lost);
    return end_run(RunEnd::given_up, After::over);
  }

  After make(const Action& part, bool replanned) {
    const Pose from = driver_.place().pose;
    const Heading heading = after_search(driver_.place(), part).pose.heading;
    if (!driver_.make(part, replanned)) {
      if (weighed_ != nullptr && driver_.crash() && part.movement > 0)
        weighed_->close_after_crash(driver_.clock(), wall_at(from.cell, heading));
      return broken_off();
    }
    // It asks to be carried.
    if (weighed_ != nullptr && weighed_->doubts_its_place()) return end_run(RunEnd::no_route_left, After::crashed);
    goal_entered_ = goal_entered_ || maze_.is_goal(driver_.place().pose.cell);
    return After::on_the_way;
  }

  /// Drives by the fastest known moves to rest at the start, in the start heading.
  After drive_home() {
    const SearchPlace home = {start_, true};
    if (driver_.place() == home) return After::at_start;
    if (!begin(DriveRun::Kind::home)) return After::over;
    while (!(driver_.place() == home)) {
      const SearchPlace& place = driver_.place();
      Action step = search_step(place.pose.heading, start_.heading, 0);
      if (place.pose.cell != start_.cell) {
        const Knowledge& known = driver_.known();
        home_.fill(known.open(), known.known_cells(), CellSet::of(start_.cell));
        step = home_.step(place);
        if (step.kind != Action::Kind::step)
          return end_run(RunEnd::no_route_left, weighed_ != nullptr ? After::crashed : After::over);
      }
      if (const After after = make(step, false); after != After::on_the_way) return after;
      show(driver_.place().pose);
      if (driver_.out_of_time()) return end_run(RunEnd::out_of_time, After::over);
    }
    return end_run(RunEnd::done, After::at_start);
  }

  After run_fast() {
    routes_.route_from(start_, route_);
    if (route_.time == no_time || (errs_ && route_.segments.empty())) return find_no_route();
    DriveRun& run = record_.drive.runs.back();
    run.route = route_;
    const bool stands = driver_.run(route_);
    // A crash after the goal does not affect this run.
    if (!run.gate_in) return stands ? end_run(RunEnd::position_lost, After::crashed) : broken_off();
    if (!errs_) show(driver_.place().pose);
    return end_run(RunEnd::done, stands ? After::at_goal : driver_.crash() ? After::crashed : After::over);
  }

  /// Handles a speed run without a known route.
  After find_no_route() {
    if (!errs_) {
      record_.drive.runs.pop_back();
      record_.ends.pop_back();
      return After::over;
    }
    if (weighed_ == nullptr) {
      give_up(ForfeitReason::no_route);
      return end_run(RunEnd::no_route_left, After::over);
    }
    const bool weakens = weakens_++ < most_weakenings && weighed_->weaken_path(start_.cell, maze_.goals());
    return end_run(RunEnd::no_route_left, weakens ? After::searching_again : After::crashed);
  }

  const Maze& maze_;
  const DriveRules& rules_;
  const DriveModel& model_;
  DrivingStrategy& mouse_;
  PhysicalRecord& record_;
  Pose start_;
  ContestDriver& driver_;
  bool errs_;
  BelievedWalls* weighed_;  ///< null: a map without a route ends the contest
  FastestRoutes routes_;
  SearchField home_;
  std::optional<WallSet> planned_over_, possible_over_;  ///< the passages of `routes_`, and of `possible_`
  DriveTime possible_ = no_time;
  DriveRoute route_;
  bool replanned_ = false;
  static constexpr int most_weakenings = 8;
  int weakens_ = 0;    ///< in this run
  bool goal_entered_;  ///< whether a goal was entered, by the believed position
};

}  // namespace

void run_contest(const Maze& maze, const DriveRules& rules, const DriveModel& model, DrivingStrategy& mouse,
                 ContestDriver& driver, PhysicalRecord& record) {
  if (rules.counts == Counted::lap) return run_laps(maze, rules, model, mouse, driver, record);
  DriveContest(maze, rules, model, mouse, driver, record).run();
}

}  // namespace labmouse
