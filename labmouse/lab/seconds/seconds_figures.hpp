// The figures of the world of seconds, by their places in the lists of contests and mazes.
#pragma once

#include <cstdint>

namespace labmouse {

/// The figures of a contest, by their places in ContestResult::figures. Times are whole microseconds.
enum class SecondsFigure : std::uint8_t {
  score,   ///< an object of its parts; null where no run counts
  search,  ///< in the maze before the first fast run; all of the time where there is none
  best,    ///< the fastest run that counts, from rest to the centre; null where there is none
  excess,  ///< of that over the fastest possible one, as a share of it
  proven,  ///< whether no faster route than the known one could exist before the last fast run
  starts,  ///< runs from the start
  decisions,
  replanned,
  discovered,
  visited,
  words,     ///< what the mouse had to say; none where it said nothing
  score_us,  ///< of the best run by the rules, and its two times
  gate_to_gate,
  rest_to_centre,
};

/// The figures of a maze, in microseconds, null where there is none.
enum class SecondsMazeFigure : std::uint8_t { fastest, bound };

}  // namespace labmouse
