// The statistics of mms, the simulator: what it counts of a mouse, and the score that it makes of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace labmouse {

/// All values of `getStat`. Distances in half steps; mms keeps them as 32-bit floating-point numbers, and so do we.
struct MmsStatistics {
  float total_distance = 0, total_effective_distance = 0, total_turns = 0;
  float current_run_distance = 0, current_run_effective_distance = 0, current_run_turns = 0;
  /// -1 until a run was finished.
  float best_run_distance = -1, best_run_effective_distance = -1, best_run_turns = -1;
  /// 2000 until a run was finished; then best effective distance + best turns + a tenth of the totals.
  float score = 2000;
  bool solved = false;

  friend constexpr bool operator==(const MmsStatistics&, const MmsStatistics&) = default;
};

/// A value of `getStat NAME` as mms replies it (C's %g); nothing where mms has no such name.
std::optional<std::string> statistic_reply(const MmsStatistics& statistics, std::string_view name);

}  // namespace labmouse
