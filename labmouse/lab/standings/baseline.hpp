// Did my mouse improve? A race against an earlier one on the same mazes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "labmouse/lab/races/tournament.hpp"

namespace labmouse {

/// The scores of an earlier race: of each mouse, by the maze's name, the penalised scores of its runs.
struct Baseline {
  std::map<std::string, std::map<std::string, std::vector<double>>> mice;
  /// Steps of a contest.
  int budget = Rules().budget;
};

/// Reads the JSON of a race; nothing where it is none. A failed contest counts as the rules say.
std::optional<Baseline> read_baseline(std::string_view json, const Rules& rules);

/// Compares each mouse with the one of the same name in the baseline, or with the only one that is there: maze by maze
/// (the same path, or else the same file name), the mean difference of the penalised scores, new minus old, with its
/// interval over the mazes. One line a mouse, and one more where the budgets differ.
std::string compare_with_baseline(const Race& race, const Baseline& baseline);

}  // namespace labmouse
