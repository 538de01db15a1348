// Scores the record of a contest in seconds by the rules.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"

namespace labmouse {

/// One run that counts, in microseconds. A run of laps has the score of its fastest lap. If dead ends count, the value
/// is in millionths of a mark.
struct DriveRunScore {
  std::size_t run = 0;  ///< its index in the record
  int lap = 0;          ///< number of the lap in the run, from 1; 0 where runs count
  std::optional<MazeTime> gate_to_gate;
  std::optional<MazeTime> rest_to_centre;
  MazeTime maze_time = 0;  ///< the part of the time in the maze before it that is added
  MazeTime bonus = 0;      ///< subtracted because the mouse was not touched
  MazeTime penalty = 0;    ///< added because it was
  MazeTime value = 0;      ///< the total by the rules; lower is better

  friend bool operator==(const DriveRunScore&, const DriveRunScore&) = default;
};

/// The score of a contest: that of its best run.
struct DriveScore {
  DriveOutcome outcome = DriveOutcome::finished;
  /// Each run that ended in a goal, or completed a lap, within the time, in order.
  std::vector<DriveRunScore> runs;
  /// Index in `runs` of the best one, the first of equals; none if no run counts.
  std::optional<std::size_t> best;

  /// Value of the best one.
  std::optional<MazeTime> value() const { return best ? std::optional(runs[*best].value) : std::nullopt; }

  friend bool operator==(const DriveScore&, const DriveScore&) = default;
};

/// A lap of a run, from gate to gate.
struct LapTime {
  MazeTime time = 0;
  int number = 0;  ///< in its run, from 1
};

/// The fastest lap of a run.
/// @param run a run of laps; others have none.
/// @param until laps that ended later do not count, in microseconds since the first start.
/// @return the first of equals; nothing if there is none.
std::optional<LapTime> fastest_lap(const DriveRun& run, MazeTime until);

/// The number of runs that began at the start: all but the ways home.
/// @param record of a contest in seconds.
int starts_of(const DriveRecord& record);

/// The part of the time in the maze before a run that is added to its score.
/// @param before from the first start to the beginning of the run, in microseconds.
/// @param rules which part of it counts.
/// @return rounded to a microsecond; 0 where the rules do not count it.
MazeTime maze_time_part(MazeTime before, const DriveRules& rules);

/// What a search loses of full marks. It keeps full marks × (dead ends seen / all) × (fewest steps / steps).
/// @param count the dead ends and the steps of the search.
/// @param rules their `marks` are the full marks.
/// @return in millionths of a mark, rounded; all marks if the maze has no dead end.
std::int64_t marks_lost(const DeadEndCount& count, const DriveRules& rules);

/// Scores a record by the rules.
/// @param record of a contest in seconds, of any of its worlds.
/// @param rules those of the contest, or others.
/// @return in microseconds, or in millionths of a mark if dead ends count.
DriveScore score(const DriveRecord& record, const DriveRules& rules);

}  // namespace labmouse
