#include <fmt/format.h>

#include <algorithm>

#include "labmouse/contest/dead_ends.hpp"
#include "labmouse/contest/drive_gates.hpp"
#include "labmouse/contest/ideal_drive.hpp"
#include "labmouse/contest/search_parts.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/records/drive_route_check.hpp"
#include "labmouse/lab/records/physical_replay.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

std::string seconds(MazeTime time) { return fmt::format("{:.6f} s", static_cast<double>(time) / 1e6); }
std::string seconds(const std::optional<MazeTime>& time) { return time ? seconds(*time) : "never"; }
std::string score_text(const std::optional<MazeTime>& value, const DriveRules& rules) {
  return value ? value_text(*value, rules, 6) : "none";
}
std::string dead_end_words(const std::optional<DeadEndCount>& count) {
  return count ? fmt::format("{} of {} dead ends seen in {} steps (fewest: {})", count->seen, count->all, count->steps,
                             count->fewest_steps)
               : "no count of dead ends";
}
std::string route_time(DriveTime time) { return time < no_time ? seconds(time) : "none"; }

std::string pose_words(const Pose& pose) {
  return fmt::format("({},{}) heading {}", pose.cell.x, pose.cell.y, name_of(pose.heading));
}

/// Repeats the moves of a record and compares the results with it.
class Replay {
 public:
  explicit Replay(const DriveRecordFile& file)
      : file_(file),
        start_{{file.maze->start(), file.maze->start_heading()}, true},
        driver_(*file.maze, *file.model, file.rules.time_limit, played_),
        routes_(file.maze->size(), route_tables_of(*file.model)) {
    driver_.put_at_start();
    driver_.look_about();
  }

