#include "walk.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "command.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/lab/bounds.hpp"
#include "labmouse/lab/printable.hpp"
#include "labmouse/lab/race_files.hpp"

namespace labmouse::cli {
namespace {

std::string action_text(const Action& action) {
  switch (action.kind) {
    case Action::Kind::step: return fmt::format("turn {:+d}, move {:+d}", action.rotation, action.movement);
    case Action::Kind::reset: return "reset";
    case Action::Kind::forfeit: return fmt::format("forfeit: {}", name_of(action.reason));
  }
  return "";
}

std::string frame_of(const RecordFile& file, const StepRecord& step, const Knowledge& knowledge) {
  DrawingLayers layers;
  layers.coordinates = true;
  layers.mouse = step.pose;
  layers.unknown = knowledge.unknown();
  return fmt::format("{}step {:>4}  {} run  at ({},{}) heading {}  sees {} {} {}  {}\n", draw_text(*file.maze, layers, colours()),
                     step.step, step.run == Run::speed ? "speed" : "exploration", step.pose.cell.x, step.pose.cell.y,
                     name_of(step.pose.heading), step.sighting.left, step.sighting.ahead, step.sighting.right,
                     action_text(step.action));
}

}  // namespace

void watch(const RecordFile& file, int delay) {
  const bool terminal = isatty(STDOUT_FILENO) != 0;
  Knowledge knowledge(file.maze->size());
  if (terminal) print("\x1b[2J");
  for (const StepRecord& step : file.run.steps) {
    // A record need not make sense: what contradicts is drawn as it was known before.
    [[maybe_unused]] const bool learned = knowledge.learn(step.pose, step.sighting);
    print((terminal ? "\x1b[H" : "") + frame_of(file, step, knowledge));
    if (terminal) std::this_thread::sleep_for(std::chrono::milliseconds(delay));
  }
}

std::string result_line(const RecordFile& file) {
  const Score result = score(file.run, file.rules);
  const Bound bound = bound_of(*file.maze, file.rules);
  std::string line = fmt::format("{} in {}: {}", file.mouse, file.maze_name, name_of(result.outcome));
  if (result.outcome == Outcome::forfeit) line += fmt::format(" ({})", name_of(file.run.steps.back().action.reason));
  if (result.value)
    line += fmt::format(", score {:.3f} = {} speed + {} exploration / {}", *result.value, result.speed_steps,
                        result.exploration_steps, file.rules.exploration_factor);
  else
    line += fmt::format(" after {} exploration and {} speed steps", result.exploration_steps, result.speed_steps);
  line += bound.score ? fmt::format("; bound {:.3f}", *bound.score) : "; the goal cannot be reached";
  return utf8(printable(line)) + "\n";
}

std::string summary_of(const RecordFile& file) {
  return draw_text(*file.maze, layers_of(*file.maze, file.run), colours()) + result_line(file);
}

std::string picture_of(const RecordFile& file) {
  DrawingLayers layers = layers_of(*file.maze, file.run);
  layers.title = title_of(file);
  return draw_svg(*file.maze, layers);
}

}  // namespace labmouse::cli
