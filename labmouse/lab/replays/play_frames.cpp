#include "labmouse/lab/replays/play_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "labmouse/contest/coverage.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/lab/replays/fields.hpp"
#include "labmouse/lab/text/optional_json.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {
namespace {

const Pose& pose_in(const RunRecord& run, std::size_t frame) {
  return frame < run.steps.size() ? run.steps[frame].pose : run.end;
}

/// The frame after the first step that ended in a goal.
std::optional<std::size_t> goal_frame(const RecordFile& file) {
  const auto& steps = file.run.steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (steps[i].action.kind == Action::Kind::step && file.maze->is_goal(pose_in(file.run, i + 1).cell)) return i + 1;
  return std::nullopt;
}

/// The frame with which the speed run begins. A reset before a goal was entered does nothing.
std::optional<std::size_t> reset_frame(const RecordFile& file) {
  const auto goal = goal_frame(file);
  const auto& steps = file.run.steps;
  for (std::size_t i = goal ? *goal : steps.size(); i < steps.size(); ++i)
    if (steps[i].action.kind == Action::Kind::reset) return i + 1;
  return std::nullopt;
}

/// The frame from which each wall is known, in the order of Play's list; -1 for never.
class KnownFrames {
 public:
  explicit KnownFrames(Size size)
      : size_(size),
        knowledge_(size),
        unknown_(knowledge_.unknown()),
        frames_(2 * static_cast<std::size_t>(size.area()), 0) {
    unknown_.for_each([this](Wall wall) { frame_of(wall) = -1; });
  }

  void learn(const StepRecord& step, std::size_t frame) {
    // A record that agrees with its maze has no reading that contradicts.
    [[maybe_unused]] const bool learned = knowledge_.learn(step.pose, step.sighting);
    WallSet seen = unknown_;
    unknown_ = knowledge_.unknown();
    seen -= unknown_;
    if (!seen.empty()) seen.for_each([&](Wall wall) { frame_of(wall) = static_cast<int>(frame); });
  }
  const std::vector<int>& frames() const { return frames_; }

 private:
  int& frame_of(Wall wall) {
    const int index = size_.index(wall.cell) + (wall.side == Heading::east ? size_.area() : 0);
    return frames_[static_cast<std::size_t>(index)];
  }

  Size size_;
  Knowledge knowledge_;
  WallSet unknown_;
  std::vector<int> frames_;
};

Json entered_json(const StepRecord& step, const Pose& next, Size size) {
  Json cells = Json::array();
  for (const Cell cell : entered_cells(step, next, size)) cells.push_back(size.index(cell));
  return cells;
}

std::string turn_words(int rotation) {
  if (rotation == 90) return "right";
  if (rotation == -90) return "left";
  return rotation == 0 ? "" : fmt::format("turn {}", rotation);
}

}  // namespace

std::string short_words(const Action& action) {
  if (action.kind == Action::Kind::reset) return "reset";
  if (action.kind == Action::Kind::forfeit) return fmt::format("forfeit: {}", name_of(action.reason));
  const std::string turn = turn_words(action.rotation);
  if (action.movement == 0) return turn.empty() ? "stay" : turn;
  const char* ahead = turn.empty() ? "ahead " : "";
  const std::string move = fmt::format("{}{}", action.movement < 0 ? "back " : ahead, std::abs(action.movement));
  return turn.empty() ? move : turn + ", " + move;
}

void add_frames(const RecordFile& file, Json& play) {
  const auto reset = reset_frame(file);
  for (const char* list : {"clock", "x", "y", "heading", "run", "scores"}) play[list] = Json::array();
  Json &clock = play["clock"], &x = play["x"], &y = play["y"], &heading = play["heading"], &run = play["run"];
  for (std::size_t frame = 0; frame <= file.run.steps.size(); ++frame) {
    const Pose& pose = pose_in(file.run, frame);
    clock.push_back(frame);
    x.push_back(2 * pose.cell.x + 1);
    y.push_back(2 * pose.cell.y + 1);
    heading.push_back(eighths(pose.heading));
    run.push_back(reset && frame >= *reset ? 1 : 0);
    const auto search_run = static_cast<int>(std::min(frame, reset.value_or(frame)));
    play["scores"].push_back(score_of(search_run, static_cast<int>(frame) - search_run, file.rules));
  }
  play["goal_frame"] = or_null(goal_frame(file));
  play["reset_frame"] = or_null(reset);
}

void add_steps(const RecordFile& file, Json& play) {
  const Size size = file.maze->size();
  KnownFrames known(size);
  for (const char* list : {"action", "blocked", "left", "ahead", "right", "entered"}) play[list] = Json::array();
  for (std::size_t i = 0; i < file.run.steps.size(); ++i) {
    const StepRecord& step = file.run.steps[i];
    known.learn(step, i);
    play["action"].push_back(short_words(step.action));
    play["blocked"].push_back(step.blocked);
    play["left"].push_back(step.sighting.left);
    play["ahead"].push_back(step.sighting.ahead);
    play["right"].push_back(step.sighting.right);
    play["entered"].push_back(entered_json(step, pose_in(file.run, i + 1), size));
  }
  play["known"] = known.frames();
}

}  // namespace labmouse
