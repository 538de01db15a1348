// Runs a program written for mms without mms.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "labmouse/external/launch.hpp"
#include "labmouse/external/mms/host.hpp"
#include "labmouse/external/mms/outcome.hpp"

namespace labmouse {

/// One run of one program in one maze.
struct MmsRun {
  MmsOutcome outcome = MmsOutcome::complete;
  std::string end;           ///< how it ended, as text: "exit code 1", "signal 11 (Segmentation fault)", ...
  MmsStatistics statistics;  ///< counted_statistics()
  HalfPose pose;             ///< at the end
  MmsCanvas canvas;          ///< at the end
  double clock = 0;          ///< simulated seconds
  std::int64_t lines = 0;
  std::int64_t invalid_lines = 0;
  std::vector<std::string> log;  ///< problems of the first of them
  std::string errors;            ///< the last bytes of its standard error
  double seconds = 0;            ///< of real time
};

/// Whether the run has a score: it finished a run, and was not cut short.
inline bool is_scored(const MmsRun& run) { return run.statistics.finished && !is_cut_short(run.outcome); }

/// Starts the program, and answers it until it ends or has to be ended. `listener` may be empty; its time is not
/// counted in `seconds`.
MmsRun run_mms(const Launch& launch, const Maze& maze, const MmsOptions& options,
               const std::function<void(const MmsEvent&, const MmsHost&)>& listener = {});

}  // namespace labmouse
