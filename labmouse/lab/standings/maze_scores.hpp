// What the contests of a mouse came to in each maze.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// One mouse in one maze.
struct MazeScores {
  int contests = 0;
  int finished = 0;           ///< those with a score
  double sum = 0.0;           ///< of all scores, failed contests at the limit score of their world
  double finished_sum = 0.0;  ///< of the scores alone

  /// Adds a contest with that score, if any; `counted` is the score, or the limit score of a failed contest.
  void add(std::optional<double> score, double counted);
  /// Nothing where there is no contest.
  std::optional<double> mean() const;
  std::optional<double> finished_mean() const;
  /// Of the contests, 0 to 1.
  std::optional<double> failed_share() const;
};

/// Of each maze of the race, by position; no contests where none counts.
std::vector<MazeScores> maze_scores(const Race& race, std::size_t mouse);

}  // namespace labmouse
