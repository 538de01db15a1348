#include "labmouse/contest/fallible_contest.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/plans.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/drive/search_field.hpp"

namespace labmouse {
namespace {

double pace_of(Strategy& mouse, DriveRun::Kind kind) {
  return std::clamp(mouse.pace(kind == DriveRun::Kind::fast), least_pace, 1.0);
}

class FallibleContest {
 public:
  FallibleContest(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                  const PhysicalConditions& conditions, Strategy& mouse, ContestDriver& driver, PhysicalRecord& record)
      : maze_(maze),
        rules_(rules),
        model_(model),
        handling_(conditions.handling),
        usual_pace_(conditions.pilot.pace),
        mouse_(mouse),
        record_(record),
        start_{maze.start(), maze.start_heading()},
        driver_(driver),
        walls_(driver.walls()),
        weighs_(walls_.weighs()),
        routes_(maze.size(), route_tables_of(model)),
        home_(maze.size(), model.search) {}

  void hold() {
    driver_.put_at_start();
    hold_runs();
    DriveRecord& drive = record_.drive;
    if (score(drive, rules_).best)
      drive.outcome = DriveOutcome::finished;
    else if (drive.outcome != DriveOutcome::forfeit)
      drive.outcome = DriveOutcome::out_of_time;
  }

 private:
  /// Where a mouse is after a run, or after a part of one.
  enum class After { on_the_way, at_start, searching_again, at_goal, crashed, over };

  /// Runs until the mind, the rules or the time end it.
  void hold_runs() {
    Action action = decide_at_start();
    for (;;) {
      if (weighs_ && is_no_way(action)) {
        if (driver_.out_of_time()) return;
        action = begin_anew();
        continue;
      }
      After after = After::over;
      if (action.kind == Action::Kind::step && begin(DriveRun::Kind::search)) after = search(action);
      if (action.kind == Action::Kind::reset && begin(DriveRun::Kind::fast)) after = run_fast();
      if (action.kind == Action::Kind::forfeit) give_up(action.reason);
      action = Action::reset();
      if (after == After::at_goal) {
        // It says at the goal what it will do at the start, and drives there.
        action = decide({start_, true});
        if (action.kind == Action::Kind::forfeit && !(weighs_ && is_no_way(action))) return give_up(action.reason);
        after = drive_home();
      }
      if (after == After::over) return;
      if (after == After::searching_again) {
        mouse_.carried(driver_.clock());
        action = decide(driver_.place());
      }
      if (after == After::crashed) action = carry_to_start();
    }
  }

  Action carry_to_start() {
    ++record_.carried;
    if (weighs_) walls_.doubt_last();
    driver_.wait(handling_);
    driver_.put_at_start();
    mouse_.carried(driver_.clock());
    return decide_at_start();
  }

  /// At the start with a map that has no way left, whatever is doubted: the mouse begins with an empty one.
  Action begin_anew() {
    walls_.forget_all();
    doubts_ = 0;
    return carry_to_start();
  }

  /// Stands at the start, looks, and decides.
  Action decide_at_start() {
    driver_.look_about();
    return decide({start_, true});
  }

  int starts() const {
    const auto& runs = record_.drive.runs;
    return static_cast<int>(
        std::count_if(runs.begin(), runs.end(), [](const DriveRun& run) { return run.kind != DriveRun::Kind::home; }));
  }

  /// Opens the record of a run; false where time or rules allow none.
  bool begin(DriveRun::Kind kind) {
    if (driver_.out_of_time() || (kind != DriveRun::Kind::home && starts() >= rules_.most_runs)) return false;
    const Knowledge& known = walls_.known();
    DriveRun run;
    run.kind = kind;
    run.begin = run.end = driver_.clock();
    run.touched = record_.carried > 0;
    run.pace = pace_of(mouse_, kind);
    run.open = known.open();
    run.closed = WallSet::all(maze_.size());
    run.closed -= known.possible();
    // Of contests by dice there are millions: what nobody looks at is left out.
    if (!record_.by_dice) {
      routes_.fill_for(start_, known.possible(), maze_.goals());
      run.hoped = routes_.time_from(start_);
      planned_over_.reset();
    }
    if (!record_.by_dice || kind == DriveRun::Kind::fast) run.known = plan(known.open());
    record_.drive.runs.push_back(std::move(run));
    record_.ends.push_back(RunEnd::done);
    driver_.set_pace(usual_pace_ * record_.drive.runs.back().pace);
    doubts_ = 0;
    return true;
  }

