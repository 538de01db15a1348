// How well the failure model predicts the physical world: both run the same contests, with the same draws.
#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "labmouse/lab/failure_rates/failure_file.hpp"
#include "labmouse/lab/failure_rates/failure_rates.hpp"
#include "labmouse/lab/numbers/statistics.hpp"

namespace labmouse {

/// A mouse under one variation.
struct Fidelity {
  std::string mouse;
  double variation = 0.0;
  int contests = 0;
  int physical = 0, failures = 0;  ///< of them finished with a score, in each world
  /// By how much the share is larger in the failure model, with its interval over mazes; nothing of one maze alone.
  double difference = 0.0;
  std::optional<Interval> interval;
};

/// Limits, 0 to 1, of the difference between the shares of both worlds, and of the ends of its interval.
struct FidelityBars {
  double difference = 0.03;
  double interval = 0.05;
};

/// Runs all contests of an order in both worlds. Returns the comparison for each mouse under each variation.
std::vector<Fidelity> compare_worlds(const FailureOrder& order, const FailureFile& failure_rates,
                                     std::span<const Contestant> mice, std::span<const NamedMaze> mazes,
                                     const std::atomic<bool>* stop = nullptr);

bool is_faithful(const Fidelity& fidelity, const FidelityBars& bars);
std::string table_of(std::span<const Fidelity> all, const FidelityBars& bars);

}  // namespace labmouse
