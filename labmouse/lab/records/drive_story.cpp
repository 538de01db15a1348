#include "labmouse/lab/records/drive_story.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

using RunKind = DriveRun::Kind;

std::string text_of(MazeTime time) { return fmt::format("{:.3f} s", in_seconds(time)); }

class Story {
 public:
  explicit Story(const DriveRecordFile& file) : file_(file), record_(file.record) {}

  std::string text() {
    for (std::size_t i = 0; i < record_.runs.size(); ++i) {
      set_out(i);
      come_to_an_end(i);
    }
    look_at_walls();
    // Walls detected at the time when a run begins are listed after the line of that run.
    std::stable_sort(lines_.begin(), lines_.end(), [](const Line& a, const Line& b) { return a.time < b.time; });
    std::string text;
    for (const Line& line : lines_) text += fmt::format("{:>9.3f}  {}\n", in_seconds(line.time), line.text);
    return text;
  }

 private:
  struct Line {
    MazeTime time = 0;
    std::string text;
  };

  void add(MazeTime time, std::string text) { lines_.push_back({time, std::move(text)}); }

  /// How a run ended; RunEnd::done where the record has no physical part.
  RunEnd end_of(std::size_t run) const {
    return file_.physical && run < file_.physical->notes.ends.size() ? file_.physical->notes.ends[run] : RunEnd::done;
  }
  /// The last run of that kind before one.
  std::optional<std::size_t> last(RunKind kind, std::size_t before) const {
    while (before-- > 0)
      if (record_.runs[before].kind == kind) return before;
    return std::nullopt;
  }

  bool did_not_end_well(std::size_t run) const { return is_crash(end_of(run)) || end_of(run) == RunEnd::no_route_left; }

  /// Whether the run is a search along known walls only, after speed runs that all failed.
  bool makes_sure(std::size_t i) const {
    const DriveRun& run = record_.runs[i];
    bool ran = false;
    for (std::size_t before = 0; before < i; ++before) {
      const bool fast = record_.runs[before].kind == RunKind::speed;
      if (fast && !did_not_end_well(before)) return false;
      ran = ran || fast;
    }
    return ran && run.kind == RunKind::search && !run.moves.empty() &&
           std::all_of(run.moves.begin(), run.moves.end(), [&](const auto& move) {
             for (Cell cell = move.to.cell; cell != move.from.cell; cell = neighbour(cell, opposite(move.to.heading)))
               if (!run.open.contains(wall_at(cell, opposite(move.to.heading)))) return false;
             return true;
           });
  }

  /// ", at 0.64 of its usual pace: slower than the last one, which failed"
  std::string pace_words(std::size_t i) const {
    const DriveRun& run = record_.runs[i];
    const auto before = last(run.kind, i);
    const double last_pace = before ? record_.runs[*before].pace : run.pace;
    if (run.pace == 1.0 && last_pace == 1.0) return "";
    std::string words =
        run.pace == 1.0 ? ", at its usual pace" : fmt::format(", at {:.2f} of its usual pace", run.pace);
    if (run.pace < last_pace) words += ": slower than the last one";
    if (run.pace < last_pace && did_not_end_well(*before)) words += ", which failed";
    if (run.pace > last_pace) words += ": faster than the last one";
    return words;
  }

  void set_out(std::size_t i) {
    const DriveRun& run = record_.runs[i];
    const bool stayed = i > 0 && record_.runs[i - 1].kind == RunKind::speed && end_of(i - 1) == RunEnd::no_route_left;
    if (i > 0 && did_not_end_well(i - 1) && run.touched && !stayed) add(run.begin, "was carried to the start");
    const std::string pace = pace_words(i);
    switch (run.kind) {
      case RunKind::search:
        if (makes_sure(i))
          return add(run.begin,
                     "drives to the goal by ways that it knows, as in a search: no speed run has ended well" + pace);
        return add(run.begin, (last(RunKind::search, i) ? "searches again" : "searches") + pace);
      case RunKind::home:
        return add(run.begin, "goes home" + why_home(i) + pace);
      case RunKind::speed:
        return add(run.begin, "runs by the fastest route that it knows" +
                                  (run.known < no_time ? ", of " + text_of(run.known) : "") + pace);
      case RunKind::laps:
        return add(run.begin, "drives laps of the outermost ring" + pace);
    }
  }

