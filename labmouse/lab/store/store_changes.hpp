// Merges stores, and deletes contests from one.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/store/merging.hpp"
#include "labmouse/lab/store/stored_races.hpp"

namespace labmouse {

/// Whether to check first that the target is not damaged. The check takes longer for a larger target, so callers that
/// merge many small stores in sequence check it once.
enum class TargetCheck { now, done_before };

/// Adds all contests of the stores to the target, which is created if needed. Nothing is changed if two of them have
/// different results for one contest. Different timings are no conflict; the existing ones stay.
Merge merge_stores(const std::vector<std::string>& paths, const std::string& target,
                   TargetCheck check = TargetCheck::now);

/// The number of deleted contests, or an error.
struct Forgotten {
  std::int64_t contests = 0;
  std::string error;
};
/// Deletes the contests that match the filter, and rows that no contest uses any more.
Forgotten forget(const std::string& path, const StoreFilter& filter);

}  // namespace labmouse
