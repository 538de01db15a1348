// Failure rates made for tests, and contests with them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/failure_rates.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/failure_rates/failure_rates.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/lab/drive/physical_fixture.hpp"

namespace labmouse::test {

/// Under variation 1 as little goes wrong as under none, but for what a test changes.
inline FailureRates harmless() {
  FailureRates failure_rates;
  failure_rates.paces = {{1.0, {no_failures()}}};
  failure_rates.paces.front().variations.front().variation = 1.0;
  return failure_rates;
}

template <class Change>
FailureRates with(Change change) {
  FailureRates failure_rates = harmless();
  for (FailureRatesByBrightness& by_brightness : failure_rates.paces.front().variations.front().by_brightness)
    change(by_brightness);
  return failure_rates;
}

inline ManoeuvreRates& at(FailureRatesByBrightness& failure_rates, Manoeuvre manoeuvre, std::size_t level = 0) {
  return failure_rates.manoeuvres[static_cast<std::size_t>(manoeuvre)][level];
}

inline void wall_error(FailureRatesByBrightness& failure_rates, Reading reading, std::size_t level = 0) {
  for (const std::size_t again : {0U, 4U}) {
    ReadingRates& shares = failure_rates.readings[static_cast<std::size_t>(reading) + again][level];
    shares = {};
    shares[is_of_wall(reading) ? 0 : evidence_classes - 1] = 1.0;
  }
}

inline PhysicalRecord driven(const std::string& mouse, const FailureRates& failure_rates, std::uint64_t seed = 1,
                             const PhysicalConditions& conditions = at_errors(1.0), const Maze& maze = ring()) {
  const auto model = drive_model("kerise");
  const DriveRules rules = find_rules("all-japan").rules;
  Briefing briefing = brief(maze, rules, *model, seed);
  briefing.sight = 1;
  const BuiltinMouse& entry = *find_mouse(mouse);
  const auto strategy = entry.drive(briefing, Settings(entry.parameters));
  return drive_with_failures(maze, rules, *model, conditions, failure_rates, seed, *strategy);
}

/// What stands in the world of seconds.
inline DriveRecord driven_exactly(const std::string& mouse, const Maze& maze) {
  const auto model = drive_model("kerise");
  const DriveRules rules = find_rules("all-japan").rules;
  Briefing briefing = brief(maze, rules, *model, 1);
  briefing.sight = 1;
  const BuiltinMouse& entry = *find_mouse(mouse);
  const auto strategy = entry.drive(briefing, Settings(entry.parameters));
  return drive(maze, rules, *model, *strategy);
}

inline FailureOrder order_of(std::vector<double> variations, int runs) {
  FailureOrder order;
  order.model = drive_model("kerise");
  order.rules = find_rules("all-japan").rules;
  order.variations = std::move(variations);
  order.runs = runs;
  return order;
}

}  // namespace labmouse::test