  /// The time of the fastest route over these walls, which is planned for.
  DriveTime plan(const WallSet& open) {
    if (planned_over_ != open) routes_.fill_for(start_, open, maze_.goals());
    planned_over_ = open;
    return routes_.time_from(start_);
  }

  After end_run(RunEnd end, After after) {
    record_.ends.back() = end;
    record_.drive.runs.back().end = driver_.clock();
    return after;
  }
  /// A run that did not come to its end.
  After broken_off() {
    return driver_.crashed() ? end_run(driver_.cause(), After::crashed) : end_run(RunEnd::out_of_time, After::over);
  }

  Action decide(const SearchPlace& place) {
    Action action = ask(place);
    // A mouse that sees no way has misread a wall.
    while (weighs_ && is_no_way(action) && doubts_++ < most_doubts && doubt(place.pose.cell)) action = ask(place);
    return action;
  }

  static bool is_no_way(const Action& action) {
    return action.kind == Action::Kind::forfeit && action.reason == ForfeitReason::no_way;
  }

  bool doubt(Cell cell) {
    return (goal_believed_ && walls_.doubt_way(cell, CellSet::of(start_.cell))) ||
           walls_.doubt_way(cell, maze_.goals());
  }

  Action ask(const SearchPlace& place) {
    const std::int64_t plans = plans_of(mouse_);
    const Action action = weighs_ && mouse_.considers() ? mouse_.consider(walls_.belief(), place, driver_.clock())
                                                        : mouse_.decide(walls_.sighting(place.pose));
    replanned_ = plans_of(mouse_) > plans;
    record_.actions.push_back(action);
    ++record_.drive.decisions;
    record_.drive.replanned += replanned_ ? 1 : 0;
    return action;
  }

  void give_up(ForfeitReason reason) {
    if (reason == ForfeitReason::finished && starts() > 1) return;
    record_.drive.outcome = DriveOutcome::forfeit;
    record_.drive.reason = reason;
  }

  /// Searches, beginning with that action, until the mouse resets, and drives home.
  After search(Action action) {
    while (action.kind == Action::Kind::step) {
      if (const After after = move(action); after != After::on_the_way) return after;
      action = decide(driver_.place());
    }
    if (weighs_ && is_no_way(action)) return end_run(RunEnd::walled_in, After::crashed);
    if (action.kind == Action::Kind::forfeit) {
      give_up(action.reason);
      return end_run(action.reason == ForfeitReason::no_way ? RunEnd::walled_in : RunEnd::given_up, After::over);
    }
    if (!goal_believed_) return give_up_on_it();
    end_run(RunEnd::done, After::on_the_way);
    return drive_home();
  }

  /// One action of the mind, edge by edge with a reading at each.
  After move(const Action& action) {
    if (!is_search_step(driver_.place(), action)) return give_up_on_it();
    if (action.movement == 0) return make(action, replanned_);
    Action part = Action::step(action.rotation, 1);
    for (int edge = 0; edge < action.movement; edge += part.movement, part.rotation = 0) {
      const SearchPlace place = driver_.place();
      if (edge > 0 && !weighs_) mouse_.show(place.pose, walls_.sighting(place.pose));
      part.movement = cells_at_once(part.rotation, action.movement - edge);
      const Heading heading = after_search(place, part).pose.heading;
      for (int cell = 0; cell < part.movement; ++cell)
        if (const Wall wall = wall_at(neighbour(place.pose.cell, heading, cell), heading);
            !walls_.known().open().contains(wall))
          return weighs_ ? look_at(wall, edge > 0) : give_up_on_it();
      if (const After after = make(part, replanned_ && edge == 0); after != After::on_the_way) return after;
    }
    return After::on_the_way;
  }

