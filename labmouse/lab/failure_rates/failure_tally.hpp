// Counts of failures, by manoeuvre and by wall reading.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/contest/failure_rates.hpp"
#include "labmouse/contest/manoeuvre.hpp"

namespace labmouse {

/// Manoeuvres of one kind that began at the same level of localization error.
struct ManoeuvreCount {
  std::int64_t times = 0;
  std::int64_t crashes = 0;  ///< without those into a wall that was read as open, which no manoeuvre causes
  std::int64_t slid = 0;     ///< of these, where the tyres did not hold
  std::array<std::int64_t, position_error_levels>
      after{};  ///< by level of localization error at the end, without crashes

  ManoeuvreCount& operator+=(const ManoeuvreCount& other);
  friend bool operator==(const ManoeuvreCount&, const ManoeuvreCount&) = default;
};

/// Readings of inner walls, by their evidence.
struct ReadingCount {
  std::array<std::int64_t, evidence_classes> by_evidence{};

  ReadingCount& operator+=(const ReadingCount& other);
  std::int64_t times() const;
  /// Readings without evidence, which are neither right nor wrong.
  std::int64_t silent() const { return by_evidence[most_nats_told]; }
  std::int64_t wrong(Reading reading) const;
  friend bool operator==(const ReadingCount&, const ReadingCount&) = default;
};

/// What was counted in some contests.
struct FailureCounts {
  std::int64_t contests = 0;
  std::int64_t finished = 0;  ///< with a score
  std::array<std::int64_t, position_error_levels>
      put{};  ///< by level of localization error after placement at the start by hand
  std::array<std::array<ManoeuvreCount, position_error_levels>, all_manoeuvres.size()> manoeuvres{};
  std::array<std::array<ReadingCount, position_error_levels>, all_readings.size()> readings{};

  FailureCounts& operator+=(const FailureCounts& other);
  /// of(): one kind of manoeuvre, at all levels of localization error. at(): all kinds, at one level.
  ManoeuvreCount of(Manoeuvre manoeuvre) const;
  ManoeuvreCount at(std::size_t level) const;
  friend bool operator==(const FailureCounts&, const FailureCounts&) = default;
};

/// All counts under one variation at one pace, by class of brightness: contests and their manoeuvres by the mean of
/// the contest, readings by that of the wall.
struct FailureTally {
  double variation = 0.0;
  double pace = 1.0;  ///< share of the robot's usual pace at which mice drove
  std::array<FailureCounts, brightness_classes> by_brightness{};

  FailureTally& operator+=(const FailureTally& other);
  FailureCounts all() const;
  friend bool operator==(const FailureTally&, const FailureTally&) = default;
};

}  // namespace labmouse
