#include "labmouse/contest/drive.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "labmouse/contest/drive_gates.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/drive_search.hpp"
#include "labmouse/contest/plans.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/drive/search_field.hpp"

namespace labmouse {
namespace {

class DriveContest {
 public:
  DriveContest(const Maze& maze, const DriveRules& rules, const DriveModel& model, Strategy& mouse)
      : maze_(maze),
        rules_(rules),
        model_(model),
        mouse_(mouse),
        driver_(maze, model, record_),
        routes_(maze.size(), route_tables_of(model)),
        home_(maze.size(), model.search) {}

  DriveRecord hold() {
    hold_runs();
    if (record_.outcome != DriveOutcome::forfeit && !score(record_, rules_).best)
      record_.outcome = DriveOutcome::out_of_time;
    return std::move(record_);
  }

 private:
  void hold_runs() {
    if (!begin(DriveRun::Kind::search)) return;
    Action action = decide();
    while (search(action) && drive_home() && run_fast()) {
      const SearchPlace goal = driver_.place();
      do {
        driver_.put(driver_.start(), driver_.clock());
        action = decide();
      } while (action.kind == Action::Kind::reset && run_fast());
      if (action.kind == Action::Kind::forfeit) give_up(action.reason);
      if (action.kind != Action::Kind::step) return;
      // It said at home what it will do there; on the way it may see more.
      driver_.put(goal, driver_.clock());
      if (!drive_home() || !begin(DriveRun::Kind::search)) return;
    }
  }

  bool out_of_time() const { return driver_.clock() >= rules_.time_limit; }

  /// Runs that began at the start.
  int starts() const {
    return static_cast<int>(std::count_if(record_.runs.begin(), record_.runs.end(),
                                          [](const DriveRun& run) { return run.kind != DriveRun::Kind::home; }));
  }

  /// Opens the record of a run, with routes over what is known; false where time or rules allow none.
  bool begin(DriveRun::Kind kind) {
    if (out_of_time() || (kind != DriveRun::Kind::home && starts() >= rules_.most_runs)) return false;
    const Knowledge& known = driver_.known();
    DriveRun run;
    run.kind = kind;
    run.begin = run.end = driver_.clock();
    run.open = known.open();
    run.closed = WallSet::all(maze_.size());
    run.closed -= known.possible();
    routes_.fill_for(driver_.start().pose, known.possible(), maze_.goals());
    run.hoped = routes_.time_from(driver_.start().pose);
    routes_.fill_for(driver_.start().pose, known.open(), maze_.goals());
    run.known = routes_.time_from(driver_.start().pose);
    record_.runs.push_back(std::move(run));
    return true;
  }

  Action decide() {
    const std::int64_t plans = plans_of(mouse_);
    const Action action = mouse_.decide(driver_.seen());
    replanned_ = plans_of(mouse_) > plans;
    ++record_.decisions;
    record_.replanned += replanned_ ? 1 : 0;
    return action;
  }

  bool give_up(ForfeitReason reason) {
    if (reason == ForfeitReason::finished && starts() > 1) return false;
    record_.outcome = DriveOutcome::forfeit;
    record_.reason = reason;
    return false;
  }

  /// Searches, beginning with that action, until the mouse resets; false where the contest is over.
  bool search(Action action) {
    const auto show = [&](const Pose& pose, const Sighting& seen) { mouse_.show(pose, seen); };
    while (action.kind == Action::Kind::step) {
      if (!driver_.move(action, replanned_, show)) return give_up(ForfeitReason::lost);
      if (out_of_time()) return false;
      action = decide();
    }
    if (action.kind == Action::Kind::forfeit) return give_up(action.reason);
    if (!driver_.goal_entered()) return give_up(ForfeitReason::lost);
    driver_.stop_search();
    return true;
  }

  /// Brings the mouse to rest at the start, facing as it did there; false where the time ends before.
  bool drive_home() {
    if (driver_.place() == driver_.start()) return true;
    if (!begin(DriveRun::Kind::home)) return false;
    while (!out_of_time()) {
      home_.fill(driver_.known().open(), driver_.known().known_cells(), CellSet::of(maze_.start()));
      const Pose& pose = driver_.place().pose;
      const bool home = pose.cell == maze_.start();
      const Action step = home ? search_step(pose.heading, maze_.start_heading(), 0) : home_.step(driver_.place());
      if (home && driver_.place() == driver_.start()) return true;
      if (!driver_.move(step, false, [](const Pose&, const Sighting&) {})) return false;
      mouse_.show(driver_.place().pose, driver_.seen());
    }
    return false;
  }

  /// One run over what is known; false where none can be driven.
  bool run_fast() {
    if (!begin(DriveRun::Kind::fast)) return false;
    DriveRun& run = record_.runs.back();
    routes_.route_from(driver_.start().pose, run.route);
    if (run.route.time == no_time) {
      record_.runs.pop_back();
      return false;
    }
    set_gates(run, maze_, model_);
    run.end = run.begin + run.route.time;
    const auto& segments = run.route.segments;
    const Pose goal =
        segments.empty() ? driver_.start().pose : Pose{segments.back().to.cell, segments.back().to.heading};
    driver_.put({goal, true}, run.end);
    mouse_.show(driver_.place().pose, driver_.seen());
    return true;
  }

  const Maze& maze_;
  const DriveRules& rules_;
  const DriveModel& model_;
  Strategy& mouse_;
  DriveRecord record_;
  SearchDriver driver_;
  FastestRoutes routes_;
  SearchField home_;
  bool replanned_ = false;
};

}  // namespace

Briefing brief(const Maze& maze, const DriveRules& rules, const DriveModel& model, std::uint64_t seed) {
  Briefing briefing;
  briefing.size = maze.size();
  briefing.start = {maze.start(), maze.start_heading()};
  briefing.goals = maze.goals();
  briefing.seed = seed;
  briefing.sight = model.robot.sight;
  briefing.drive = {&model, rules.time_limit, 1.0, rules.maze_time_divisor, rules.most_runs, rules.untouched_bonus};
  return briefing;
}

DriveRecord drive(const Maze& maze, const DriveRules& rules, const DriveModel& model, Strategy& mouse) {
  return DriveContest(maze, rules, model, mouse).hold();
}

}  // namespace labmouse
