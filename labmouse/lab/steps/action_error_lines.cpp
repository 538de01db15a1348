#include "labmouse/lab/steps/action_error_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/lab/mice/mouse_names.hpp"
#include "labmouse/lab/steps/steps_figures.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

constexpr std::array figures = {&StepsFigures::blocked_steps, &StepsFigures::void_rotations,
                                &StepsFigures::cut_movements, &StepsFigures::idle_resets};

/// The words for each kind of action error, after the number of steps: singular and plural.
constexpr std::array<std::array<std::string_view, 2>, figures.size()> short_words = {
    {{"blocked by a wall", "blocked by walls"},
     {"void rotation", "void rotations"},
     {"cut movement", "cut movements"},
     {"idle reset", "idle resets"}}};

/// "490 blocked by walls, 2 void rotations; first in contest-05, step 7"; empty where a mouse has none.
std::string counts_of(const Race& race, std::size_t mouse) {
  std::array<std::int64_t, figures.size()> steps = {};
  std::string first, words;
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != mouse || !contest.done) continue;
    const auto& counted = figures_of<StepsFigures>(contest);
    for (std::size_t kind = 0; kind < figures.size(); ++kind) steps[kind] += (counted.*figures[kind]).value_or(0);
    if (const auto step = counted.first_action_error; step > 0 && first.empty())
      first = fmt::format("; first in {}{}, step {}", shown(race.mazes[contest.maze].name),
                          contest.run > 0 ? fmt::format(", run {}", contest.run + 1) : "", step);
  }
  for (std::size_t kind = 0; kind < figures.size(); ++kind)
    if (const auto count = steps[kind]; count > 0)
      words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, short_words[kind][count == 1 ? 0 : 1]);
  return words + first;
}

}  // namespace

std::string action_error_lines(const Race& race) {
  std::vector<std::string> specs;
  for (const Contestant& mouse : race.mice) specs.push_back(mouse.name);
  const std::vector<std::string> names = mouse_names(specs);
  std::string lines;
  for (std::size_t mouse = 0; mouse < names.size(); ++mouse)
    if (const auto words = counts_of(race, mouse); !words.empty())
      lines += fmt::format("  {}: {}\n", names[mouse], words);
  return lines.empty() ? "" : "Steps that were not carried out as asked:\n" + lines;
}

}  // namespace labmouse
