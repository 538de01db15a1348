// The figures of the world of mms, by their places in the lists of contests and mazes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The figures of a run, by their places in ContestResult::figures.
enum class MmsFigure : std::uint8_t {
  outcome,
  end,
  finished,
  score,
  best_run,  ///< effective distance + turns; null while unfinished
  run_ratio,
  statistics,  ///< an object of all values of `getStat`
  total,       ///< effective distance + turns of all that was done
  lines,
  invalid_lines,
  log,
  errors,
  simulated_seconds,
  seconds,  ///< of real time: the one figure that differs from race to race
  visited,
};

inline const Value& figure_at(const ContestResult& contest, MmsFigure figure) {
  return contest.figures[static_cast<std::size_t>(figure)];
}

/// The figures of a maze: the least run and the least score, null where the centre cannot be reached.
enum class MmsMazeFigure : std::uint8_t { run, score };

}  // namespace labmouse
