// Outcome of an mms program, and the statistics that count.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "labmouse/external/mms/statistics.hpp"

namespace labmouse {

/// How the program ended. Its statistics count, as in mms, unless is_cut_short().
enum class MmsOutcome : std::uint8_t {
  complete,            ///< it ended with exit code 0
  failed,              ///< it ended otherwise; MmsRun::end says how
  waiting,             ///< it waits for Reset, with no presses left
  invalid,             ///< a strict run had an invalid line
  never_ended,         ///< it reached the limit of simulated time, lines or its own time
  hung,                ///< it wrote nothing within the time limit of a decision
  too_many_processes,  ///< it and its descendants were too many
  too_much_memory,     ///< they held too much memory
  too_much_written,    ///< they wrote too much
  flooded,             ///< it wrote a line that is too long, or left too many replies unread
  closed,              ///< it closed its standard output, but kept running
  left,                ///< it ended, but a descendant keeps its output open
  not_started,         ///< it could not be started
  interrupted,         ///< the race was stopped
  not_judged,          ///< the machine was too busy to tell whether it was slow
};

constexpr std::string_view name_of(MmsOutcome outcome) {
  constexpr std::array<std::string_view, 15> names = {
      "complete",           "failed",          "waiting",          "invalid", "never ended", "hung",
      "too many processes", "too much memory", "too much written", "flooded", "closed",      "left",
      "not started",        "interrupted",     "not judged"};
  return names[static_cast<std::size_t>(outcome)];
}

/// The outcome of a name; nullopt if there is none. Records of earlier versions have two names for never_ended:
/// "endless" and "out of time".
std::optional<MmsOutcome> mms_outcome_of(std::string_view name);

/// Whether it was ended because of resource limits or a busy machine, so that it has no score.
constexpr bool is_cut_short(MmsOutcome outcome) {
  return (outcome >= MmsOutcome::too_many_processes && outcome <= MmsOutcome::too_much_written) ||
         outcome == MmsOutcome::not_judged;
}

/// The statistics that count. For a mouse that never ended, those at the end of its best run, because later values
/// depend on the limit that ended it.
const MmsStatistics& counted_statistics(const MmsLedger& ledger, MmsOutcome outcome);

}  // namespace labmouse
