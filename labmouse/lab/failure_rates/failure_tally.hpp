// Counts of what went wrong, and at what.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/contest/failure_rates.hpp"
#include "labmouse/contest/manoeuvre.hpp"

namespace labmouse {

/// Manoeuvres of one kind that began with the mouse as far off its believed position.
struct ManoeuvreCount {
  std::int64_t times = 0;
  std::int64_t crashes = 0;  ///< but for those into a wall that was taken for a gap, which no manoeuvre is to blame for
  std::int64_t slid = 0;     ///< of these, where the tyres did not hold
  std::array<std::int64_t, position_error_levels> after{};  ///< how far it was lost at the end of those without a crash

  ManoeuvreCount& operator+=(const ManoeuvreCount& other);
  friend bool operator==(const ManoeuvreCount&, const ManoeuvreCount&) = default;
};

/// Readings of inner walls, by their evidence.
struct ReadingCount {
  std::array<std::int64_t, evidence_classes> by_evidence{};

  ReadingCount& operator+=(const ReadingCount& other);
  std::int64_t times() const;
  /// Those that say nothing are neither right nor wrong.
  std::int64_t silent() const { return by_evidence[most_nats_told]; }
  std::int64_t wrong(Reading reading) const;
  friend bool operator==(const ReadingCount&, const ReadingCount&) = default;
};

/// What was counted in some contests.
struct FailureCounts {
  std::int64_t contests = 0;
  std::int64_t finished = 0;                              ///< with a score
  std::array<std::int64_t, position_error_levels> put{};  ///< how far mice were lost that a hand had put at the start
  std::array<std::array<ManoeuvreCount, position_error_levels>, all_manoeuvres.size()> manoeuvres{};
  std::array<std::array<ReadingCount, position_error_levels>, all_readings.size()> readings{};

  FailureCounts& operator+=(const FailureCounts& other);
  /// Of manoeuvres of that kind, however far off its believed position; of all kinds that far off its believed
  /// position.
  ManoeuvreCount of(Manoeuvre manoeuvre) const;
  ManoeuvreCount at(std::size_t level) const;
  friend bool operator==(const FailureCounts&, const FailureCounts&) = default;
};

/// All that was counted under one noise at one pace, by what the draws of a contest made of the mouse.
struct FailureTally {
  double noise = 0.0;
  double pace = 1.0;  ///< the part of the usual pace at which mice were driven
  std::array<FailureCounts, draw_classes> by_draws{};

  FailureTally& operator+=(const FailureTally& other);
  FailureCounts all() const;
  friend bool operator==(const FailureTally&, const FailureTally&) = default;
};

}  // namespace labmouse
