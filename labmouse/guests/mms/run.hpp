// One program that was written for mms, hosted without mms.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/guests/launch.hpp"
#include "labmouse/guests/mms/host.hpp"

namespace labmouse {

/// How the program ended. Its score counts, as in mms, unless it was stopped by a limit of time.
enum class MmsOutcome : std::uint8_t {
  complete,            ///< it ended with exit code 0
  failed,              ///< it ended otherwise; the program's end says how
  waiting,             ///< it waits for Reset, and nobody presses
  invalid,             ///< a strict run had a line that mms would not answer
  endless,             ///< it took all simulated time or lines that a run may have
  hung,                ///< it said nothing for longer than a decision may take
  out_of_time,         ///< the contest took too long
  too_many_processes,  ///< it and what it started were too many
  too_much_memory,     ///< they held too much memory
  too_much_written,    ///< they wrote too much
  flooded,             ///< it wrote a line that is too long, or left too many replies unread
  closed,              ///< it closed its standard output and ran on
  left,                ///< it ended, and what it started holds its output open
  not_started,         ///< it could not be started
  interrupted,         ///< the race was stopped
  not_judged,          ///< the machine was too busy to tell whether it was slow
};

constexpr std::string_view name_of(MmsOutcome outcome) {
  constexpr std::array<std::string_view, 16> names = {
      "complete",           "failed",          "waiting",          "invalid", "endless", "hung", "out of time",
      "too many processes", "too much memory", "too much written", "flooded", "closed",  "left", "not started",
      "interrupted",        "not judged"};
  return names[static_cast<std::size_t>(outcome)];
}

/// Whether a limit ended it that comes at another line with another limit, or on another machine: it has no score.
constexpr bool is_cut_short(MmsOutcome outcome) {
  return (outcome >= MmsOutcome::endless && outcome <= MmsOutcome::too_much_written) ||
         outcome == MmsOutcome::not_judged;
}

/// One run of one program in one maze.
struct MmsRun {
  MmsOutcome outcome = MmsOutcome::complete;
  std::string end;  ///< how it ended, in words: "exit code 1", "signal 11 (Segmentation fault)", ...
  MmsStatistics statistics;
  HalfPose pose;     ///< at the end
  MmsCanvas canvas;  ///< at the end
  double clock = 0;  ///< simulated seconds
  std::int64_t lines = 0;
  std::int64_t invalid_lines = 0;
  std::vector<std::string> log;  ///< what was wrong with the first of them
  std::string errors;            ///< the last bytes of its standard error
  double seconds = 0;            ///< of real time
};

/// Whether the run has a score: it finished a run, and no limit of time ended it.
inline bool is_scored(const MmsRun& run) { return run.statistics.solved && !is_cut_short(run.outcome); }

/// Starts the program and hosts it until it ends or has to be ended. `listener` may be empty; the time that it takes is
/// not the program's.
MmsRun run_mms(const Launch& launch, const Maze& maze, const MmsOptions& options,
               const std::function<void(const MmsEvent&, const MmsHost&)>& listener = {});

}  // namespace labmouse