  /// Why the mouse went home, by the open and closed walls in its map at that time.
  std::string why_home(std::size_t i) const {
    const DriveRun& run = record_.runs[i];
    if (i > 0 && (record_.runs[i - 1].kind == RunKind::speed || makes_sure(i - 1))) return " from its run";
    WallSet not_closed = WallSet::all(file_.maze->size());
    not_closed -= run.closed;
    // A record of the failure model lacks the times of the known and the possible route, so they are computed here.
    const DriveTime known = run.known < no_time ? run.known : fastest_over(run.open);
    const DriveTime possible = run.possible < no_time ? run.possible : fastest_over(not_closed);
    if (known >= no_time || possible >= no_time) return "";
    return possible < known ? fmt::format(": it knows a route of {}; a possible one of {} is not worth looking for",
                                          text_of(known), text_of(possible))
                            : fmt::format(": no route can be faster than that of {} which it knows", text_of(known));
  }

  DriveTime fastest_over(const WallSet& walls) const {
    const Maze& maze = *file_.maze;
    FastestRoutes routes(maze.size(), route_tables_of(*file_.model));
    const Pose start = {maze.start(), maze.start_heading()};
    routes.fill_for(start, walls, maze.goals());
    return routes.time_from(start);
  }

  void add_laps(const DriveRun& run) {
    MazeTime begin = run.gate_out.value_or(0);
    for (std::size_t i = 0; i < run.laps.size(); ++i) {
      add(run.laps[i], fmt::format("has completed lap {} in {}", i + 1, text_of(run.laps[i] - begin)));
      begin = run.laps[i];
    }
  }

  void come_to_an_end(std::size_t i) {
    const DriveRun& run = record_.runs[i];
    add_laps(run);
    switch (end_of(i)) {
      case RunEnd::done:
        if ((run.kind == RunKind::speed || makes_sure(i)) && run.gate_in && run.gate_out)
          add(*run.gate_in,
              fmt::format("is in the goal, {} after the start's gate", text_of(*run.gate_in - *run.gate_out)));
        return;
      case RunEnd::given_up:
        return add(run.end, "gives up");
      case RunEnd::slid:
        return add(run.end, "crashes: the tyres slipped");
      case RunEnd::position_lost:
        return add(run.end, "crashes: it is not where it believes to be, or not where it should be");
      case RunEnd::wall_error:
        return add(run.end, "crashes into a wall that it took for a gap");
      case RunEnd::no_route_left:
        return add(run.end, file_.physical->conditions.map == MapKind::learned
                                ? "asks to be carried: its map has no way left, or does not fit what it sees"
                                : "has no route left: some wall in its map must be wrong");
      case RunEnd::out_of_time:
        return add(run.end, "has no time left");
    }
  }

  /// Adds the walls that were seen before, with the same or another state.
  void look_at_walls() {
    WallSet open, closed;
    for (const WallSeen& seen : record_.walls) {
      WallSet &now = seen.open ? open : closed, &other = seen.open ? closed : open;
      const std::string wall =
          fmt::format("the wall {} of ({}, {})", name_of(seen.wall.side), seen.wall.cell.x, seen.wall.cell.y);
      if (other.contains(seen.wall))
        add(seen.time, fmt::format("takes {} for {} after all", wall, seen.open ? "open" : "closed"));
      else if (now.contains(seen.wall))
        add(seen.time,
            fmt::format("looked at {} again, because it was not sure: it is {}", wall, seen.open ? "open" : "closed"));
      other.erase(seen.wall);
      now.insert(seen.wall);
    }
  }

  const DriveRecordFile& file_;
  const DriveRecord& record_;
  std::vector<Line> lines_;
};

}  // namespace

std::string story_of(const DriveRecordFile& file) { return Story(file).text(); }

}  // namespace labmouse
