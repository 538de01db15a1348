// Did my mouse improve? A race against an earlier one on the same mazes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The scores of an earlier race: of each mouse, by the maze's name, what its runs counted.
struct Baseline {
  std::map<std::string, std::map<std::string, std::vector<double>>> mice;
  /// What the earlier race was held under, as JSON, by the names of the world's conditions.
  std::map<std::string, std::string> conditions;
};

/// The baseline of a world, or why the text has none: exactly one of the two is there.
struct ReadBaselineResult {
  std::optional<Baseline> baseline;
  std::string error;
  int line = 0, column = 0;  ///< of the error, where it has a place
};

/// Reads the JSON of a race, of any version so far. A failed contest counts what the world says; where it says nothing,
/// it is left out.
ReadBaselineResult read_baseline(std::string_view json, const World& world);

/// Compares each mouse with the one of the same name in the baseline, or with the only one that is there: maze by maze
/// (the same path, or else the same file name), the mean difference of the scores, new minus old, with its interval
/// over the mazes. One line a mouse, and one more for each condition that is another one now.
std::string compare_with_baseline(const Race& race, const Baseline& baseline);

}  // namespace labmouse
