// A record of mms as a play. Commands that take time are steps; drawings are shown from the frame in which they were
// made.
#include <fmt/format.h>

#include <functional>

#include "labmouse/lab/bounds/mms_bound.hpp"
#include "labmouse/lab/pictures/mms_picture.hpp"
#include "labmouse/lab/records/mms_statistics_json.hpp"
#include "labmouse/lab/replays/fields.hpp"
#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/lab/replays/play.hpp"
#include "labmouse/lab/text/optional_json.hpp"

namespace labmouse {
namespace {

/// The cell in which half a step between two places lies.
Cell cell_between(HalfPlace from, HalfPlace to) { return {(from.x + to.x) / 4, (from.y + to.y) / 4}; }

/// Follows a mouse through the cells that it comes into.
class CellWay {
 public:
  /// The cells on the straight way to the place, but for the one where the mouse is.
  std::vector<Cell> to(const HalfPose& pose) {
    std::vector<Cell> cells;
    for (HalfPlace next; place_ != pose.place; place_ = next) {
      next = half_step(place_, pose.heading);
      const Cell cell = cell_between(place_, next);
      if (cell != cell_) cells.push_back(cell);
      cell_ = cell;
    }
    return cells;
  }
  /// The mouse is put back.
  void back() { *this = {}; }

 private:
  HalfPlace place_;
  Cell cell_;
};

/// Builds the lists of a play while the record is played.
class MmsFrames {
 public:
  MmsFrames(Size size, Json& play) : size_(size), play_(play) {
    for (const char* list : {"clock", "x", "y", "heading", "run", "action", "blocked", "left", "ahead", "right",
                             "known", "entered", "events", "scores"})
      play_[list] = Json::array();
    play_["goal_frame"] = play_["reset_frame"] = nullptr;
    add_frame({}, 0, MmsStatistics());
  }

  void add(const RecordedMmsEvent& event, const MmsHost& host) {
    // The record has only lines that mms obeyed, so this is a command.
    const MmsCommand command = *read_mms_line(event.line).command;
    const bool takes_time =
        command.verb == MmsVerb::move || command.verb == MmsVerb::turn || command.verb == MmsVerb::ack_reset;
    if (takes_time)
      add_step(event, command, host);
    else
      add_drawing(command, host.canvas());
  }

  int steps() const { return frame_; }

 private:
  void add_frame(const HalfPose& pose, double clock, const MmsStatistics& statistics) {
    play_["clock"].push_back(clock);
    play_["x"].push_back(pose.place.x);
    play_["y"].push_back(pose.place.y);
    play_["heading"].push_back(static_cast<int>(pose.heading));
    play_["run"].push_back(0);
    play_["scores"].push_back(decimal(statistics.score));
  }

  void add_step(const RecordedMmsEvent& event, const MmsCommand& command, const MmsHost& host) {
    ++frame_;
    Json entered = Json::array();
    if (command.verb == MmsVerb::ack_reset)
      way_.back();
    else
      for (const Cell cell : way_.to(host.pose())) entered.push_back(size_.index(cell));
    play_["action"].push_back(event.line);
    play_["blocked"].push_back(event.reply == "crash");
    play_["entered"].push_back(std::move(entered));
    add_frame(host.pose(), host.clock(), host.statistics());
    const auto first = [&](const char* key) {
      if (play_[key].is_null()) play_[key] = frame_;
    };
    if (mms_goals(size_).contains(cell_of(host.pose().place))) first("goal_frame");
    if (command.verb == MmsVerb::ack_reset) first("reset_frame");
  }

  void add_drawing(const MmsCommand& command, const MmsCanvas& canvas) {
    Json event = {{"frame", frame_}};
    const Cell cell(command.x, command.y);
    const auto of_cell = [&](const char* kind, const char* key, std::string value) {
      event["kind"] = kind;
      event["cell"] = cell_json(cell);
      event[key] = std::move(value);
    };
    switch (command.verb) {
      case MmsVerb::clear_all_colour:
        event["kind"] = "clear colours";
        break;
      case MmsVerb::clear_all_text:
        event["kind"] = "clear texts";
        break;
      case MmsVerb::set_wall:
      case MmsVerb::clear_wall:
        of_cell("wall", "side", std::string(name_of(command.side)));
        event["there"] = command.verb == MmsVerb::set_wall;
        break;
      case MmsVerb::set_text:
      case MmsVerb::clear_text:
        of_cell("text", "text", std::string(canvas.text(cell)));
        break;
      default:
        of_cell("colour", "colour", canvas.colour(cell) == 0 ? "" : std::string(1, canvas.colour(cell)));
    }
    play_["events"].push_back(std::move(event));
  }

