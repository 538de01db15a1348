#include "labmouse/contest/simulator.hpp"

#include <algorithm>
#include <utility>

namespace labmouse {
namespace {

std::vector<Count> counts_of(std::span<const Counter> counters) {
  std::vector<Count> counts;
  for (const Counter& counter : counters) counts.push_back({std::string(counter.name), counter.value});
  std::sort(counts.begin(), counts.end(), [](const Count& a, const Count& b) { return a.name < b.name; });
  return counts;
}

}  // namespace

Briefing brief(const Maze& maze, const Rules& rules, std::uint64_t seed) {
  return {maze.size(), {maze.start(), maze.start_heading()}, maze.goals(), strides(rules.stride), rules.budget, seed};
}

RunRecord run(const Maze& maze, const Rules& rules, Strategy& mouse) {
  Contest contest(maze, rules);
  std::vector<StepReasons> kept;
  while (!contest.ended()) {
    contest.act(mouse.decide(contest.sighting()));
    if (const Reasons* reasons = mouse.reasons()) kept.push_back({contest.record().steps.back().step, *reasons});
  }
  RunRecord record = contest.take_record();
  const StrategyReport report = mouse.report();
  record.counts = counts_of(report.counters);
  record.last_words = report.last_words;
  record.reasons = std::move(kept);
  return record;
}

}  // namespace labmouse
