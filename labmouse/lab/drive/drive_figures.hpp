// The figures of the worlds in which robots drive.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "labmouse/lab/races/figures.hpp"

namespace labmouse {

/// Those that all these worlds have. Times are whole microseconds.
struct DriveFigures : Figures {
  std::optional<JsonText> score;     ///< an object of its parts; nothing where no run counts
  std::int64_t search = 0;           ///< in the maze before the first speed run; all of the time where there is none
  std::optional<std::int64_t> best;  ///< the fastest run that counts, from rest to the centre
  std::optional<double> excess;  ///< time of `best` above that of the fastest possible run, as a share of the latter
  std::int64_t starts = 0;       ///< runs from the start
  std::int64_t decisions = 0;
  std::int64_t replanned = 0;
  std::optional<double> discovered, visited;  ///< shares of the reachable cells, where they are known
  LeftOut<std::string> words;                 ///< what the mouse had to say
  std::optional<std::int64_t> score_us, gate_to_gate, rest_to_centre;  ///< of the best run by the rules
};

/// Those of a contest without errors.
struct SecondsFigures : DriveFigures {
  bool proven = false;  ///< whether no faster route than the known one could exist before the last speed run
};

/// Those of a contest in a world with errors. Counts are of runs from the start, including search runs, unless stated
/// otherwise. Figures that depend on the map have no value for an external controller, whose map is unknown.
struct PhysicalFigures : DriveFigures {
  std::int64_t done = 0;
  std::int64_t slid = 0, position_lost = 0;               ///< crashes by their causes, including those on ways home
  std::optional<std::int64_t> wall_error, no_route_left;  ///< the same
  std::int64_t late = 0;                                  ///< cut short by the end of the time
  std::int64_t carried = 0;                               ///< how often a hand took the mouse to the start
  std::int64_t grazes = 0;
  std::optional<std::int64_t> wrong_walls;  ///< walls classified wrongly
  std::optional<std::int64_t> contradictions;
  double severity = 0.0;                ///< RobotSample::severity(), in standard deviations
  double par1 = 0.0;                    ///< seconds: the score, or without one the time limit
  std::optional<std::string> ended_by;  ///< a name of RunEnd: what ended a contest without a score
};

}  // namespace labmouse
