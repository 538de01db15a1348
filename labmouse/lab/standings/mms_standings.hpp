// What a race of programs written for mms says of each.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "labmouse/lab/numbers/statistics.hpp"
#include "labmouse/lab/races/mms_race.hpp"

namespace labmouse {

/// One mouse's line in the leaderboard. Only mazes whose centre can be reached count, and only runs that were done.
struct MmsStanding {
  std::size_t mouse = 0;  ///< position in MmsRace::mice
  int runs = 0;           ///< one in each maze
  int solved = 0;         ///< runs that went to the centre at least once
  /// Over all runs: mms's score, which is 2000 for an unsolved one, and its interval over mazes.
  std::optional<double> mean_score;
  Interval interval;
  /// Over the solved runs; nothing where there is none.
  std::optional<double> mean_solved_score;
  std::optional<double> mean_best_run;   ///< effective distance + turns
  std::optional<double> mean_ratio;      ///< score over the best possible score
  std::optional<double> mean_run_ratio;  ///< best run over the best possible run
  /// Over all runs.
  std::optional<double> mean_total;    ///< effective distance + turns of all that was done
  std::optional<double> mean_seconds;  ///< of real time
  std::int64_t lines = 0;
  std::int64_t invalid_lines = 0;
  /// Runs by MmsOutcome, those in mazes without a way to the centre among them.
  std::array<int, 11> outcomes{};
};

/// The standings, best mean score first, equal ones by name.
std::vector<MmsStanding> mms_standings_of(const MmsRace& race);

/// Whether a run enters the means: it is done, and the centre of its maze can be reached.
bool counts(const MmsRace& race, const MmsResult& result);

/// Score over the best possible score, best run over the best possible run; nothing where the run is unsolved.
std::optional<double> score_ratio(const MmsRace& race, const MmsResult& result);
std::optional<double> run_ratio(const MmsRace& race, const MmsResult& result);

}  // namespace labmouse
