// The figures of the world of steps, by their places in the lists of contests and mazes.
#pragma once

#include <cstdint>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The figures of a contest, by their places in ContestResult::figures.
enum class StepsFigure : std::uint8_t {
  search_steps,
  speed_steps,  ///< null where the contest was not finished
  discovered,
  visited,
  blocked_steps,  ///< this and the next three are there where one of them is not 0
  void_rotations,
  cut_movements,
  idle_resets,
  first_action_error,  ///< as a count of the clock, 0 where there is none
  words,               ///< nothing where the mouse had nothing to say
  counts,              ///< an object; nothing where the mouse counted nothing
  decisions,
  microseconds,  ///< spent in them: the one figure that differs from race to race
};

/// The number of a figure; 0 where it is none.
double number_of(const ContestResult& contest, StepsFigure figure);

/// The one figure of a maze: the steps of its shortest run, null where there is none.
enum class StepsMazeFigure : std::uint8_t { optimum };

}  // namespace labmouse