  Size size_;
  Json& play_;
  CellWay way_;
  int frame_ = 0;
};

std::string outcome_words(const MmsRecordFile& file) {
  if (!file.end) return fmt::format("the record breaks off after event {}", file.events.size());
  return file.end->end.empty() ? file.end->outcome : fmt::format("{}: {}", file.end->outcome, file.end->end);
}

/// Everything that mms counted, and what was wrong with lines.
Json counts_json(const MmsStatistics& statistics, const MmsRecordFile& file) {
  Json counts = Json::array();
  const auto add = [&](std::string_view name, Json value) {
    counts.push_back({{"name", name}, {"value", std::move(value)}});
  };
  for (const MmsStatistic& statistic : mms_statistics) add(statistic.name, short_json(statistics.*statistic.value));
  if (!file.end) return counts;
  add("lines", file.end->lines);
  add("invalid lines", file.end->invalid_lines);
  return counts;
}

Json header_json(const MmsRecordFile& file) {
  const MmsBound bound = mms_bound_of(*file.maze);
  return {{"world", "mms"},
          {"traits", traits_json({.in_steps = false,
                                  .digits = 1,
                                  .bound = "the best possible score under the rules of mms",
                                  .runs = {"running"},
                                  .draws = true,
                                  .pictured = false})},
          {"mouse", file.mouse},
          {"maze", maze_data(file.maze_name, as_in_mms(*file.maze))},
          {"rules", nullptr},
          {"seed", nullptr},
          {"outcome", outcome_words(file)},
          {"finished", false},
          {"score", nullptr},
          {"bound", or_null(bound.score)},
          {"optimum", or_null(bound.run)},
          {"search_steps", 0},
          {"speed_steps", 0},
          {"discovered", nullptr},
          {"visited", nullptr},
          {"last_words", file.end ? file.end->errors : ""},
          {"counts", Json::array()},
          {"checked", file.left_out == 0 ? "" : fmt::format("{} more events were not recorded", file.left_out)},
          {"ended", file.end.has_value()}};
}

/// The cells of the best run, the start first. It ends on the threshold of the goal.
Json best_way(const Maze& maze) {
  const std::vector<std::string> commands = mms_best_commands(maze);
  Json cells = Json::array();
  if (commands.empty()) return cells;
  MmsHost host(maze, {});
  CellWay way;
  std::string replies;
  cells.push_back(cell_json({}));
  for (const std::string& command : commands) {
    host.obey(command, replies);
    for (const Cell cell : way.to(host.pose())) cells.push_back(cell_json(cell));
  }
  if (Json goal = cell_json(cell_of(host.pose().place)); goal != cells.back()) cells.push_back(std::move(goal));
  return cells;
}

}  // namespace

Json play_json(const MmsRecordFile& file) {
  const Maze maze = as_in_mms(*file.maze);
  Json play = header_json(file);
  MmsFrames frames(maze.size(), play);
  MmsStatistics statistics;
  replay(file, [&](std::size_t event, const MmsHost& host) {
    frames.add(file.events[event], host);
    statistics = host.statistics();
  });
  // The statistics in the record include events that it left out.
  if (file.end) statistics = file.end->statistics;
  play["finished"] = statistics.finished;
  play["score"] = decimal(statistics.score);
  play["search_steps"] = frames.steps();
  play["counts"] = counts_json(statistics, file);
  play["route"] = best_way(maze);
  play["distances"] = distances_json(maze, 1);
  play["reasons"] = Json::array();
  play["loses"] = Json::array();
  return play;
}

}  // namespace labmouse
