// What changes a store besides races: merging others into it, and forgetting.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/store/merging.hpp"
#include "labmouse/lab/store/stored_races.hpp"

namespace labmouse {

/// Whether a merge looks first whether its target is damaged, which takes as long as the target is large. Who merges
/// many small stores into one, one after the other, checks it once himself.
enum class TargetCheck { now, done_before };

/// Adds all contests of the stores to the target, which is made where there is none: all of them, or nothing where one
/// contest has another result in two of them. Timings do not count for that; those that are there first stay.
Merge merge_stores(const std::vector<std::string>& paths, const std::string& target,
                   TargetCheck check = TargetCheck::now);

/// Removes the contests that the filter means, and what then belongs to none.
struct Forgotten {
  std::int64_t contests = 0;
  std::string error;
};
Forgotten forget(const std::string& path, const StoreFilter& filter);

}  // namespace labmouse
