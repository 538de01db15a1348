// The figures of the worlds in which robots drive, by their places in the lists of contests and mazes.
#pragma once

#include <cstdint>

namespace labmouse {

// Both lists of contests begin and end with the same figures.

/// The figures of a contest without errors, by their places in ContestResult::figures. Times are whole microseconds.
enum class SecondsFigure : std::uint8_t {
  score,   ///< an object of its parts; null where no run counts
  search,  ///< in the maze before the first speed run; all of the time where there is none
  best,    ///< the fastest run that counts, from rest to the centre; null where there is none
  excess,  ///< of that over the fastest possible one, as a share of it
  proven,  ///< whether no faster route than the known one could exist before the last speed run
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

/// The figures of a contest in which things go wrong, by their places in ContestResult::figures. Times are whole
/// microseconds; counts are of runs from the start, searches among them, unless they say otherwise. What nobody knows
/// of a mouse whose whole program is somebody else's is null.
enum class PhysicalFigure : std::uint8_t {
  score,   ///< an object of its parts; null where no run counts
  search,  ///< in the maze before the first speed run; all of the time where there is none
  best,    ///< the fastest run that counts, from rest to the centre; null where there is none
  excess,  ///< of that over the fastest possible one, as a share of it
  starts,
  done,
  slid,  ///< crashes by their causes, ways home among them
  position_lost,
  wall_error,
  no_route_left,
  late,     ///< cut short by the end of the time
  carried,  ///< how often a hand took the mouse to the start
  grazes,
  wrong_walls,  ///< walls that it took for what they are not
  contradictions,
  severity,  ///< how unlucky its draws were, in deviations
  par1,      ///< seconds: the score, or without one the time limit
  decisions,
  replanned,
  discovered,
  visited,
  ended_by,  ///< a name of RunEnd: what ended a contest without a score; null where it has one
  words,     ///< what the mouse had to say; none where it said nothing
  score_us,  ///< of the best run by the rules, and its two times
  gate_to_gate,
  rest_to_centre,
};

/// The figures of a maze, in microseconds, null where there is none.
enum class DriveMazeFigure : std::uint8_t { fastest, bound };

}  // namespace labmouse
