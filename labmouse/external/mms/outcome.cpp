#include "labmouse/external/mms/outcome.hpp"

namespace labmouse {

std::optional<MmsOutcome> mms_outcome_of(std::string_view name) {
  if (name == "endless" || name == "out of time") return MmsOutcome::never_ended;
  for (auto i = static_cast<int>(MmsOutcome::complete); i <= static_cast<int>(MmsOutcome::not_judged); ++i)
    if (const auto outcome = static_cast<MmsOutcome>(i); name_of(outcome) == name) return outcome;
  return std::nullopt;
}

const MmsStatistics& counted_statistics(const MmsLedger& ledger, MmsOutcome outcome) {
  return outcome == MmsOutcome::never_ended ? ledger.at_best_run() : ledger.statistics();
}

}  // namespace labmouse