  /// Instead of driving through a wall that does not seem to be open, or not any more.
  After look_at(Wall wall, bool moved) {
    if (moved) return After::on_the_way;
    // It was doubted where the mouse stands.
    if (walls_.known().state(wall) != WallState::unknown) return give_up_on_it();
    driver_.look_about();
    // It cannot see what is behind it.
    return walls_.known().state(wall) == WallState::unknown ? give_up_on_it() : After::on_the_way;
  }

  /// The mind asked for something that it cannot have.
  After give_up_on_it() {
    give_up(ForfeitReason::lost);
    return end_run(RunEnd::given_up, After::over);
  }

  /// Over how many edges the next part of a move leads: one, or those of a dash.
  int cells_at_once(int rotation, int most) const {
    if (rotation != 0 || driver_.place().at_rest) return 1;
    return dash_length(model_.search, driver_.place().pose, most,
                       [&](Cell cell) { return walls_.known().knows(cell); });
  }

  After make(const Action& part, bool replanned) {
    if (!driver_.make(part, replanned)) return broken_off();
    // It asks to be carried.
    if (walls_.doubts_its_place()) return end_run(RunEnd::walled_in, After::crashed);
    goal_believed_ = goal_believed_ || maze_.is_goal(driver_.place().pose.cell);
    return After::on_the_way;
  }

  /// By the fastest known moves to rest at the start, facing as it did there.
  After drive_home() {
    const SearchPlace home = {start_, true};
    if (driver_.place() == home) return After::at_start;
    if (!begin(DriveRun::Kind::home)) return After::over;
    std::optional<std::pair<WallSet, WallSet>> planned_over;
    while (!(driver_.place() == home)) {
      const SearchPlace& place = driver_.place();
      Action step = search_step(place.pose.heading, start_.heading, 0);
      if (place.pose.cell != start_.cell) {
        const Knowledge& known = walls_.known();
        const std::pair walls(known.open(), known.possible());
        if (planned_over != walls) home_.fill(known.open(), known.known_cells(), CellSet::of(start_.cell));
        planned_over = walls;
        step = home_.step(place);
        if (step.kind != Action::Kind::step)
          return weighs_ ? end_run(RunEnd::walled_in, After::crashed) : end_run(RunEnd::walled_in, After::over);
      }
      if (const After after = make(step, false); after != After::on_the_way) return after;
      if (!weighs_) mouse_.show(driver_.place().pose, walls_.sighting(driver_.place().pose));
    }
    return end_run(RunEnd::done, After::at_start);
  }

  After run_fast() {
    routes_.route_from(start_, route_);
    if (route_.time == no_time || route_.segments.empty()) {
      if (weighs_ && doubts_++ < most_doubts && walls_.doubt_way(start_.cell, maze_.goals()))
        return end_run(RunEnd::walled_in, After::searching_again);
      if (!weighs_) give_up(ForfeitReason::no_way);
      return end_run(RunEnd::walled_in, weighs_ ? After::crashed : After::over);
    }
    DriveRun& run = record_.drive.runs.back();
    run.route = route_;
    const bool stands = driver_.run(route_);
    // What happens to it behind the goal is no matter of this run.
    if (!run.gate_in) return stands ? end_run(RunEnd::strayed, After::crashed) : broken_off();
    return end_run(RunEnd::done, stands ? After::at_goal : driver_.crashed() ? After::crashed : After::over);
  }

  const Maze& maze_;
  const DriveRules& rules_;
  const DriveModel& model_;
  MazeTime handling_;
  double usual_pace_;
  Strategy& mouse_;
  PhysicalRecord& record_;
  Pose start_;
  ContestDriver& driver_;
  BelievedWalls& walls_;
  bool weighs_;  ///< whether the map does: then the mind gets another chance where its walls leave none
  FastestRoutes routes_;
  SearchField home_;
  std::optional<WallSet> planned_over_;  ///< the walls for which there are fastest routes
  DriveRoute route_;
  bool replanned_ = false;
  static constexpr int most_doubts = 8;
  int doubts_ = 0;              ///< in this run
  bool goal_believed_ = false;  ///< whether it believes to have been in a goal
};

}  // namespace

void hold_contest(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                  const PhysicalConditions& conditions, Strategy& mouse, ContestDriver& driver,
                  PhysicalRecord& record) {
  FallibleContest(maze, rules, model, conditions, mouse, driver, record).hold();
}

}  // namespace labmouse
