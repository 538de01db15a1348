#include "labmouse/lab/replays/drive_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "labmouse/contest/drive_score.hpp"
#include "labmouse/lab/pictures/drive_path.hpp"
#include "labmouse/lab/replays/crash.hpp"
#include "labmouse/lab/replays/fields.hpp"
#include "labmouse/lab/replays/play_frames.hpp"
#include "labmouse/lab/text/optional_json.hpp"

namespace labmouse {
namespace {

/// Where a mouse is in a frame, on half cells and eighths of a turn.
struct FramePlace {
  HalfPoint point;
  int heading = 0;

  friend bool operator==(const FramePlace&, const FramePlace&) = default;
};

FramePlace frame_of(const SearchPlace& place) {
  FramePlace found = {{2 * place.pose.cell.x + 1, 2 * place.pose.cell.y + 1}, eighths(place.pose.heading)};
  if (place.at_rest) return found;
  // On the edge by which it enters the cell.
  const Cell ahead = neighbour(Cell{0, 0}, place.pose.heading);
  found.point.x -= ahead.x;
  found.point.y -= ahead.y;
  return found;
}

/// Builds the lists.
class DriveFrames {
 public:
  DriveFrames(const DriveRecordFile& contest, Json& play)
      : contest_(contest),
        play_(play),
        scores_(score(contest.record, contest.rules)),
        place_{{contest.maze->start(), contest.maze->start_heading()}, true},
        shown_(frame_of(place_)) {
    for (const char* list : {"clock", "x", "y", "heading", "run", "scores", "action", "blocked", "left", "ahead",
                             "right", "entered", "known"})
      play_[list] = Json::array();
    add_frame(0);
  }

  void add(const DriveRun& run, std::size_t number) {
    kind_ = static_cast<int>(run.kind);
    runs_.push_back({frame_, std::nullopt});
    if (run.has_route())
      add_fast(run, number);
    else
      add_search(run, number);
    crash(number);
    if (!goal_frame_ && run.gate_in) goal_frame_ = frame_from(*run.gate_in);
    if (!goal_frame_ && !run.laps.empty()) goal_frame_ = frame_from(run.laps.front());
  }

  void finish() {
    play_["goal_frame"] = or_null(goal_frame_);
    play_["reset_frame"] = or_null(reset_frame_);
    add_known();
    if (contest_.physical) add_mistaken();
  }

  const std::vector<DriveRunFrames>& runs() const { return runs_; }

 private:
  SearchPlace start() const { return {{contest_.maze->start(), contest_.maze->start_heading()}, true}; }

  /// A new run begins in the current frame if the mouse is at its start; otherwise a step carries the mouse there.
  void begin_run(const SearchPlace& place, MazeTime time) {
    place_ = place;
    const bool crashed = runs_.size() > 1 && runs_[runs_.size() - 2].crash;
    if (!crashed && frame_of(place) == shown_) {
      play_["run"].back() = kind_;
      return;
    }
    step("carried to the start", frame_of(place), time, {});
    runs_.back().first = frame_;
  }

  void add_search(const DriveRun& run, std::size_t number) {
    begin_run(run.kind == DriveRun::Kind::search ? start() : place_, run.begin);
    for (const SearchMove& move : run.moves) {
      const Cell before = place_.pose.cell;
      place_ = after_search(place_, move.action);
      std::vector<Cell> entered;
      for (int i = 1; i <= move.action.movement; ++i) entered.push_back(neighbour(before, place_.pose.heading, i));
      if (run.gate_in && *run.gate_in <= move.end) count(number);
      step(short_words(move.action), frame_of(place_), move.end, entered);
    }
  }

  void add_fast(const DriveRun& run, std::size_t number) {
    begin_run(start(), run.begin);
    if (!reset_frame_) reset_frame_ = frame_;
    Cell cell = contest_.maze->start();
    const double pace = pace_of(contest_, run);
    for (std::size_t i = 0; i < run.route.segments.size(); ++i) {
      const DriveSegment& segment = run.route.segments[i];
      const DriveProfile profile(*contest_.model, run.route, i);
      const bool last = i + 1 == run.route.segments.size();
      const MazeTime planned = run.begin + at_pace(segment.end, pace);
      // The last step of a mouse that crashes ends at the place and time of the end of the run.
      const bool breaks_off = contest_.physical && planned > run.end;
      const MazeTime end = contest_.physical && (last || breaks_off) ? run.end : planned;
      if (last || (contest_.physical && run.gate_in && *run.gate_in <= end)) count(number);
      const double within = static_cast<double>(run.end - run.begin) * pace - static_cast<double>(segment.begin);
      const double driven = breaks_off ? profile.distance_at(std::max(0.0, within)) : profile.length();
      step(segment_words(segment, contest_.model->tables),
           breaks_off ? frame_at(profile.spot(driven)) : FramePlace{half_point(segment.to), eighths(segment.to)}, end,
           cells_of(profile, driven, cell));
      if (breaks_off) break;
    }
    if (!run.route.segments.empty()) {
      const DriveNode& last = run.route.segments.back().to;
      place_ = {{last.cell, last.heading}, true};
    }
  }

  /// Ends the last step of a crashed run at the cell of the crash. In a search run, this adds a step: records do not
  /// have the move that the crash interrupted.
  void crash(std::size_t number) {
    const DriveRun& run = contest_.record.runs[number];
    const auto crash = runs_.back().crash = crash_of(contest_, number, place_);
    if (!crash) return;
    const Cell cell = cell_of(*crash);
    const FramePlace place = {{2 * cell.x + 1, 2 * cell.y + 1}, static_cast<int>(std::lround(crash->heading) & 7)};
    if (!run.has_route() || frame_ == runs_.back().first) {
      step("drives on", place, run.end, {});
    } else {
      shown_ = place;
      play_["x"].back() = place.point.x;
      play_["y"].back() = place.point.y;
      play_["heading"].back() = place.heading;
    }
    play_["blocked"].back() = true;
    Json& entered = play_["entered"].back();
    const int index = contest_.maze->size().index(cell);
    if (entered.empty() || entered.back() != index) entered.push_back(index);
  }

