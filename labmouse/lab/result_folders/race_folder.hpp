// The records and pictures that a race leaves behind.
#pragma once

#include <string>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/races/race_paths.hpp"

namespace labmouse {

/// A folder that takes the contests of one race: the record of each, and for the first run a picture; RacePaths has
/// where.
class RaceFolder {
 public:
  RaceFolder(std::string folder, const Race& race);

  /// What it has room for of a contest.
  static Keep keep(const ContestResult& contest) { return {true, contest.run == 0}; }

  /// Saves a contest of the race. Returns what went wrong, or nothing.
  std::string save(const ContestResult& contest, const ContestOutput& held) const;

 private:
  RacePaths paths_;
};

}  // namespace labmouse
