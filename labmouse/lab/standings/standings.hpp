// What a race says of each mouse.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/lab/numbers/statistics.hpp"
#include "labmouse/lab/races/tournament.hpp"

namespace labmouse {

/// One mouse's line in the leaderboard. Only mazes with a route count, and only contests that were done.
struct Standing {
  std::size_t mouse = 0;  ///< position in Race::mice
  int mazes = 0;
  int runs = 0;
  int solved = 0;
  /// Over the solved contests; nothing where there is none.
  std::optional<double> mean_score;
  std::optional<double> mean_ratio;               ///< score over the maze's bound
  std::optional<double> mean_exploration;         ///< steps
  std::optional<double> mean_speed_over_optimum;  ///< steps
  /// Over all contests, a failed one counted as the rules' failure score, and its interval over mazes.
  std::optional<double> penalised_mean;
  Interval interval;
  /// Share of all contests whose speed run was a shortest one, 0 to 1.
  double optimal_share = 0.0;
  double microseconds_per_decision = 0.0;
  /// Means over all contests, solved or not; nothing where there is none.
  std::optional<double> mean_discovered;  ///< share, 0 to 1
  std::optional<double> mean_visited;     ///< share, 0 to 1
};

/// The standings, best penalised mean first, equal ones by name.
std::vector<Standing> standings_of(const Race& race);

/// What a contest counts: its score, or the failure score.
double penalised(const Race& race, const ContestResult& contest);

/// Whether a contest enters the means: it is done, and its maze has a route.
bool counts(const Race& race, const ContestResult& contest);

/// A mouse's mean penalised score in each maze (by position), where it has one.
std::vector<std::optional<double>> scores_by_maze(const Race& race, std::size_t mouse);

}  // namespace labmouse