  /// The place on the grid of FramePlace that is nearest to the spot.
  FramePlace frame_at(const DriveSpot& spot) const {
    const auto halves = [&](double way) {
      return static_cast<int>(std::lround(2.0 * way / contest_.model->tables.cell));
    };
    return {{halves(spot.x), halves(spot.y)}, static_cast<int>(std::lround(spot.angle * 4.0 / std::numbers::pi) & 7)};
  }

  /// The cells that the first part of a segment comes into.
  std::vector<Cell> cells_of(const DriveProfile& profile, double driven, Cell& cell) const {
    constexpr int looks_a_cell = 32;
    const double side = contest_.model->tables.cell;
    const int looks = 1 + static_cast<int>(driven / side * looks_a_cell);
    std::vector<Cell> cells;
    for (int i = 0; i <= looks; ++i) {
      const DriveSpot spot = profile.spot(driven * i / looks);
      const Cell at = {static_cast<int>(std::floor(spot.x / side)), static_cast<int>(std::floor(spot.y / side))};
      if (at == cell || !contest_.maze->size().contains(at)) continue;
      cells.push_back(cell = at);
    }
    return cells;
  }

  /// Lets a run count for the score from the next frame on, if the rules count it.
  void count(std::size_t run) {
    for (const DriveRunScore& score : scores_.runs)
      if (score.run == run) best_ = std::min(best_.value_or(score.value), score.value);
  }

  void step(std::string words, const FramePlace& place, MazeTime time, const std::vector<Cell>& entered) {
    Json cells = Json::array();
    for (const Cell cell : entered) cells.push_back(contest_.maze->size().index(cell));
    play_["action"].push_back(std::move(words));
    play_["blocked"].push_back(false);
    play_["entered"].push_back(std::move(cells));
    shown_ = place;
    ++frame_;
    add_frame(time);
  }

  void add_frame(MazeTime time) {
    times_.push_back(time);
    play_["clock"].push_back(static_cast<double>(time) / 1e6);
    play_["x"].push_back(shown_.point.x);
    play_["y"].push_back(shown_.point.y);
    play_["heading"].push_back(shown_.heading);
    play_["run"].push_back(kind_);
    play_["scores"].push_back(best_ ? Json(static_cast<double>(*best_) / 1e6) : Json(nullptr));
  }

  /// The first frame at that time or later; the last one where there is none.
  std::size_t frame_from(MazeTime time) const {
    const auto found = std::lower_bound(times_.begin(), times_.end(), time);
    return std::min(static_cast<std::size_t>(found - times_.begin()), frame_);
  }

  void add_known() {
    const Size size = contest_.maze->size();
    const auto area = static_cast<std::size_t>(size.area());
    std::vector<int> known(2 * area, 0);
    WallSet::all(size).for_each([&](Wall wall) { known[index_of(wall)] = on_border(wall, size) ? 0 : -1; });
    for (const WallSeen& seen : contest_.record.walls)
      if (int& frame = known[index_of(seen.wall)]; frame < 0) frame = static_cast<int>(frame_from(seen.time));
    play_["known"] = known;
  }

  /// Walls classified wrongly, each with the frames in which this began and ended.
  void add_mistaken() {
    Json mistaken = Json::array();
    std::map<std::size_t, std::size_t> last;  // entry of a wall
    for (const WallSeen& seen : contest_.record.walls) {
      const std::size_t wall = index_of(seen.wall), frame = frame_from(seen.time);
      if (const auto before = last.find(wall); before != last.end()) {
        mistaken[before->second]["to"] = frame;
        last.erase(before);
      }
      if (seen.open == contest_.maze->is_open(seen.wall.cell, seen.wall.side)) continue;
      last[wall] = mistaken.size();
      mistaken.push_back({{"wall", wall}, {"closed", !seen.open}, {"from", frame}, {"to", nullptr}});
    }
    play_["mistaken"] = std::move(mistaken);
  }

  std::size_t index_of(Wall wall) const {
    const Size size = contest_.maze->size();
    return static_cast<std::size_t>(size.index(wall.cell) + (wall.side == Heading::east ? size.area() : 0));
  }

  const DriveRecordFile& contest_;
  Json& play_;
  DriveScore scores_;
  SearchPlace place_;
  FramePlace shown_;
  std::vector<MazeTime> times_;
  std::vector<DriveRunFrames> runs_;
  std::optional<std::size_t> goal_frame_, reset_frame_;
  std::optional<MazeTime> best_;
  std::size_t frame_ = 0;
  int kind_ = 0;
};

}  // namespace

std::string segment_words(const DriveSegment& segment, const DriveTables& tables) {
  if (segment.kind == DriveSegment::Kind::turn)
    return fmt::format("{} {}", segment.left ? "left" : "right", name_of(tables.turns[segment.turn].turn));
  if (segment.diagonal()) return fmt::format("diagonal {}", segment.units);
  return fmt::format("ahead {}", segment.units / 2.0);
}

std::vector<DriveRunFrames> add_drive_frames(const DriveRecordFile& contest, Json& play) {
  DriveFrames frames(contest, play);
  for (std::size_t i = 0; i < contest.record.runs.size(); ++i) frames.add(contest.record.runs[i], i);
  frames.finish();
  return frames.runs();
}

}  // namespace labmouse
