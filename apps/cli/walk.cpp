#include "walk.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "command.hpp"
#include "frames.hpp"
#include "labmouse/contest/missteps.hpp"
#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/pictures/picture_layers.hpp"
#include "labmouse/lab/steps/misstep_lines.hpp"
#include "labmouse/lab/steps/steps_files.hpp"

namespace labmouse::cli {
namespace {

std::string frame_of(const RecordFile& file, const StepRecord& step, const Knowledge& knowledge) {
  DrawingLayers layers;
  layers.coordinates = true;
  layers.mouse = step.pose;
  layers.unknown = knowledge.unknown();
  return fmt::format("{}step {:>4}  {} run  at ({},{}) heading {}  sees {} {} {}  {}{}{}\n",
                     draw_text(*file.maze, layers, colours()), step.step,
                     step.run == Run::speed ? "speed" : "exploration", step.pose.cell.x, step.pose.cell.y,
                     name_of(step.pose.heading), step.sighting.left, step.sighting.ahead, step.sighting.right,
                     action_words(step.action), has_void_rotation(step.action) ? " (invalid turn)" : "",
                     step.blocked ? "  blocked" : "");
}

/// Of a contest that never came to its speed run, the way of the exploration: it may show why.
LayerSet summary_layers(const RunRecord& run) {
  LayerSet layers = contest_layers();
  if (run.steps.empty() || run.steps.back().run == Run::exploration) layers.insert(Layer::exploration);
  return layers;
}

/// What the mouse said and counted and which steps were not performed as asked, if any, and how the contest went.
std::string last_lines(const RecordFile& file) {
  const std::string counts = counts_line(file);
  return last_words_lines(file) + (counts.empty() ? "" : counts + "\n") + misstep_lines(file) + result_line(file) +
         "\n";
}

}  // namespace

void watch(const RecordFile& file, int delay) {
  const Frames frames(file.maze->size(), 2);
  Knowledge knowledge(file.maze->size());
  for (const StepRecord& step : file.run.steps) {
    // A record need not make sense: what contradicts is drawn as it was known before.
    [[maybe_unused]] const bool learned = knowledge.learn(step.pose, step.sighting);
    frames.show(frame_of(file, step, knowledge));
    if (frames.moving()) std::this_thread::sleep_for(std::chrono::milliseconds(delay));
  }
  frames.show(frames.moving() ? summary_of(file) : last_lines(file));
}

std::string summary_of(const RecordFile& file) {
  return draw_text(*file.maze, layers_of(file, summary_layers(file.run)), colours()) + exploration_line(file) + "\n" +
         last_lines(file);
}

}  // namespace labmouse::cli
