// Did my mouse improve? A race against an earlier one on the same mazes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/standings/maze_scores.hpp"

namespace labmouse {

/// The scores of an earlier race: of each mouse, by the maze's name.
struct Baseline {
  std::map<std::string, std::map<std::string, MazeScores>> mice;
  /// What the earlier race was held under, as JSON, by the names of the world's conditions.
  std::map<std::string, std::string> conditions;
};

/// The baseline of a world, or why the text has none: exactly one of the two is there.
struct ReadBaselineResult {
  std::optional<Baseline> baseline;
  std::string error;
  int line = 0, column = 0;  ///< of the error, where it has a place
};

/// Reads the JSON of a race, of any version so far. A failed contest counts the limit score of the world.
ReadBaselineResult read_baseline(std::string_view json, const World& world);

/// Compares each mouse with the one of the same name in the baseline, or with the only one that is there: maze by maze
/// (the same path, or else the same file name), the mean difference of the scores, new minus old, with its interval
/// over the mazes and a verdict. One line a mouse; where failed contests have no score, two more: how often it
/// finished, with a verdict, too, and the scores of the finished contests. One more line for each condition that is
/// another one now.
std::string compare_with_baseline(const Race& race, const Baseline& baseline);

}  // namespace labmouse
