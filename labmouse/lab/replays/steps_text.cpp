#include "labmouse/lab/replays/steps_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/contest/action_errors.hpp"
#include "labmouse/contest/coverage.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/mice/mouse_names.hpp"
#include "labmouse/lab/pictures/picture_layers.hpp"
#include "labmouse/lab/system/file_names.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/last_lines.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

/// The reason of a forfeit in brackets, or nothing.
std::string reason_in_brackets(const RunRecord& run) {
  if (run.outcome != Outcome::forfeit || run.steps.empty()) return "";
  return fmt::format(" ({})", name_of(run.steps.back().action.reason));
}

constexpr std::array all_kinds = {&ActionErrors::blocked, &ActionErrors::void_rotations, &ActionErrors::cut_movements,
                                  &ActionErrors::idle_resets};

/// The words for each kind of action error, after the number of steps.
std::array<std::string, all_kinds.size()> words_for(bool one, const Rules& rules) {
  const char* was = one ? "was" : "were";
  return {fmt::format("{} blocked by a wall", was), "had a void turn (not -90, 0 or 90)",
          fmt::format("{} cut to {}", was, rules.stride == 1 ? "1 cell" : fmt::format("{} cells", rules.stride)),
          one ? "was a reset that did nothing" : "were resets that did nothing"};
}

/// "step 7 at (0,6) heading north: turn -90, move +1".
std::string step_words(const RunRecord& run, int number) {
  const auto is_it = [&](const StepRecord& step) { return step.step == number; };
  const auto found = std::find_if(run.steps.begin(), run.steps.end(), is_it);
  const Pose& pose = found->pose;
  return fmt::format("step {} at ({},{}) heading {}: {}", number, pose.cell.x, pose.cell.y, name_of(pose.heading),
                     action_words(found->action));
}

std::string frame_of(const RecordFile& file, const StepRecord& step, const Knowledge& knowledge,
                     const TextDrawer& draw) {
  DrawingLayers layers;
  layers.coordinates = true;
  layers.mouse = step.pose;
  layers.unknown = knowledge.unknown();
  return fmt::format("{}step {:>4}  {} run  at ({},{}) heading {}  sees {} {} {}  {}{}{}\n", draw(*file.maze, layers),
                     step.step, step.run == Run::speed ? "speed" : "search", step.pose.cell.x, step.pose.cell.y,
                     name_of(step.pose.heading), step.sighting.left, step.sighting.ahead, step.sighting.right,
                     action_words(step.action), has_void_rotation(step.action) ? " (invalid turn)" : "",
                     step.blocked ? "  blocked" : "");
}

/// Adds the path of the search run if the contest never came to its speed run: it may show why.
LayerSet summary_layers(const RunRecord& run) {
  LayerSet layers = contest_layers();
  if (run.steps.empty() || run.steps.back().run == Run::search_run) layers.insert(Layer::search_run);
  return layers;
}

/// What the mouse said and counted and which steps were not performed as asked, if any, and how the contest went.
std::string end_lines(const RecordFile& file) {
  const std::string counts = counts_line(file);
  return last_words_lines(file) + (counts.empty() ? "" : counts + "\n") + action_error_lines(file) + result_line(file) +
         "\n";
}

}  // namespace

std::string title_of(const RecordFile& file) {
  const Score result = score(file.run, file.rules);
  const std::string where = fmt::format("{} in {}: ", mouse_names({file.mouse}).front(), stem_of(file.maze_name));
  if (result.value) return where + fmt::format("score {:.3f}", *result.value);
  if (!file.ended) return where + fmt::format("breaks off after step {}", file.run.steps.size());
  return where + std::string(name_of(result.outcome));
}

std::string picture_of(const RecordFile& file) {
  DrawingLayers layers = layers_of(file, contest_layers());
  layers.title = title_of(file);
  return draw_svg(*file.maze, layers);
}

std::string search_run_line(const RecordFile& file) {
  const Coverage coverage = coverage_of(file.run, *file.maze);
  const int cells = reachable_cells(*file.maze).count();
  return fmt::format("search: discovered {:.1f} %, visited {:.1f} % of {} reachable {}", 100.0 * coverage.discovered,
                     100.0 * coverage.visited, cells, cells == 1 ? "cell" : "cells");
}

