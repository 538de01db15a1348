// A record of one program that was written for mms, played again without the program.
#pragma once

#include <string>

#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/records/mms_record_file.hpp"
#include "labmouse/lab/replays/mms_walk.hpp"

namespace labmouse {

struct MmsReplay {
  /// The run as `labmouse mms` gave it: its end from the record, place and drawing from the replay. `interrupted` where
  /// the record breaks off.
  MmsRun run;
  MmsWalk walk{HalfPose()};
  std::string disagreement;  ///< where the record could not have happened in its maze; empty where it could
};

/// Gives the lines of a record to the simulator again.
MmsReplay replay_of(const MmsRecordFile& file);

}  // namespace labmouse
