// The world in seconds: a robot with curves and diagonals, by the rules of real contests, on one clock.
#pragma once

#include <memory>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Contests of this robot (without an error) under these rules. Scores are seconds; of what it holds, Held::run is a
/// DriveRecord.
std::shared_ptr<const World> seconds_world(const DriveRules& rules, std::shared_ptr<const DriveModel> model);

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
  score_us,  ///< of the best run by the rules, and its two times
  gate_to_gate,
  rest_to_centre,
};

/// The figures of a maze, in microseconds, null where there is none.
enum class SecondsMazeFigure : std::uint8_t { fastest, bound };

/// The record of a contest as a file.
DriveRecordFile drive_record_file_of(const Contestant& mouse, const NamedMaze& maze, const DriveRules& rules,
                                     std::shared_ptr<const DriveModel> model, std::uint64_t seed, DriveRecord record);

/// How rules score, in words.
std::string formula_of(const DriveRules& rules);

}  // namespace labmouse
