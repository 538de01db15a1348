// The records that a race of programs written for mms leaves behind.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/mms_race.hpp"

namespace labmouse {

/// A folder that takes the runs of one race: the record of each as FOLDER/MOUSE/MAZE.jsonl, with the names that
/// RaceFolder gives.
class MmsRaceFolder {
 public:
  MmsRaceFolder(std::string folder, const MmsRace& race);

  /// Saves the record of a run of the race. Returns what went wrong, or nothing.
  std::string save(const MmsResult& result, const std::string& record) const;

 private:
  std::string folder_;
  std::vector<std::string> mouse_names_;
  std::vector<std::string> maze_names_;
};

}  // namespace labmouse
