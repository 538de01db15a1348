// The records that a race of programs written for mms leaves behind.
#pragma once

#include <string>

#include "labmouse/lab/races/mms_race.hpp"
#include "labmouse/lab/races/race_paths.hpp"

namespace labmouse {

/// A folder that takes the record of each run of one race; RacePaths has where.
class MmsRaceFolder {
 public:
  MmsRaceFolder(std::string folder, const MmsRace& race);

  /// Saves the record of a run of the race. Returns what went wrong, or nothing.
  std::string save(const MmsResult& result, const std::string& record) const;

 private:
  RacePaths paths_;
};

}  // namespace labmouse
