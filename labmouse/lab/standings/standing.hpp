// One mouse's line in the leaderboard.
#pragma once

#include <cstddef>
#include <optional>

#include "labmouse/lab/numbers/interval.hpp"

namespace labmouse {

/// Only mazes in which a mouse can score count, and only contests that were done.
struct Standing {
  std::size_t mouse = 0;  ///< position in Race::mice
  int mazes = 0;          ///< in which a contest enters the mean over all
  int runs = 0;           ///< contests
  int finished = 0;       ///< those with a score
  /// Mean of what contests count in this world (failed ones may count nothing), and its interval over mazes.
  std::optional<double> mean_all;
  Interval interval;
  /// The same with failed contests at the limit score, as in comparisons. Equal to `mean_all` if the world itself
  /// counts failed contests.
  std::optional<double> mean_at_limit;
  Interval interval_at_limit;
  /// Of the share of contests with a score, over mazes.
  Interval finished_share;
  /// Mean of share_of_best() over all contests, and its interval over mazes; nothing where no contest has one.
  std::optional<double> mean_share;
  Interval share;
  /// Over the contests with a score; nothing where there is none.
  std::optional<double> mean_finished;
  std::optional<double> mean_ratio;  ///< score over the maze's bound
};

}  // namespace labmouse
