// What a contest in seconds is worth by its rules: a function of its record.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"

namespace labmouse {

/// One run that counts, in microseconds.
struct DriveRunScore {
  std::size_t run = 0;  ///< its place in the record
  std::optional<MazeTime> gate_to_gate;
  std::optional<MazeTime> rest_to_centre;
  MazeTime maze_time = 0;  ///< its part of the time in the maze before it, as it counts
  MazeTime bonus = 0;      ///< what is taken off because the mouse was not touched
  MazeTime penalty = 0;    ///< what is added because it was
  MazeTime value = 0;      ///< all together, by the rules

  friend bool operator==(const DriveRunScore&, const DriveRunScore&) = default;
};

struct DriveScore {
  DriveOutcome outcome = DriveOutcome::finished;
  /// Of each run that ended in a goal within the time, by its place.
  std::vector<DriveRunScore> runs;
  /// The place of the best of them, the first of equals; nothing where none counts.
  std::optional<std::size_t> best;

  /// Microseconds of the best one.
  std::optional<MazeTime> value() const { return best ? std::optional(runs[*best].value) : std::nullopt; }

  friend bool operator==(const DriveScore&, const DriveScore&) = default;
};

/// How many runs began at the start.
int starts_of(const DriveRecord& record);

/// The part of a time in the maze that counts with a run, to the nearest microsecond.
MazeTime maze_time_part(MazeTime before, const DriveRules& rules);

/// Scores a record.
DriveScore score(const DriveRecord& record, const DriveRules& rules);

}  // namespace labmouse
