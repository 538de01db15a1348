// How a program for mms ended, and what of it counts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "labmouse/external/mms/statistics.hpp"

namespace labmouse {

/// How the program ended. What it reached counts, as in mms, unless is_cut_short() says otherwise.
enum class MmsOutcome : std::uint8_t {
  complete,            ///< it ended with exit code 0
  failed,              ///< it ended otherwise; the program's end says how
  waiting,             ///< it waits for Reset, and nobody presses
  invalid,             ///< a strict run had a line that mms would not answer
  never_ended,         ///< it took all simulated time, all lines or all of its own time that a run may have
  hung,                ///< it said nothing for longer than a decision may take
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
  constexpr std::array<std::string_view, 15> names = {
      "complete",           "failed",          "waiting",          "invalid", "never ended", "hung",
      "too many processes", "too much memory", "too much written", "flooded", "closed",      "left",
      "not started",        "interrupted",     "not judged"};
  return names[static_cast<std::size_t>(outcome)];
}

/// The outcome under such a name; nothing where there is none. Records of earlier versions have two names for
/// never_ended: "endless" and "out of time".
std::optional<MmsOutcome> mms_outcome_of(std::string_view name);

/// Whether it was ended for what it did to the machine, or for what the machine did to it: it has no score.
constexpr bool is_cut_short(MmsOutcome outcome) {
  return (outcome >= MmsOutcome::too_many_processes && outcome <= MmsOutcome::too_much_written) ||
         outcome == MmsOutcome::not_judged;
}

/// The statistics that count. Those of a mouse that never ended are as they were when its best run was finished: what
/// it did in its loop depends on the limit that ended it.
const MmsStatistics& counted_statistics(const MmsLedger& ledger, MmsOutcome outcome);

}  // namespace labmouse
