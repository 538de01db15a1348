// A contest in which readings of walls mean nothing: what a strategy believes turns over at every step.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/failure_rates.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse::test {

struct WildContest {
  std::uint64_t seed = 1;
  std::size_t strategy = 0;  ///< of wild_strategies
  int side = 6;              ///< of the maze, in cells
  int loops = 100;           ///< thousandths
  double wild = 0.5;         ///< the share of readings that any wall may have given
  double crash = 0.02;       ///< of manoeuvres
};

inline constexpr std::array<std::string_view, 5> wild_strategies = {"flood", "flood-return", "certify", "ariadne",
                                                                    "festina"};
inline constexpr MazeTime wild_time = 20'000'000;
/// A move takes a twentieth of a second at least; what is more is a strategy that goes round and round.
inline constexpr int most_decisions = 20 * (wild_time / 1'000'000);

/// As many readings as that are of any evidence, the others right and sure.
inline FailureRates wild_rates(double wild, double crash) {
  RatesAtVariation rates = no_failures();
  rates.variation = 1.0;
  for (FailureRatesByBrightness& some : rates.by_brightness) {
    for (auto& levels : some.readings)
      for (ReadingRates& shares : levels)
        for (double& share : shares) share = (1.0 - wild) * share + wild / static_cast<double>(evidence_classes);
    for (auto& levels : some.manoeuvres)
      for (ManoeuvreRates& failure : levels) failure.crash = crash;
  }
  FailureRates failure_rates;
  failure_rates.paces = {{1.0, {rates}}};
  return failure_rates;
}

inline PhysicalRecord held(const WildContest& contest) {
  static const DriveModel model = [] {
    DriveModel kerise = find_robot("kerise").model;
    share_route_tables(kerise);
    return kerise;
  }();
  DriveRules rules = find_rules("all-japan").rules;
  rules.time_limit = wild_time;
  const Maze maze =
      depth_first_generator.make({{contest.side, contest.side}, seed_for(contest.seed, "maze"), contest.loops});
  PhysicalConditions conditions;
  conditions.map = contest.seed % 2 == 0 ? MapKind::log_odds : MapKind::learned;
  Briefing briefing = brief(maze, rules, model, contest.seed);
  briefing.sight = 1;
  const BuiltinMouse& entry = *find_mouse(wild_strategies[contest.strategy % wild_strategies.size()]);
  const auto strategy = entry.drive(briefing, Settings(entry.parameters));
  return drive_with_failures(maze, rules, model, conditions, wild_rates(contest.wild, contest.crash), contest.seed,
                             *strategy);
}

/// Whether the contest came to an end that is no fault of the strategy: with a score, or by the time or the rules.
inline bool came_to_its_end(const PhysicalRecord& record) {
  const bool in_time = record.drive.runs.empty() || record.drive.runs.back().end <= wild_time;
  return record.drive.outcome != DriveOutcome::forfeit && in_time;
}

}  // namespace labmouse::test
