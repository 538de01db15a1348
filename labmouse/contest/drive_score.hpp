// Scores the record of a contest in seconds by the rules.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"

namespace labmouse {

/// One run that counts, in microseconds.
struct DriveRunScore {
  std::size_t run = 0;  ///< its index in the record
  std::optional<MazeTime> gate_to_gate;
  std::optional<MazeTime> rest_to_centre;
  MazeTime maze_time = 0;  ///< the part of the time in the maze before it that is added
  MazeTime bonus = 0;      ///< subtracted because the mouse was not touched
  MazeTime penalty = 0;    ///< added because it was
  MazeTime value = 0;      ///< the total by the rules

  friend bool operator==(const DriveRunScore&, const DriveRunScore&) = default;
};

struct DriveScore {
  DriveOutcome outcome = DriveOutcome::finished;
  /// Each run that ended in a goal within the time, in order.
  std::vector<DriveRunScore> runs;
  /// Index in `runs` of the best one, the first of equals; none if no run counts.
  std::optional<std::size_t> best;

  /// Value of the best one, in microseconds.
  std::optional<MazeTime> value() const { return best ? std::optional(runs[*best].value) : std::nullopt; }

  friend bool operator==(const DriveScore&, const DriveScore&) = default;
};

/// How many runs began at the start.
int starts_of(const DriveRecord& record);

/// The part of the time in the maze before a run that counts, rounded to a microsecond.
MazeTime maze_time_part(MazeTime before, const DriveRules& rules);

/// Scores a record.
DriveScore score(const DriveRecord& record, const DriveRules& rules);

}  // namespace labmouse
