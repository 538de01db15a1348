// Counts of what went wrong, and at what.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/contest/hazards.hpp"
#include "labmouse/contest/manoeuvre.hpp"

namespace labmouse {

/// Manoeuvres of one kind that began with the mouse as far astray.
struct ManoeuvreCount {
  std::int64_t times = 0;
  std::int64_t crashes = 0;  ///< but for those into a wall that was taken for a gap, which no manoeuvre is to blame for
  std::int64_t slid = 0;     ///< of these, where the tyres did not hold
  std::array<std::int64_t, astray_levels> after{};  ///< how far it was astray at the end of those without a crash

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
struct HazardCounts {
  std::int64_t contests = 0;
  std::int64_t finished = 0;                      ///< with a score
  std::array<std::int64_t, astray_levels> put{};  ///< how far mice were astray that a hand had put at the start
  std::array<std::array<ManoeuvreCount, astray_levels>, all_manoeuvres.size()> manoeuvres{};
  std::array<std::array<ReadingCount, astray_levels>, all_readings.size()> readings{};

  HazardCounts& operator+=(const HazardCounts& other);
  /// Of manoeuvres of that kind, however far astray; of all kinds that far astray.
  ManoeuvreCount of(Manoeuvre manoeuvre) const;
  ManoeuvreCount at(std::size_t level) const;
  friend bool operator==(const HazardCounts&, const HazardCounts&) = default;
};

/// All that was counted under one noise at one pace, by what the draws of a contest made of the mouse.
struct HazardTally {
  double noise = 0.0;
  double pace = 1.0;  ///< the part of the usual pace at which mice were driven
  std::array<HazardCounts, luck_classes> by_luck{};

  HazardTally& operator+=(const HazardTally& other);
  HazardCounts all() const;
  friend bool operator==(const HazardTally&, const HazardTally&) = default;
};

}  // namespace labmouse