  std::string disagreement() {
    if (file_.tables_hash != file_.model->tables.hash)
      return fmt::format("the hash of the robot's tables is {}; recomputed, it is {}", hash_text(file_.tables_hash),
                         hash_text(file_.model->tables.hash));
    const auto& runs = file_.record.runs;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (const std::string wrong = play(i); !wrong.empty())
        return fmt::format("run {} ({}): {}", i + 1, name_of(runs[i].kind), wrong);
    }
    if (!file_.ended) return "";
    const std::string wrong = compare_walls();
    return wrong.empty() ? compare_end() : wrong;
  }

 private:
  std::string play(std::size_t index) {
    const DriveRun& run = file_.record.runs[index];
    const bool last = index + 1 == file_.record.runs.size(), whole = file_.ended || !last;
    if (std::string wrong = compare_beginning(run); !wrong.empty()) return wrong;
    if (std::string wrong = compare_knowledge(run); !wrong.empty()) return wrong;
    DriveRun& played = played_.runs.emplace_back();
    played.kind = run.kind;
    played.begin = played.end = run.begin;
    if (std::string wrong = run.kind == DriveRun::Kind::speed ? play_route(run, whole) : play_moves(run);
        !wrong.empty())
      return wrong;
    if (run.kind == DriveRun::Kind::home && whole && driver_.place() != start_ && !driver_.out_of_time())
      return "it does not end at rest at the start";
    // A search run ends in the centre of the goal, unless the mouse forfeits or the time is over.
    const bool cut_short = last && (file_.record.outcome == DriveOutcome::forfeit || driver_.out_of_time());
    if (run.kind == DriveRun::Kind::search && whole && !cut_short && goal_entered())
      note_stop(played, *file_.maze, file_.model->search.half_cell, driver_.place(), driver_.clock());
    if (whole && file_.rules.counts == Counted::dead_end) played.dead_ends = dead_ends_of(played, *file_.maze);
    return whole ? compare_gates(run) : "";
  }

  /// Checks whether the contest allows this kind of run at this time and place.
  std::string compare_beginning(const DriveRun& run) {
    const bool search = run.kind == DriveRun::Kind::search, fast = run.kind == DriveRun::Kind::speed;
    if (played_.runs.empty() && !search) return "the first run of a contest must be a search";
    // The mouse is carried to the start between two speed runs. Only a run home may begin elsewhere.
    if (fast && played_.runs.back().kind == DriveRun::Kind::speed) driver_.carry_to_start();
    if ((search || fast) && driver_.place() != start_) return "it begins at the start, but the mouse is elsewhere";
    if (!search && !goal_entered()) return "it begins before a goal was entered";
    if (run.begin != driver_.clock())
      return fmt::format("recorded as beginning at {}; replayed, it begins at {}", seconds(run.begin),
                         seconds(driver_.clock()));
    if (run.begin >= file_.rules.time_limit)
      return fmt::format("it begins after the time limit of {}", seconds(file_.rules.time_limit));
    starts_ += search || fast ? 1 : 0;
    if (starts_ <= file_.rules.most_runs) return "";
    return fmt::format("the rules allow only {} run{} from the start", file_.rules.most_runs,
                       file_.rules.most_runs == 1 ? "" : "s");
  }

  bool goal_entered() const {
    const auto entered = [](const DriveRun& run) { return run.gate_in.has_value(); };
    return file_.maze->is_goal(start_.pose.cell) || std::any_of(played_.runs.begin(), played_.runs.end(), entered);
  }

  std::string compare_knowledge(const DriveRun& run) {
    const Knowledge& known = driver_.known();
    WallSet closed = WallSet::all(file_.maze->size());
    closed -= known.possible();
    if (run.open != known.open() || run.closed != closed)
      return fmt::format("recorded as beginning with {} open and {} closed walls known; replayed, {} and {}{}",
                         run.open.count(), run.closed.count(), known.open().count(), closed.count(),
                         run.open.count() == known.open().count() && run.closed.count() == closed.count()
                             ? ", but different ones"
                             : "");
    const DriveTime possible = time_over(known.possible()), best = time_over(known.open());
    if (run.possible == possible && run.known == best) return "";
    return fmt::format("recorded with a known route of {} and a possible one of {}; replayed, {} and {}",
                       route_time(run.known), route_time(run.possible), route_time(best), route_time(possible));
  }

  DriveTime time_over(const WallSet& passages) {
    routes_.fill_for(start_.pose, passages, file_.maze->goals());
    return routes_.time_from(start_.pose);
  }

  std::string play_moves(const DriveRun& run) {
    for (std::size_t i = 0; i < run.moves.size(); ++i) {
      const SearchMove& move = run.moves[i];
      if (driver_.out_of_time())
        return fmt::format("move {}: it begins after the time limit of {}", i + 1, seconds(file_.rules.time_limit));
      if (!make(move))
        return fmt::format("move {}: it is not a valid move, or passes a wall that was not seen to be open", i + 1);
      const SearchMove& made = played_.runs.back().moves.back();
      if (made == move) continue;
      return fmt::format("move {}: recorded from {} to {}, {} to {}; replayed from {} to {}, {} to {}", i + 1,
                         pose_words(move.from), pose_words(move.to), seconds(move.begin), seconds(move.end),
                         pose_words(made.from), pose_words(made.to), seconds(made.begin), seconds(made.end));
    }
    return "";
  }

  /// Makes a move, part by part. Returns false at the first part that is not a valid move or passes a wall not known to
  /// be open; the parts before it are made.
  bool make(const SearchMove& move) {
    if (!is_search_step(driver_.place(), move.action)) return false;
    Action left = move.action;
    do {
      const Action part = first_part(file_.model->search, driver_.place(), left, driver_.known());
      if (wall_not_open(driver_.place(), part, driver_.known())) return false;
      driver_.make(part, move.replanned && left.movement == move.action.movement);
      left = Action::step(0, left.movement - part.movement);
    } while (left.movement > 0);
    return true;
  }

  std::string play_route(const DriveRun& run, bool whole) {
    if (!whole) return "";
    const Maze& maze = *file_.maze;
    if (run.route.time != run.known)
      return fmt::format("its route takes {}, but the fastest known one takes {}", route_time(run.route.time),
                         route_time(run.known));
    if (std::string wrong =
            check_route(run.route, start_.pose, maze.size(), driver_.known().open(), maze.goals(), *file_.model);
        !wrong.empty())
      return wrong;
    DriveRun& played = played_.runs.back();
    played.route = run.route;
    driver_.run(run.route);
    return "";
  }

  std::string compare_gates(const DriveRun& run) {
    const DriveRun& played = played_.runs.back();
    if (run.end != played.end)
      return fmt::format("recorded as ending at {}; replayed, it ends at {}", seconds(run.end), seconds(played.end));
    if (run.dead_ends != played.dead_ends)
      return fmt::format("recorded with {}; replayed, {}", dead_end_words(run.dead_ends),
                         dead_end_words(played.dead_ends));
    if (run.gate_out == played.gate_out && run.gate_in == played.gate_in && run.centre == played.centre) return "";
    return fmt::format(
        "recorded as leaving the start at {}, entering a goal at {} and reaching its centre at {}; replayed, at {}, {} "
        "and {}",
        seconds(run.gate_out), seconds(run.gate_in), seconds(run.centre), seconds(played.gate_out),
        seconds(played.gate_in), seconds(played.centre));
  }

  std::string compare_walls() const {
    const std::vector<WallSeen>& was = file_.record.walls;
    const std::vector<WallSeen>& is = played_.walls;
    if (was.size() != is.size())
      return fmt::format("{} walls are recorded; replayed, {} are seen", was.size(), is.size());
    for (std::size_t i = 0; i < was.size(); ++i)
      if (was[i] != is[i])
        return fmt::format("wall {}: recorded {}; replayed {}", i + 1, wall_words(was[i]), wall_words(is[i]));
    return "";
  }

  static std::string wall_words(const WallSeen& seen) {
    return fmt::format("the {} side of ({},{}) {} at {}", name_of(seen.wall.side), seen.wall.cell.x, seen.wall.cell.y,
                       seen.open ? "open" : "closed", seconds(seen.time));
  }

  std::string compare_end() const {
    const DriveScore played = score(played_, file_.rules);
    const auto best = played.best ? std::optional(played.runs[*played.best]) : std::nullopt;
    if (best != file_.recorded_score) {
      const auto recorded = file_.recorded_score ? std::optional(file_.recorded_score->value) : std::nullopt;
      return fmt::format("the recorded score is {}; replayed, it is {}{}", score_text(recorded, file_.rules),
                         score_text(played.value(), file_.rules),
                         recorded == played.value() ? ", with different parts" : "");
    }
    const bool in_time = best.has_value();
    if (file_.record.outcome != DriveOutcome::forfeit && in_time != (file_.record.outcome == DriveOutcome::finished))
      return fmt::format("the record ends '{}'; replayed, {} run reached a goal in time", name_of(file_.record.outcome),
                         in_time ? "a" : "no");
    return "";
  }

  const DriveRecordFile& file_;
  DriveRecord played_;
  SearchPlace start_;
  IdealDriver driver_;
  FastestRoutes routes_;
  int starts_ = 0;
};

}  // namespace

std::string replay(const DriveRecordFile& file) {
  if (file.physical) return replay_physically(file);
  return file.rules.counts == Counted::lap ? replay_laps(file) : Replay(file).disagreement();
}

}  // namespace labmouse
