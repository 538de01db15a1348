#include "walk.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "command.hpp"
#include "labmouse/lab/drawing.hpp"
#include "labmouse/lab/layers.hpp"
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

/// The text from the top of the screen, with what stood there before erased to the right and below.
std::string over_the_last(std::string_view text) {
  std::string frame = "\x1b[H";
  for (const char letter : text) frame += letter == '\n' ? std::string("\x1b[K\n") : std::string(1, letter);
  return frame + "\x1b[J";
}

/// A frame that scrolls or wraps cannot be watched.
void require_room(Size size) {
  winsize window{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_row == 0) return;
  const int columns = 4 * size.width + 4, rows = 2 * size.height + 5;
  if (window.ws_col >= columns && window.ws_row >= rows) return;
  throw UsageError(fmt::format("error: to watch a maze of {}x{} takes a terminal of {}x{}, and this one has {}x{}; make it larger "
                               "or its letters smaller, or pipe the frames into a pager", size.width, size.height, columns, rows,
                               window.ws_col, window.ws_row));
}

/// What the mouse counted, if it did, and how the contest went.
std::string last_lines(const RecordFile& file) {
  const std::string counts = counts_line(file);
  return (counts.empty() ? "" : counts + "\n") + result_line(file) + "\n";
}

}  // namespace

void watch(const RecordFile& file, int delay) {
  const bool terminal = isatty(STDOUT_FILENO) != 0;
  if (terminal) {
    require_room(file.maze->size());
    print("\x1b[2J");
  }
  Knowledge knowledge(file.maze->size());
  for (const StepRecord& step : file.run.steps) {
    // A record need not make sense: what contradicts is drawn as it was known before.
    [[maybe_unused]] const bool learned = knowledge.learn(step.pose, step.sighting);
    const std::string frame = frame_of(file, step, knowledge);
    print(terminal ? over_the_last(frame) : frame);
    if (terminal) std::this_thread::sleep_for(std::chrono::milliseconds(delay));
  }
  print(terminal ? over_the_last(summary_of(file)) : last_lines(file));
}

std::string summary_of(const RecordFile& file) {
  return draw_text(*file.maze, layers_of(file, contest_layers()), colours()) + exploration_line(file) + "\n" +
         last_lines(file);
}

}  // namespace labmouse::cli
