// What a race in seconds says of each mouse.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/lab/numbers/statistics.hpp"
#include "labmouse/lab/races/drive_race.hpp"

namespace labmouse {

/// One mouse's line in the leaderboard. Only mazes with a route count, and only contests that were done.
struct DriveStanding {
  std::size_t mouse = 0;  ///< position in DriveRace::mice
  int mazes = 0;          ///< in which a contest counts
  int runs = 0;           ///< contests
  int scored = 0;         ///< those in which a run counts
  /// Over the scored contests, in seconds; nothing where there is none.
  std::optional<double> mean_score;
  Interval interval;                 ///< of the mean score over mazes
  std::optional<double> mean_ratio;  ///< score over the bound, both before a bonus
  std::optional<double> mean_search;
  std::optional<double> mean_best;    ///< run, from rest to the centre
  std::optional<double> mean_excess;  ///< of the best run over the fastest possible one, as a share of that
  std::optional<double> mean_starts;
  int optimal = 0;  ///< contests whose best run is a fastest possible one
  int proven = 0;   ///< those in which the mouse knew that no faster route could exist
  int decisions = 0;
  int replanned = 0;
};

/// The standings: whoever scores in more contests first, then the best mean score, then the shortest search, then by
/// name.
std::vector<DriveStanding> drive_standings_of(const DriveRace& race);

/// Whether a contest enters the means: it is done, and some mouse could score in its maze.
bool counts(const DriveRace& race, const DriveResult& result);

/// How much longer the best run took than the fastest possible one, as a share; nothing without a run or where that
/// takes no time.
std::optional<double> excess_of(const DriveRace& race, const DriveResult& result);

}  // namespace labmouse
