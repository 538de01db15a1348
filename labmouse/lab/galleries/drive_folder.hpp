// The records and pictures that a race in seconds leaves behind.
#pragma once

#include <string>

#include "labmouse/lab/races/drive_race.hpp"
#include "labmouse/lab/races/race_paths.hpp"

namespace labmouse {

/// A folder that takes the record of each contest of one race, and of the first in each maze a picture; RacePaths has
/// where.
class DriveRaceFolder {
 public:
  DriveRaceFolder(std::string folder, const DriveRace& race);

  /// Saves a contest of the race. Returns what went wrong, or nothing.
  std::string save(const DriveRace& race, const DriveResult& result, const DriveRecord& record) const;

 private:
  RacePaths paths_;
};

}  // namespace labmouse