std::string result_line(const RecordFile& file) {
  const Score result = score(file.run, file.rules);
  const Bound bound = bound_of(*file.maze, file.rules);
  std::string line = fmt::format("{} in {}: ", file.mouse, file.maze_name);
  if (!file.ended && !result.value)
    line += fmt::format("the record breaks off after step {}", file.run.steps.size());
  else if (result.value)
    line += fmt::format("finished, score {:.3f} = {} speed + {} search / {}", *result.value, result.speed_steps,
                        result.search_steps, file.rules.search_factor);
  else
    line += fmt::format("{}{} at ({},{}) heading {} after {} search and {} speed steps", name_of(result.outcome),
                        reason_in_brackets(file.run), file.run.end.cell.x, file.run.end.cell.y,
                        name_of(file.run.end.heading), result.search_steps, result.speed_steps);
  line += bound.score ? fmt::format("; bound {:.3f}", *bound.score) : "; the goal cannot be reached";
  return shown(line);
}

std::string checked_line(const RecordFile& file) {
  const auto whole = [](const GivenFields& given) { return given == GivenFields(); };
  const bool whole_end = !file.ended || (file.given_end.cell && file.given_end.heading);
  if (whole_end && std::all_of(file.given.begin(), file.given.end(), whole)) return "";
  const auto checked = [&](bool GivenFields::*field, std::string_view one, std::string_view many) {
    const auto has = [&](const GivenFields& given) { return given.*field; };
    const auto count = static_cast<int>(std::count_if(file.given.begin(), file.given.end(), has));
    return count > 0 ? ", " + counted(count, one, many) : "";
  };
  const std::string readings = checked(&GivenFields::reading, "reading", "readings");
  std::string line = fmt::format("checked in {}: ", counted(file.given.size(), "step", "steps"));
  line += readings.empty() ? "no readings" : readings.substr(2);
  line += checked(&GivenFields::cell, "cell", "cells") + checked(&GivenFields::heading, "heading", "headings");
  line += checked(&GivenFields::run, "run", "runs") + checked(&GivenFields::blocked, "blocked flag", "blocked flags");
  return line + (file.ended ? ", the outcome" : "");
}

std::string last_words_lines(const RecordFile& file) {
  constexpr std::size_t most = 10;
  std::string_view words = file.run.last_words;
  std::string text;
  if (file.run.outcome == Outcome::forfeit && !words.empty()) {
    const auto end = std::min(words.find('\n'), words.size());
    text = shown(words.substr(0, end)) + "\n";
    words.remove_prefix(end);
  }
  for (const std::string& line : last_lines(words, most)) text += fmt::format("| {}\n", shown(line));
  return text;
}

std::string counts_line(const RecordFile& file) {
  std::string line;
  for (const Count& count : file.run.counts)
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count.name, count.value);
  return shown(line);
}

std::string action_words(const Action& action) {
  switch (action.kind) {
    case Action::Kind::step:
      return fmt::format("turn {:+d}, move {:+d}", action.rotation, action.movement);
    case Action::Kind::reset:
      return "reset";
    case Action::Kind::forfeit:
      return fmt::format("forfeit: {}", name_of(action.reason));
  }
  return "";
}

std::string action_error_lines(const RecordFile& file) {
  const ActionErrors action_errors = action_errors_of(file.run, file.rules);
  std::string lines;
  for (std::size_t kind = 0; kind < all_kinds.size(); ++kind) {
    const auto& [steps, first] = action_errors.*all_kinds[kind];
    if (steps == 0) continue;
    const bool one = steps == 1;
    lines += fmt::format("{} of {} steps {}, {}{}\n", steps, file.run.steps.size(), words_for(one, file.rules)[kind],
                         one ? "" : "first ", step_words(file.run, first));
  }
  return lines;
}

void animate(const RecordFile& file, const TextDrawer& draw, const std::function<void(const std::string&)>& show) {
  Knowledge knowledge(file.maze->size());
  for (const StepRecord& step : file.run.steps) {
    // A record can have a reading that contradicts earlier ones; then the earlier knowledge is drawn.
    [[maybe_unused]] const bool learned = knowledge.learn(step.pose, step.sighting);
    show(frame_of(file, step, knowledge, draw));
  }
}

std::string summary_of(const RecordFile& file, const TextDrawer& draw) {
  return draw(*file.maze, layers_of(file, summary_layers(file.run))) + search_run_line(file) + "\n" + end_lines(file);
}

}  // namespace labmouse
