#include "labmouse/lab/steps/misstep_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/contest/missteps.hpp"
#include "labmouse/lab/mice/mouse_names.hpp"
#include "labmouse/lab/steps/steps_figures.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr std::array all_kinds = {&Missteps::blocked, &Missteps::void_rotations, &Missteps::cut_movements,
                                  &Missteps::idle_resets};

/// What a contest says of each kind, behind the number of its steps.
std::array<std::string, all_kinds.size()> words_for(bool one, const Rules& rules) {
  const char* was = one ? "was" : "were";
  return {fmt::format("{} blocked by a wall", was), "had a void turn (not -90, 0 or 90)",
          fmt::format("{} cut to {}", was, rules.stride == 1 ? "1 cell" : fmt::format("{} cells", rules.stride)),
          one ? "was a reset that did nothing" : "were resets that did nothing"};
}

/// What a race says of each kind, behind its number: of one and of several.
constexpr std::array<std::array<std::string_view, 2>, all_kinds.size()> short_words = {
    {{"blocked by a wall", "blocked by walls"},
     {"void rotation", "void rotations"},
     {"cut movement", "cut movements"},
     {"idle reset", "idle resets"}}};

/// "step 7 at (0,6) heading north: turn -90, move +1".
std::string step_words(const RunRecord& run, int number) {
  const auto is_it = [&](const StepRecord& step) { return step.step == number; };
  const auto found = std::find_if(run.steps.begin(), run.steps.end(), is_it);
  const Pose& pose = found->pose;
  return fmt::format("step {} at ({},{}) heading {}: {}", number, pose.cell.x, pose.cell.y, name_of(pose.heading),
                     action_words(found->action));
}

/// "490 blocked by walls, 2 void rotations; first in contest-05, step 7"; empty where a mouse has none.
std::string counts_of(const Race& race, std::size_t mouse) {
  constexpr std::array figures = {StepsFigure::blocked_steps, StepsFigure::void_rotations, StepsFigure::cut_movements,
                                  StepsFigure::idle_resets};
  std::array<double, figures.size()> steps = {};
  std::string first, words;
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != mouse || !contest.done) continue;
    for (std::size_t kind = 0; kind < figures.size(); ++kind) steps[kind] += number_of(contest, figures[kind]);
    if (const double step = number_of(contest, StepsFigure::first_misstep); step > 0 && first.empty())
      first = fmt::format("; first in {}{}, step {:g}", shown(race.mazes[contest.maze].name),
                          contest.run > 0 ? fmt::format(", run {}", contest.run + 1) : "", step);
  }
  for (std::size_t kind = 0; kind < figures.size(); ++kind)
    if (const double count = steps[kind]; count > 0)
      words += fmt::format("{}{:.0f} {}", words.empty() ? "" : ", ", count, short_words[kind][count == 1 ? 0 : 1]);
  return words + first;
}

}  // namespace

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

std::string misstep_lines(const RecordFile& file) {
  const Missteps missteps = missteps_of(file.run, file.rules);
  std::string lines;
  for (std::size_t kind = 0; kind < all_kinds.size(); ++kind) {
    const auto& [steps, first] = missteps.*all_kinds[kind];
    if (steps == 0) continue;
    const bool one = steps == 1;
    lines += fmt::format("{} of {} steps {}, {}{}\n", steps, file.run.steps.size(), words_for(one, file.rules)[kind],
                         one ? "" : "first ", step_words(file.run, first));
  }
  return lines;
}

std::string misstep_lines(const Race& race) {
  std::vector<std::string> specs;
  for (const Contestant& mouse : race.mice) specs.push_back(mouse.name);
  const std::vector<std::string> names = mouse_names(specs);
  std::string lines;
  for (std::size_t mouse = 0; mouse < names.size(); ++mouse)
    if (const auto words = counts_of(race, mouse); !words.empty())
      lines += fmt::format("  {}: {}\n", names[mouse], words);
  return lines.empty() ? "" : "Steps that were not performed as asked:\n" + lines;
}

}  // namespace labmouse
