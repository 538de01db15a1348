// Saves the records and pictures of a race.
#pragma once

#include <string>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/races/race_paths.hpp"

namespace labmouse {

/// A folder with the record of each contest of a race, and a picture of each mouse's first run in a maze. RacePaths
/// gives the paths.
class RaceFolder {
 public:
  RaceFolder(std::string folder, const Race& race);

  /// What to save of a contest.
  static Keep keep(const ContestResult& contest) { return {true, contest.run == 0}; }

  /// Saves a contest of the race. Returns what went wrong, or nothing.
  std::string save(const ContestResult& contest, const ContestOutput& held) const;

 private:
  RacePaths paths_;
};

}  // namespace labmouse
